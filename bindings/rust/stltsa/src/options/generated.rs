// SPDX-License-Identifier: BSD-3-Clause
// Made by scripts/generate-bindings: do not edit.
use super::*;

impl Options {
    /// Neighbors of each frame (k); auto: 1.2 periods if a period is found, otherwise 1.2 seconds,
    /// or 12 frames if the rate is unknown.
    #[must_use]
    pub fn neighbors(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_NEIGHBORS, int(value))
    }

    /// Frames on each side in which neighbors may lie (w); auto: as neighbors.
    #[must_use]
    pub fn window(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_WINDOW, int(value))
    }

    /// Tangent dimension, the number of coordinates (d); auto: 2.
    #[must_use]
    pub fn dimension(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_DIMENSION, int(value))
    }

    /// Candidates for neighbors: temporal, frames of the clip within the window; spatial, all
    /// frames; recurrent, frames within the window and, as links, frames outside the exclusion
    /// zone.
    #[must_use]
    pub fn mode(self, value: Mode) -> Self {
        self.with(sys::STLTSA_OPT_MODE, Value::Int(value.raw().into()))
    }

    /// Count a frame among its own neighbors.
    #[must_use]
    pub fn include_self(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_INCLUDE_SELF, Value::Int(value.into()))
    }

    /// Recurrent mode: neighbors from outside the exclusion zone.
    #[must_use]
    pub fn links(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_LINKS, int(value))
    }

    /// Recurrent mode: frames on each side that cannot be links; auto: as window.
    #[must_use]
    pub fn exclusion(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_EXCLUSION, int(value))
    }

    /// Threads; auto: one for each core.
    #[must_use]
    pub fn threads(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_THREADS, int(value))
    }

    /// Description of a pose: positions (of the joints, without root position and yaw),
    /// rotations6d, euler (the file's angles), raw (the file's numbers) or points (such as markers,
    /// three columns each, without path and heading); auto: positions if there is a skeleton,
    /// points if the columns are named so (heel_x, heel_y, heel_z, ...), otherwise raw.
    #[must_use]
    pub fn features(self, value: Features) -> Self {
        self.with(sys::STLTSA_OPT_FEATURES, Value::Int(value.raw().into()))
    }

    /// The axis that points up; auto: found from the skeleton; of points, the file's, or else
    /// guessed.
    #[must_use]
    pub fn up_axis(self, value: Axis) -> Self {
        self.with(sys::STLTSA_OPT_UP_AXIS, Value::Int(value.raw().into()))
    }

    /// Keep a T-pose at the start instead of dropping it.
    #[must_use]
    pub fn keep_start(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_KEEP_START, Value::Int(value.into()))
    }

    /// Frames per second, for files that have no rate; in others it replaces the rate and the
    /// times, and a note says so (batch: it does not); unmap: points per second; auto: the file's
    /// rate, or the model's.
    #[must_use]
    pub fn fps(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_FPS, Value::Real(value))
    }

    /// Decimate clips to about this many frames per second: keep one frame in fps / rate, rounded;
    /// 0: keep all.
    #[must_use]
    pub fn sample_rate(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_SAMPLE_RATE, Value::Real(value))
    }

    /// Standard deviation, in seconds, of the Gaussian that smooths the features; 0: no smoothing.
    #[must_use]
    pub fn smoothing(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_SMOOTHING, Value::Real(value))
    }

    /// Shortest period of the search, in seconds; in frames if the rate is unknown, 4 by default.
    #[must_use]
    pub fn period_min(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_PERIOD_MIN, Value::Real(value))
    }

    /// Longest period of the search, in seconds; in frames if the rate is unknown, half of all and
    /// at most 1000 by default.
    #[must_use]
    pub fn period_max(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_PERIOD_MAX, Value::Real(value))
    }

    /// Smallest gap between eigenvalues that determines the dimension, as a fraction of the
    /// neighbors.
    #[must_use]
    pub fn eigengap(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_EIGENGAP, Value::Real(value))
    }

    /// Share of a neighborhood's variance that local PCA must explain.
    #[must_use]
    pub fn variance(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_VARIANCE, Value::Real(value))
    }

    /// Estimate the intrinsic dimension, too, by the eigengap and by local PCA.
    #[must_use]
    pub fn intrinsic(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_INTRINSIC, Value::Int(value.into()))
    }

    /// The ASF file of an AMC clip; auto: found beside the clip.
    #[must_use]
    pub fn skeleton(self, value: impl AsRef<Path>) -> Self {
        self.with(sys::STLTSA_OPT_SKELETON, Value::Text(value.as_ref().into()))
    }

    /// Keep the fitted frames in the model, so that it can map.
    #[must_use]
    pub fn keep_frames(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_KEEP_FRAMES, Value::Int(value.into()))
    }

    /// Rows for each local map; auto: the dimension plus 5, at least 10.
    #[must_use]
    pub fn map_neighbors(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_MAP_NEIGHBORS, int(value))
    }

    /// Local maps to blend, each from its own part of the curve.
    #[must_use]
    pub fn map_blend(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_MAP_BLEND, int(value))
    }

    /// Rows to search on each side of a hint; auto: a fifth of the neighbors.
    #[must_use]
    pub fn hint_window(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_HINT_WINDOW, int(value))
    }

    /// Component of the coordinates, counted from 0; auto: the only one.
    #[must_use]
    pub fn component(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_COMPONENT, int(value))
    }

    /// Distance from the curve beyond which a point is noisy, in units of the coordinate; auto: one
    /// robust standard deviation of the residuals.
    #[must_use]
    pub fn gamma(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_GAMMA, Value::Real(value))
    }

    /// Spacing of the curve's knots in seconds, or in rows if the rate is unknown; auto: a tenth of
    /// the period, or 2 rows if no period is found.
    #[must_use]
    pub fn knot_spacing(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_KNOT_SPACING, Value::Real(value))
    }

    /// Reduce the influence of spikes on the curve.
    #[must_use]
    pub fn robust(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_ROBUST, Value::Int(value.into()))
    }

    /// Seconds to blend on each side of a seam; auto: a tenth of the repeated cycle, or 0.15
    /// between clips.
    #[must_use]
    pub fn crossfade(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_CROSSFADE, Value::Real(value))
    }

    /// Seconds by which a cut may move to find a common posture; auto: a tenth of the repeated
    /// cycle; between clips half a cycle, at least 0.5.
    #[must_use]
    pub fn cut_range(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_CUT_RANGE, Value::Real(value))
    }

    /// Largest allowed distance between the postures at a seam, relative to the typical distance
    /// between repetitions of one motion; 0: no limit.
    #[must_use]
    pub fn posture_limit(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_POSTURE_LIMIT, Value::Real(value))
    }

    /// Number of segments in motion, without rests; auto: as many as the behavior changes.
    #[must_use]
    pub fn segments(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_SEGMENTS, int(value))
    }

    /// Missing points or values: fill, up to 0.25 s over time, longer ones from the others in the
    /// same frame; skip, all from the others, so that they add nothing to distances; refuse, an
    /// error.
    #[must_use]
    pub fn gaps(self, value: Gaps) -> Self {
        self.with(sys::STLTSA_OPT_GAPS, Value::Int(value.raw().into()))
    }

    /// Points that were seen with less confidence are missing.
    #[must_use]
    pub fn min_confidence(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_MIN_CONFIDENCE, Value::Real(value))
    }

    /// Make a loop: the last frame meets the first, across a seam like any other.
    #[must_use]
    pub fn r#loop(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_LOOP, Value::Int(value.into()))
    }

    /// Remove what a loop travels and turns, so that it ends where it starts.
    #[must_use]
    pub fn in_place(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_IN_PLACE, Value::Int(value.into()))
    }

    /// Which of several people or animals in a file: the prefix of its points (Viktor of
    /// Viktor:LHEE), or its name as an individual or a track; auto: the only one.
    #[must_use]
    pub fn subject(self, value: impl AsRef<str>) -> Self {
        self.with(sys::STLTSA_OPT_SUBJECT, Value::Text(value.as_ref().into()))
    }
}
