// SPDX-License-Identifier: BSD-3-Clause
// Made by scripts/generate-bindings: do not edit.
use super::*;

rows! {
    /// A warning.
    #[non_exhaustive]
    Warning: stltsa_warning [Warning] {
        /// [`WarningKind`].
        code: WarningKind = From::from,
        /// What it is about, and what to do.
        text: String = text,
        /// Seconds in the clip at which it applies; `None`: it has no time.
        begin_s: Option<f64> = number,
        /// The end, or the begin of a moment; `None`: it has no time.
        end_s: Option<f64> = number,
    }
    /// A joint or an end site of a skeleton.
    Joint: stltsa_joint [Joint] {
        /// Not empty.
        name: String = text,
        /// Index of an earlier joint; `None`: the root, which is joint 0.
        parent: Option<usize> = index,
        /// From the parent, in the parent's axes; unit of the clip.
        offset: [f64; 3] = From::from,
        /// Its values in each frame, in order: tx ty tz positions, which replace the offset (+tx
        /// +ty +tz add to it), rx ry rz angles in degrees about moving axes, of which the first is
        /// the leftmost matrix. "": none. `None`, as input: rz rx ry, for the root after tx ty tz,
        /// none for end sites; as output: those of an ASF file, which this cannot describe.
        channels: Option<String> = nullable,
        /// The end of a chain, without rotation.
        is_end_site: bool = flag,
    }
    /// Something that the file says happens, such as a foot strike in C3D.
    #[non_exhaustive]
    FileEvent: stltsa_file_event [FileEvent] {
        /// "Foot Strike".
        label: String = text,
        /// What it happens to, such as "Left"; may be `None`.
        context: Option<String> = filled,
        /// Of the clip, not rounded; may lie outside it.
        frame: f64 = From::from,
        /// From the first frame of the clip; `None` if the rate is unknown.
        seconds: Option<f64> = number,
    }
    /// A connected component of the neighborhood graph of a fit.
    #[derive(Copy)]
    #[non_exhaustive]
    Component: stltsa_component [Component] {
        /// Distinct rows.
        frames: usize = count,
        /// Largest ||B u - lambda u|| / k.
        residual: f64 = From::from,
        /// Estimate of the largest principal angle to the exact embedding.
        error_estimate_rad: f64 = From::from,
        /// Lambda_{d+2} / lambda_{d+1}; near 1: the curve is ill-defined.
        gap: f64 = From::from,
        /// Windows of fewer than d directions.
        rank_deficient_windows: usize = count,
        /// Applications of the inverse operator by ARPACK.
        solves: usize = count,
    }
    /// A unit, [begin, end) as in `stltsa_interval`.
    #[derive(Copy)]
    #[non_exhaustive]
    Unit: stltsa_unit [Unit] {
        /// [`UnitKind`].
        kind: UnitKind = From::from,
        /// Index of its segment.
        segment: usize = count,
        /// Frames, rounded.
        begin: usize = count,
        /// Frames, rounded.
        end: usize = count,
        /// Seconds, with fractions of a frame.
        begin_s: f64 = From::from,
        /// Seconds, with fractions of a frame.
        end_s: f64 = From::from,
    }
    /// A stretch of one behavior, [begin, end) as in `stltsa_interval`.
    #[non_exhaustive]
    Segment: stltsa_segment [Segment] {
        /// [`SegmentKind`].
        kind: SegmentKind = From::from,
        /// 0, 1, ... in order of appearance; `None`: a rest.
        label: Option<usize> = index,
        /// The label as it is shown: A, B, ... Z, AA, ...; `None` for a rest.
        letters: Option<String> = filled,
        /// Mean likeness to the others of its label, 0 to 1; `None`: none.
        likeness: Option<f64> = number,
        /// Frames, rounded.
        begin: usize = count,
        /// Frames, rounded.
        end: usize = count,
        /// Seconds, with fractions of a frame.
        begin_s: f64 = From::from,
        /// Seconds, with fractions of a frame.
        end_s: f64 = From::from,
        /// Median length of the cycles; `None`: not cyclic.
        period_s: Option<f64> = number,
        /// A period that was seen but is not claimed; `None`: none.
        candidate_period_s: Option<f64> = number,
        /// Cycles or repetitions; 1 for an action, 0 for a rest.
        count: usize = count,
        /// Names of the joints, markers or columns that carry half of the motion, those that move
        /// most first.
        carried_by: Vec<String> = texts,
        /// The clip begins, or ends, within this motion.
        open_begin: bool = flag,
        /// The clip begins, or ends, within this motion.
        open_end: bool = flag,
        /// Share of such answers that are right, 0 to 1.
        confidence: f64 = From::from,
        /// The same of the border at its begin; `None` for the first.
        begin_confidence: Option<f64> = number,
        /// Why it has no cycles, with the numbers; `None` if it has. Of a rest: "nothing recorded"
        /// if most of the body is missing.
        reason: Option<String> = filled,
        /// Share of a cycle that the first step takes; exactly 0.5 if the estimate cannot be told
        /// from it; `None`: no steps.
        first_step_share: Option<f64> = number,
        /// Half of its 95 % interval; `None`: no steps, or under three cycles.
        first_step_margin: Option<f64> = number,
        /// Why its cycles have no steps; `None` if they have, or no cycles.
        steps_reason: Option<String> = filled,
    }
    /// A cycle, a step or a repetition, [begin, end) as in `stltsa_interval`, and how the body (its
    /// root, or the mean of points) travels over the ground meanwhile.
    #[non_exhaustive]
    Part: stltsa_part [Cycle, Step, Repetition] {
        /// Index of its segment.
        segment: usize = count,
        /// Of a step, index of its cycle; else `None`.
        cycle: Option<usize> = index,
        /// Of its segment.
        label: usize = count,
        /// Of its segment.
        letters: String = text,
        /// Frames, rounded.
        begin: usize = count,
        /// Frames, rounded.
        end: usize = count,
        /// Seconds, with fractions of a frame.
        begin_s: f64 = From::from,
        /// Seconds, with fractions of a frame.
        end_s: f64 = From::from,
        /// Which side of the body leads: 0 or 1, the same in all clips of a skeleton, by the file's
        /// foot strikes if it has any; `None`: unknown.
        side: Option<usize> = index,
        /// "left" or "right"; `None` if no names tell.
        side_name: Option<String> = filled,
        /// How like the others of its segment, 0 to 1; `None`: unknown.
        likeness: Option<f64> = number,
        /// Share of such answers that are right, 0 to 1.
        confidence: f64 = From::from,
        /// In the unit of the file, as the next two; `None`: unknown.
        path_length: Option<f64> = number,
        /// Distance between the ends of the path; `None`: unknown.
        stride: Option<f64> = number,
        /// Path length / second; `None`: unknown.
        speed: Option<f64> = number,
        /// Degrees, counterclockwise as seen from above; `None`: unknown.
        turn_deg: Option<f64> = number,
    }
    /// Of one quantity of several parts; all are NaN if count is 0.
    #[derive(Copy)]
    #[non_exhaustive]
    Statistics: stltsa_statistics [] {
        /// Parts.
        count: usize = count,
        /// Mean; standard deviation, 0 for one part.
        mean: f64 = From::from,
        /// Mean; standard deviation, 0 for one part.
        sd: f64 = From::from,
        /// Sd / mean; `None` of turns.
        cv: Option<f64> = number,
        /// Relative change per minute; `None` of turns.
        trend: Option<f64> = number,
    }
    /// Of the cycles or repetitions of one label.
    #[non_exhaustive]
    Summary: stltsa_summary [Summary] {
        /// Of the segments, 0 for A.
        label: usize = count,
        /// The label as it is shown.
        letters: String = text,
        /// Cycles or repetitions.
        count: usize = count,
        /// 60 / mean cycle time.
        cycles_per_min: f64 = From::from,
        /// Lengths of the cycles.
        cycle_time_s: Statistics = Statistics::of,
        /// `None` without steps.
        steps_per_min: Option<f64> = number,
        /// Lengths of the steps.
        step_time_s: Statistics = Statistics::of,
        /// Means of each side; `None` without steps.
        step_time_side_0_s: Option<f64> = number,
        /// Means of each side; `None` without steps.
        step_time_side_1_s: Option<f64> = number,
        /// Of the cycles: see [`Part`].
        path_length: Statistics = Statistics::of,
        /// Of the cycles: see [`Part`].
        stride: Statistics = Statistics::of,
        /// Of the cycles: see [`Part`].
        speed: Statistics = Statistics::of,
        /// Of the cycles: see [`Part`].
        turn_deg: Statistics = Statistics::of,
    }
    /// A moment that was found, or a mark of the caller.
    #[derive(Copy)]
    #[non_exhaustive]
    Event: stltsa_event [Event] {
        /// Of the file, not rounded.
        frame: f64 = From::from,
        /// Its time.
        seconds: f64 = From::from,
        /// Index among the cycles of the clip; `None`: outside cycles.
        cycle: Option<usize> = index,
        /// 0 to 1: ranks the events by the size of their likely errors.
        confidence: f64 = From::from,
        /// A mark of the caller, as it was given.
        marked: bool = flag,
    }
    /// A quantity of both mean cycles and its difference, with a 95 % confidence interval from the
    /// spread between cycles: how well the mean of these cycles is known (docs/answers.md). Of 20
    /// differences that are really zero, about one is significant by chance. Unknown values are
    /// NaN.
    #[derive(Copy)]
    #[non_exhaustive]
    Estimate: stltsa_estimate [] {
        /// Of the first motion: value, standard deviation between cycles.
        first: f64 = From::from,
        /// Of the first motion: value, standard deviation between cycles.
        first_sd: f64 = From::from,
        /// The same of the second.
        second: f64 = From::from,
        /// The same of the second.
        second_sd: f64 = From::from,
        /// Second minus first.
        difference: f64 = From::from,
        /// Of the difference.
        standard_error: f64 = From::from,
        /// Its confidence interval.
        low: f64 = From::from,
        /// Its confidence interval.
        high: f64 = From::from,
        /// The interval excludes 0, by more than rounding.
        significant: bool = flag,
    }
    /// An estimate without its parts.
    #[derive(Copy)]
    #[non_exhaustive]
    Bounded: stltsa_bounded [] {
        /// What is estimated.
        value: f64 = From::from,
        /// Its 95 % confidence interval.
        low: f64 = From::from,
        /// Its 95 % confidence interval.
        high: f64 = From::from,
    }
    /// About a whole comparison.
    #[derive(Copy)]
    #[non_exhaustive]
    Compared: stltsa_compared [Comparison] {
        /// Left against right.
        sides: bool = flag,
        /// [`Features`] that were compared.
        features: Features = From::from,
        /// Of each cycle.
        samples: usize = count,
        /// Phase of the second motion at phase 0 of the first, -0.5 to 0.5.
        shift: f64 = From::from,
        /// Its standard error; `None`: it is half a cycle by definition.
        shift_error: Option<f64> = number,
        /// Its 95 % confidence interval.
        shift_low: f64 = From::from,
        /// Its 95 % confidence interval.
        shift_high: f64 = From::from,
        /// Correlation of the two mean cycles; below 0.6 there is a warning.
        likeness: f64 = From::from,
        /// The same at the next best shift; `None`: there is none.
        runner_up: Option<f64> = number,
        /// Degrees by which the second body was turned about the up axis to face as the first does;
        /// 0 for skeletons with the same joints.
        turn_deg: f64 = From::from,
        /// Size of the second body divided by that of the first; `None`: unknown.
        size_ratio: Option<f64> = number,
        /// Mean length of the cycles.
        cycle_time_s: Estimate = Estimate::of,
        /// Number of lags and amplitudes of parts that have an interval.
        judged: usize = count,
        /// How many of them are significant.
        significant: usize = count,
        /// How many would be if nothing differed.
        expected_by_chance: f64 = From::from,
    }
    /// One of the two motions.
    #[non_exhaustive]
    ComparedMotion: stltsa_compared_motion [Motion] {
        /// Of the clip; `None`: from memory.
        path: Option<String> = filled,
        /// Of the clip.
        frames: usize = count,
        /// Of the clip; `None`: unknown.
        fps: Option<f64> = number,
        /// Of the segments, 0 for A.
        label: usize = count,
        /// The label as it is shown.
        letters: String = text,
        /// Cycles that were compared.
        cycles: usize = count,
        /// 60 / mean cycle time.
        cycles_per_min: f64 = From::from,
        /// Names that the other clip lacks.
        left_out: Vec<String> = texts,
    }
    /// A joint, a point or a column of the file (part), or one of its coordinates (channel).
    /// Lengths and angles are in the unit of the features.
    #[non_exhaustive]
    ComparedPart: stltsa_compared_part [Part, PartChannel] {
        /// Index of the part; of a channel, of the part it belongs to.
        part: usize = count,
        /// Its name in the first motion.
        first: String = text,
        /// Its name in the second; they differ for left and right.
        second: String = text,
        /// Of a channel, such as "x" of a position, "rz" of an angle, "1" to "6" of a rotation
        /// matrix; `None` for the only one of a part, and of parts.
        axis: Option<String> = filled,
        /// Mean over the cycle; NaN for a part with several channels.
        mean: Estimate = Estimate::of,
        /// How much later the second motion does the same, relative to the whole body (left and
        /// right: to half a cycle), as a share of the cycle; first is 0. NaN: the curves are not
        /// alike (correlation below 0.7).
        lag: Estimate = Estimate::of,
        /// The same in seconds, for the mean of both cycle times.
        lag_s: Bounded = Bounded::of,
        /// Of the mean curve: largest distance between two of its points; of one channel, maximum
        /// minus minimum.
        amplitude: Estimate = Estimate::of,
        /// Amplitude of the second divided by that of the first.
        amplitude_ratio: Bounded = Bounded::of,
        /// Root mean square, over the cycle, of second minus first.
        rms_difference: f64 = From::from,
        /// The same, expected from the spread between cycles alone.
        rms_by_chance: f64 = From::from,
        /// Of the two mean curves after the lag is removed.
        correlation: f64 = From::from,
    }
    /// One column of a denoising.
    #[derive(Copy)]
    #[non_exhaustive]
    DenoisedColumn: stltsa_denoised_column [Column] {
        /// Threshold that was used.
        gamma: f64 = From::from,
        /// D_t: mean distance of the points beyond gamma.
        shift: f64 = From::from,
        /// Robust standard deviation of the residuals.
        noise: f64 = From::from,
        /// Noise as a share of the range of the curve.
        noise_share: f64 = From::from,
        /// Effective, of the curve.
        degrees_of_freedom: f64 = From::from,
        /// Points that were moved.
        moved: usize = count,
    }
    /// The place at which one piece is followed by another, or by its own repetition.
    #[derive(Copy)]
    #[non_exhaustive]
    Seam: stltsa_seam [Seam] {
        /// First frame of the later piece; of a wrap, the number of frames.
        frame: usize = count,
        /// Its time.
        time_s: f64 = From::from,
        /// Indices of the pieces that meet.
        piece: usize = count,
        /// Indices of the pieces that meet.
        next: usize = count,
        /// The earlier piece ends before this frame of its clip, as resampled.
        cut_end: usize = count,
        /// The later piece starts at this frame of its clip.
        cut_begin: usize = count,
        /// Frames to each side that are blended; 0: none.
        crossfade: usize = count,
        /// The same in seconds.
        crossfade_s: f64 = From::from,
        /// Distance of postures and velocities at the cuts, divided by the usual distance between
        /// repetitions of the same motion.
        posture: f64 = From::from,
        /// Largest pose step near the seam, divided by the 95th percentile in the pieces; invisible
        /// up to 1.
        step: f64 = From::from,
        /// The same of the second difference.
        acceleration: f64 = From::from,
        /// The wrap of a loop.
        wrap: bool = flag,
    }
    /// What a piece was made of.
    #[non_exhaustive]
    PieceFact: stltsa_piece_fact [Piece] {
        /// Of its clip; `None`: from memory.
        path: Option<String> = filled,
        /// Its frames there, [begin, end).
        begin: usize = count,
        /// Its frames there, [begin, end).
        end: usize = count,
        /// How often it is played.
        repeat: usize = count,
    }
}
