// SPDX-License-Identifier: BSD-3-Clause
// Made by scripts/generate-bindings: do not edit.
kinds! {
    /// Parts that a build of the library may be without.
    BuildPart {
        /// Modes spatial and recurrent use CHOLMOD; otherwise LDL, slower.
        Cholmod = STLTSA_HAS_CHOLMOD,
        /// BLAS is OpenBLAS, which a fit sets to one thread and restores.
        Openblas = STLTSA_HAS_OPENBLAS,
    }
    /// Options by key, with their types, for `Options::unset`.
    OptionKey {
        /// `int`: neighbors of each frame (k); auto: 1.2 periods, without a period 1.2 seconds, or
        /// 12 frames without a rate.
        Neighbors = STLTSA_OPT_NEIGHBORS,
        /// `int`: window (w), frames to each side; auto: as neighbors.
        Window = STLTSA_OPT_WINDOW,
        /// `int`: tangent dimension, the number of coordinates (d); auto: 2.
        Dimension = STLTSA_OPT_DIMENSION,
        /// `int`: candidates for neighbors: STLTSA_MODE_*.
        Mode = STLTSA_OPT_MODE,
        /// `int`: count a frame among its own neighbors.
        IncludeSelf = STLTSA_OPT_INCLUDE_SELF,
        /// `int`: recurrent: neighbors beyond the exclusion zone.
        Links = STLTSA_OPT_LINKS,
        /// `int`: recurrent: half width of that zone, frames; auto: window.
        Exclusion = STLTSA_OPT_EXCLUSION,
        /// `int`: threads; auto: one for each core.
        Threads = STLTSA_OPT_THREADS,
        /// `int`: description of a pose: STLTSA_FEATURES_*; auto: positions with a skeleton, points
        /// if columns are named so, otherwise raw.
        Features = STLTSA_OPT_FEATURES,
        /// `int`: up axis: 1, 2, 3 for x, y, z; auto: found, or guessed.
        UpAxis = STLTSA_OPT_UP_AXIS,
        /// `int`: keep a T-pose at the start instead of dropping it.
        KeepStart = STLTSA_OPT_KEEP_START,
        /// `real`: frames per second, for files without a rate, or instead of theirs (not in
        /// batch); of unmapped points; auto: the file's, or the model's.
        Fps = STLTSA_OPT_FPS,
        /// `real`: decimate clips to about this frame rate; 0: keep all.
        SampleRate = STLTSA_OPT_SAMPLE_RATE,
        /// `real`: smoothing of the features: sigma in seconds; 0: none.
        Smoothing = STLTSA_OPT_SMOOTHING,
        /// `real`: shortest period of the search, in seconds; in frames if the rate is unknown, 4
        /// by default.
        PeriodMin = STLTSA_OPT_PERIOD_MIN,
        /// `real`: longest period of the search, in seconds; in frames if the rate is unknown, half
        /// of all, at most 1000, by default.
        PeriodMax = STLTSA_OPT_PERIOD_MAX,
        /// `real`: smallest eigengap that counts (tau), as a share of k.
        Eigengap = STLTSA_OPT_EIGENGAP,
        /// `real`: share of local variance that local PCA must explain.
        Variance = STLTSA_OPT_VARIANCE,
        /// `text`: the ASF file of an AMC clip; auto: found beside the clip.
        Skeleton = STLTSA_OPT_SKELETON,
        /// `int`: keep the fitted frames in the model, so that it can map.
        KeepFrames = STLTSA_OPT_KEEP_FRAMES,
        /// `int`: rows for each local map; auto: d + 5, at least 10.
        MapNeighbors = STLTSA_OPT_MAP_NEIGHBORS,
        /// `int`: local maps to blend, each from its own part of the curve.
        MapBlend = STLTSA_OPT_MAP_BLEND,
        /// `int`: rows to search on each side of a hint; auto: k / 5.
        HintWindow = STLTSA_OPT_HINT_WINDOW,
        /// `int`: component of the coordinates, from 0; auto: the only one.
        Component = STLTSA_OPT_COMPONENT,
        /// `real`: distance from the curve beyond which a point is noisy; auto: one robust
        /// deviation of the residuals.
        Gamma = STLTSA_OPT_GAMMA,
        /// `real`: seconds between knots, or rows if the rate is unknown; auto: a tenth of the
        /// period, otherwise 2 rows.
        KnotSpacing = STLTSA_OPT_KNOT_SPACING,
        /// `int`: reduce the influence of spikes on the curve.
        Robust = STLTSA_OPT_ROBUST,
        /// `real`: seconds to blend on each side of a seam; auto: a tenth of the repeated cycle, or
        /// 0.15 between clips.
        Crossfade = STLTSA_OPT_CROSSFADE,
        /// `real`: seconds by which a cut may move; auto: a tenth of the repeated cycle; between
        /// clips half a cycle, at least 0.5.
        CutRange = STLTSA_OPT_CUT_RANGE,
        /// `real`: max distance of the postures at a seam, relative to that of repetitions; 0: no
        /// limit.
        PostureLimit = STLTSA_OPT_POSTURE_LIMIT,
        /// `int`: number of segments in motion; auto: as behavior changes.
        Segments = STLTSA_OPT_SEGMENTS,
        /// `int`: what becomes of missing values: STLTSA_GAPS_*.
        Gaps = STLTSA_OPT_GAPS,
        /// `real`: points seen with less confidence are missing.
        MinConfidence = STLTSA_OPT_MIN_CONFIDENCE,
        /// `int`: make a loop: the last frame meets the first.
        Loop = STLTSA_OPT_LOOP,
        /// `int`: remove the travel and the turn of a loop.
        InPlace = STLTSA_OPT_IN_PLACE,
        /// `int`: also estimate the intrinsic dimension, in two ways.
        Intrinsic = STLTSA_OPT_INTRINSIC,
        /// `text`: person or animal in a file: the prefix of its points (Viktor of Viktor:LHEE) or
        /// its name; auto: the only one.
        Subject = STLTSA_OPT_SUBJECT,
    }
    /// Which frames can be neighbors of a frame.
    Mode {
        /// Frames of the same clip within the window.
        Temporal = STLTSA_MODE_TEMPORAL,
        /// All frames.
        Spatial = STLTSA_MODE_SPATIAL,
        /// The window and, as links, what is beyond the exclusion zone.
        Recurrent = STLTSA_MODE_RECURRENT,
    }
    /// Which numbers describe a pose.
    Features {
        /// Joints and end sites, without root position and yaw.
        Positions = STLTSA_FEATURES_POSITIONS,
        /// Two columns of each rotation matrix, without root yaw.
        Rotations6d = STLTSA_FEATURES_ROTATIONS6D,
        /// Angles below the root in radians, unwrapped (the paper).
        Euler = STLTSA_FEATURES_EULER,
        /// The file's numbers.
        Raw = STLTSA_FEATURES_RAW,
        /// Points, such as markers, without path and heading; auto if there are at least three
        /// (docs/formats.md).
        Points = STLTSA_FEATURES_POINTS,
    }
    /// What becomes of missing points.
    Gaps {
        /// Up to 0.25 s: linear over time; longer ones: as skip.
        Fill = STLTSA_GAPS_FILL,
        /// E_NOT_FINITE.
        Refuse = STLTSA_GAPS_REFUSE,
        /// What the others in the frame imply, so that it adds no distance.
        Skip = STLTSA_GAPS_SKIP,
    }
    /// The format that a clip was read from.
    Format {
        /// BVH.
        Bvh = STLTSA_FORMAT_BVH,
        /// Needs its ASF: option skeleton, or found by subject number.
        Amc = STLTSA_FORMAT_AMC,
        /// Numbers split by , ; tab or blanks, with or without header lines; columns x, y, z of
        /// points make a clip of points.
        Csv = STLTSA_FORMAT_CSV,
        /// Frames, frames x columns, or frames x points x 2 or 3.
        Npy = STLTSA_FORMAT_NPY,
        /// No file: stltsa_clip_from_matrix.
        Matrix = STLTSA_FORMAT_MATRIX,
        /// No file: stltsa_clip_from_points.
        Points = STLTSA_FORMAT_POINTS,
        /// No file: stltsa_clip_from_skeleton.
        Skeleton = STLTSA_FORMAT_SKELETON,
        /// GlTF 2.0, binary: only written.
        Glb = STLTSA_FORMAT_GLB,
        /// Points and events, of any processor: only read.
        C3d = STLTSA_FORMAT_C3D,
        /// Markers; y is up, by convention: only read.
        Trc = STLTSA_FORMAT_TRC,
        /// MOT and STO of OpenSim, such as joint coordinates: only read.
        Mot = STLTSA_FORMAT_MOT,
    }
    /// Stages that a progress closure sees; a call has some of them.
    Stage {
        /// Reading a clip.
        Read = STLTSA_STAGE_READ,
        /// Features of its poses.
        Features = STLTSA_STAGE_FEATURES,
        /// Choice of k, neighbors; temporal ones are found with tangents.
        Neighbors = STLTSA_STAGE_NEIGHBORS,
        /// Local tangents.
        Tangents = STLTSA_STAGE_TANGENTS,
        /// The alignment matrix.
        Alignment = STLTSA_STAGE_ALIGNMENT,
        /// Its smallest eigenvectors.
        Spectrum = STLTSA_STAGE_SPECTRUM,
        /// Units and cycles.
        Units = STLTSA_STAGE_UNITS,
        /// Mapping, in either direction.
        Map = STLTSA_STAGE_MAP,
        /// Denoising.
        Denoise = STLTSA_STAGE_DENOISE,
        /// New motion.
        Synthesis = STLTSA_STAGE_SYNTHESIS,
        /// Writing a clip.
        Write = STLTSA_STAGE_WRITE,
    }
    /// Kinds of segments. `Display` gives the library's names.
    SegmentKind {
        /// Cycles back to back.
        Cyclic = STLTSA_SEGMENT_CYCLIC,
        /// The same action again and again, with pauses.
        Repetitions = STLTSA_SEGMENT_REPETITIONS,
        /// A motion that is seen once.
        Action = STLTSA_SEGMENT_ACTION,
        /// `STLTSA_SEGMENT_REST`.
        Rest = STLTSA_SEGMENT_REST,
    }
    /// Kinds of motion units. `Display` gives the library's names.
    UnitKind {
        /// Standing before a motion.
        Preparing = STLTSA_UNIT_PREPARING,
        /// From the first movement to the first cycle.
        Initial = STLTSA_UNIT_INITIAL,
        /// The cycles.
        Cyclic = STLTSA_UNIT_CYCLIC,
        /// From the last cycle to standing.
        Final = STLTSA_UNIT_FINAL,
        /// Standing after a motion.
        WindUp = STLTSA_UNIT_WIND_UP,
        /// Motion for which no cycles are reported.
        Action = STLTSA_UNIT_ACTION,
        /// Keeping another posture than the one at rest.
        Hold = STLTSA_UNIT_HOLD,
    }
    /// What the statistics of a decomposition are about.
    Quantity {
        /// `STLTSA_QUANTITY_TIME`.
        Time = STLTSA_QUANTITY_TIME,
        /// `STLTSA_QUANTITY_PATH_LENGTH`.
        PathLength = STLTSA_QUANTITY_PATH_LENGTH,
        /// `STLTSA_QUANTITY_STRIDE`.
        Stride = STLTSA_QUANTITY_STRIDE,
        /// `STLTSA_QUANTITY_SPEED`.
        Speed = STLTSA_QUANTITY_SPEED,
        /// `STLTSA_QUANTITY_TURN`.
        Turn = STLTSA_QUANTITY_TURN,
    }
    /// Kinds of warnings.
    WarningKind {
        /// Coordinate 1 only follows time.
        FollowsTime = STLTSA_WARNING_FOLLOWS_TIME,
        /// Windows vary in fewer than d directions.
        RankDeficient = STLTSA_WARNING_RANK_DEFICIENT,
        /// Another dimension is better defined.
        SmallGap = STLTSA_WARNING_SMALL_GAP,
        /// Rounding may rotate a direction: scale the features.
        Unscaled = STLTSA_WARNING_UNSCALED,
        /// Eigenvalues at the limit of double precision.
        Inaccurate = STLTSA_WARNING_INACCURATE,
        /// The neighborhood graph has several components.
        Disconnected = STLTSA_WARNING_DISCONNECTED,
        /// The pose jumps.
        Jump = STLTSA_WARNING_JUMP,
        /// A motion that was not searched for cycles.
        SeparateMotion = STLTSA_WARNING_SEPARATE_MOTION,
        /// Clips joined have slightly different skeletons.
        OffsetsDiffer = STLTSA_WARNING_OFFSETS_DIFFER,
        /// A clip was resampled to the first one's frame rate.
        Resampled = STLTSA_WARNING_RESAMPLED,
        /// Postures at a seam are far apart.
        SeamPosture = STLTSA_WARNING_SEAM_POSTURE,
        /// Unusually fast near a seam.
        SeamSpeed = STLTSA_WARNING_SEAM_SPEED,
        /// Unusual acceleration near a seam.
        SeamAcceleration = STLTSA_WARNING_SEAM_ACCELERATION,
        /// No frames beyond the cuts of a seam to blend.
        NotBlended = STLTSA_WARNING_NOT_BLENDED,
        /// Consecutive rows are no closer than random ones.
        NoOrder = STLTSA_WARNING_NO_ORDER,
        /// Phases that are linear in time, so less sure.
        LinearPhase = STLTSA_WARNING_LINEAR_PHASE,
        /// Marks at several places of the cycle.
        SeveralPlaces = STLTSA_WARNING_SEVERAL_PLACES,
        /// Repetitions without the event.
        NotFound = STLTSA_WARNING_NOT_FOUND,
        /// Too few cycles for intervals.
        FewCycles = STLTSA_WARNING_FEW_CYCLES,
        /// The motions seem to be different.
        NotAlike = STLTSA_WARNING_NOT_ALIKE,
        /// Another shift is nearly as good.
        UncertainShift = STLTSA_WARNING_UNCERTAIN_SHIFT,
        /// Bodies of different size or unit.
        SizesDiffer = STLTSA_WARNING_SIZES_DIFFER,
    }
    /// What an object says, by key, with its type; `[]`: several values.
    Fact {
        /// `text[]`: path of the clip as given; empty: from memory.
        Path = STLTSA_INFO_PATH,
        /// `int[]`: STLTSA_FORMAT_* of the clip.
        Format = STLTSA_INFO_FORMAT,
        /// `int[]`: frames of the clip.
        ClipFrames = STLTSA_INFO_CLIP_FRAMES,
        /// `real[]`: frames a second of the clip; 0: unknown.
        ClipFps = STLTSA_INFO_CLIP_FPS,
        /// `text[]`: what was assumed of the clip, and removed from it.
        Note = STLTSA_INFO_NOTE,
        /// `text[]`: names of its channels, if the file has names.
        Channel = STLTSA_INFO_CHANNEL,
        /// `int`: STLTSA_FEATURES_* used.
        Features = STLTSA_INFO_FEATURES,
        /// `int`: columns of the features.
        FeatureCount = STLTSA_INFO_FEATURE_COUNT,
        /// `int`: up axis: 1, 2, 3 for x, y, z; 0: not needed.
        UpAxis = STLTSA_INFO_UP_AXIS,
        /// `real`: sigma of the smoothing, in seconds; 0: none.
        Smoothing = STLTSA_INFO_SMOOTHING,
        /// `int`: rows that the method worked on.
        Rows = STLTSA_INFO_ROWS,
        /// `int[]`: rows of each clip; of a denoising, of each spline.
        Length = STLTSA_INFO_LENGTH,
        /// `int[]`: row i is frame first_frame + i * frame_step.
        FirstFrame = STLTSA_INFO_FIRST_FRAME,
        /// `int[]`: see first_frame; 1 for matrices.
        FrameStep = STLTSA_INFO_FRAME_STEP,
        /// `real`: rows a second; 0: unknown.
        Fps = STLTSA_INFO_FPS,
        /// `int`: joint that turns the body; its ancestors do not.
        BodyRoot = STLTSA_INFO_BODY_ROOT,
        /// `int`: STLTSA_MODE_*.
        Mode = STLTSA_INFO_MODE,
        /// `int`: k used, in rows.
        Neighbors = STLTSA_INFO_NEIGHBORS,
        /// `int`: w used, in rows to each side.
        Window = STLTSA_INFO_WINDOW,
        /// `int`: tangent dimension d.
        Dimension = STLTSA_INFO_DIMENSION,
        /// `int`: 1: a row is among its own neighbors.
        IncludeSelf = STLTSA_INFO_INCLUDE_SELF,
        /// `int`: recurrent: neighbors beyond the exclusion zone.
        Links = STLTSA_INFO_LINKS,
        /// `int`: recurrent: half width of that zone in rows.
        Exclusion = STLTSA_INFO_EXCLUSION,
        /// `real`: period in seconds; 0: none, or rate unknown.
        Period = STLTSA_INFO_PERIOD,
        /// `real`: match of velocities a period apart, 0 to 1.
        LagQuality = STLTSA_INFO_LAG_QUALITY,
        /// `real`: shortest period of the search, seconds; 0: none.
        PeriodMin = STLTSA_INFO_PERIOD_MIN,
        /// `real`: longest period of the search, seconds; 0: none.
        PeriodMax = STLTSA_INFO_PERIOD_MAX,
        /// `real`: period in rows; 0: none.
        PeriodRows = STLTSA_INFO_PERIOD_ROWS,
        /// `int`: rows collapsed because they repeat the one before.
        Repeated = STLTSA_INFO_REPEATED,
        /// `real`: |rank correlation| of coordinate 1 and time.
        TimeCorrelation = STLTSA_INFO_TIME_CORRELATION,
        /// `real`: distance from the fitted frames up to which a frame is like them; 0: the model
        /// cannot map.
        Reach = STLTSA_INFO_REACH,
        /// Rows stltsa_component: those of the neighborhood graph.
        Component = STLTSA_INFO_COMPONENT,
        /// `int`: 1: keeps a mean cycle (stltsa_model_keep_cycle).
        HasCycle = STLTSA_INFO_HAS_CYCLE,
        /// Array rows x d: coordinates; of a decomposition, rows x 2: the curve, and itself a
        /// quarter cycle behind.
        Coords = STLTSA_INFO_COORDS,
        /// Array components x (d + 2), ascending from lambda_1 = 0; NaN: the component is too
        /// small.
        Eigenvalues = STLTSA_INFO_EIGENVALUES,
        /// Array rows x 1: component of each row, in order, from 0.
        ComponentOf = STLTSA_INFO_COMPONENT_OF,
        /// `int`: coordinate whose margins count, from 1; 0: none.
        Coordinate = STLTSA_INFO_COORDINATE,
        /// `real`: how well that coordinate repeats; 1: perfect.
        Cyclicity = STLTSA_INFO_CYCLICITY,
        /// `int`: first cycle of the longest cyclic segment, or -1.
        Representative = STLTSA_INFO_REPRESENTATIVE,
        /// `int`: cycle there that is most like the mean; -1: none.
        Best = STLTSA_INFO_BEST,
        /// `text`: why nothing repeats; empty if anything does.
        Reason = STLTSA_INFO_REASON,
        /// `real[]`: eigenvalues of B, ascending; of a model, of B / k.
        Eigenvalue = STLTSA_INFO_EIGENVALUE,
        /// `int[]`: up to 24 distinct frames for pictures, best first.
        Postures = STLTSA_INFO_POSTURES,
        /// Rows stltsa_segment, in order; they cover the clip.
        Segment = STLTSA_INFO_SEGMENT,
        /// Rows stltsa_unit, in order; they cover the clip, too.
        Unit = STLTSA_INFO_UNIT,
        /// Rows stltsa_part, in order.
        Cycle = STLTSA_INFO_CYCLE,
        /// Rows stltsa_part: half cycles, if sides alternate.
        Step = STLTSA_INFO_STEP,
        /// Rows stltsa_part: the actions of repetitions.
        Repetition = STLTSA_INFO_REPETITION,
        /// Rows stltsa_summary: one for each label that repeats.
        Summary = STLTSA_INFO_SUMMARY,
        /// `int[]`: STLTSA_SIDE_* of sides 0 and 1, in right-handed axes; STLTSA_SIDE_NONE: no
        /// names tell.
        Side = STLTSA_INFO_SIDE,
        /// Array rows x 1: smoothed coordinate of each cyclic segment, else 0; of a denoising, rows
        /// x columns: the curve f_c.
        Curve = STLTSA_INFO_CURVE,
        /// Array labels x labels: mean likeness of segments, 0 to 1; from about 0.65 on they share
        /// a label; NaN: a single segment.
        LabelLikeness = STLTSA_INFO_LABEL_LIKENESS,
        /// `int`: intrinsic dimension by local PCA; 0: cannot tell.
        LocalPca = STLTSA_INFO_LOCAL_PCA,
        /// `int`: intrinsic dimension by the eigengap; 0: cannot tell.
        Eigengap = STLTSA_INFO_EIGENGAP,
        /// `text`: why local PCA cannot tell; empty if it can.
        LocalPcaReason = STLTSA_INFO_LOCAL_PCA_REASON,
        /// `text`: why the eigengap cannot tell; empty if it can.
        EigengapReason = STLTSA_INFO_EIGENGAP_REASON,
        /// `real`: share of local variance that local PCA must explain.
        Variance = STLTSA_INFO_VARIANCE,
        /// `real`: tau of section 2.3 as a fraction of k.
        EigengapThreshold = STLTSA_INFO_EIGENGAP_THRESHOLD,
        /// `real[]`: mean share of variance of each local direction.
        LocalVariance = STLTSA_INFO_LOCAL_VARIANCE,
        /// Rows stltsa_denoised_column: one for each column.
        Column = STLTSA_INFO_COLUMN,
        /// Array rows x columns: the points after equation (1).
        Cleaned = STLTSA_INFO_CLEANED,
        /// Array rows x columns: how far each point was moved.
        Moves = STLTSA_INFO_MOVES,
        /// `real`: option gamma; none: chosen for each column.
        GammaOption = STLTSA_INFO_GAMMA_OPTION,
        /// `real`: rows between the knots of the curve.
        KnotRows = STLTSA_INFO_KNOT_ROWS,
        /// `int`: 1: the influence of spikes is reduced.
        Robust = STLTSA_INFO_ROBUST,
        /// `real`: period_min of the coordinates' model; 0: none.
        FitPeriodMin = STLTSA_INFO_FIT_PERIOD_MIN,
        /// `real`: period_max of that model; 0: none.
        FitPeriodMax = STLTSA_INFO_FIT_PERIOD_MAX,
        /// `int`: 1: noise is below 0.5 % of each column's range.
        NothingToClean = STLTSA_INFO_NOTHING_TO_CLEAN,
        /// `real`: option crossfade; none: chosen for each seam.
        Crossfade = STLTSA_INFO_CROSSFADE,
        /// `real`: option cut_range; none: chosen for each seam.
        CutRange = STLTSA_INFO_CUT_RANGE,
        /// `real`: option posture_limit; 0: none.
        PostureLimit = STLTSA_INFO_POSTURE_LIMIT,
        /// Rows stltsa_piece_fact: what was joined.
        Piece = STLTSA_INFO_PIECE,
        /// Rows stltsa_seam, in order.
        Seam = STLTSA_INFO_SEAM,
        /// `int`: 1: a loop; only loops have the next six facts.
        Loop = STLTSA_INFO_LOOP,
        /// `int`: option in_place; 1: travel and turn are removed.
        InPlace = STLTSA_INFO_IN_PLACE,
        /// `real[]`: x, y, z of a loop's travel along the ground.
        Travel = STLTSA_INFO_TRAVEL,
        /// `real`: degrees that a loop turns, positive to the left.
        Turn = STLTSA_INFO_TURN,
        /// `real`: share of cycles, or pieces' frames, in the loop.
        Coverage = STLTSA_INFO_COVERAGE,
        /// `int`: cycles in the loop, if chosen among the clip's.
        LoopCycles = STLTSA_INFO_LOOP_CYCLES,
        /// `int`: cycles of the clip, if chosen among them.
        SourceCycles = STLTSA_INFO_SOURCE_CYCLES,
        /// Rows stltsa_warning: what to know about the result.
        Warning = STLTSA_INFO_WARNING,
        /// `text`: unit of lengths, such as mm; empty: unknown.
        LengthUnit = STLTSA_INFO_LENGTH_UNIT,
        /// `int`: up axis that the file states (TRC: y); 0: none.
        FileUpAxis = STLTSA_INFO_FILE_UP_AXIS,
        /// Rows stltsa_joint, parents first.
        Joint = STLTSA_INFO_JOINT,
        /// Rows stltsa_file_event, in order of time.
        FileEvent = STLTSA_INFO_FILE_EVENT,
        /// `int`: channels, columns or coordinates of each frame.
        Channels = STLTSA_INFO_CHANNELS,
        /// Array frames x (3 * joints): positions in the world.
        Positions = STLTSA_INFO_POSITIONS,
        /// Array frames x (4 * joints): local, w x y z, continuous.
        Rotations = STLTSA_INFO_ROTATIONS,
        /// Array frames of the file x 1, in [0, 1); NaN: no cycle.
        Phase = STLTSA_INFO_PHASE,
        /// Array frames x 1: distance from the mean cycle, as a share of the motion's rms
        /// deviation; NaN: no cycle.
        PhaseResidual = STLTSA_INFO_PHASE_RESIDUAL,
        /// Array frames x 1: index of the cycle; -1: no cycle.
        PhaseCycle = STLTSA_INFO_PHASE_CYCLE,
        /// `real[]`: of each label, phase of a place that all clips with these features share; 0:
        /// only repetitions; NaN: neither.
        PhaseZero = STLTSA_INFO_PHASE_ZERO,
        /// `text[]`: joint, point or column of each feature.
        Owner = STLTSA_INFO_OWNER,
        /// Array[] samples x columns: each cycle.
        Values = STLTSA_INFO_VALUES,
        /// Array[] samples x columns: mean of the cycles; of a comparison, of both motions, at
        /// phases of the first.
        Mean = STLTSA_INFO_MEAN,
        /// Array[] the same: standard deviation; of one cycle, NaN.
        Deviation = STLTSA_INFO_DEVIATION,
        /// Array cycles x samples: frame of each, not rounded.
        SampleFrames = STLTSA_INFO_SAMPLE_FRAMES,
        /// Array cycles x samples: delay, as a share of the cycle.
        Warp = STLTSA_INFO_WARP,
        /// Array cycles x 1: rms distance from the mean cycle, as a share of the deviation along
        /// it.
        Distance = STLTSA_INFO_DISTANCE,
        /// Array cycles x columns: the same, in the signal's unit.
        ColumnDistance = STLTSA_INFO_COLUMN_DISTANCE,
        /// Rows stltsa_event, in order of time.
        Event = STLTSA_INFO_EVENT,
        /// `real`: correlation of both mean cycles, 1 within a clip; below 0.95 events are less
        /// sure, below 0.6 there are none.
        Likeness = STLTSA_INFO_LIKENESS,
        /// Rows stltsa_compared: one, about the whole.
        Comparison = STLTSA_INFO_COMPARISON,
        /// Rows stltsa_compared_motion: the first, the second.
        Motion = STLTSA_INFO_MOTION,
        /// Rows stltsa_compared_part: joints, points or columns.
        Part = STLTSA_INFO_PART,
        /// Rows stltsa_compared_part: coordinates, part by part.
        PartChannel = STLTSA_INFO_PART_CHANNEL,
        /// Array samples x channels: second minus first.
        Difference = STLTSA_INFO_DIFFERENCE,
        /// Array samples x channels: its standard error.
        StandardError = STLTSA_INFO_STANDARD_ERROR,
        /// Array samples x channels: half a pointwise 95 % interval.
        Margin = STLTSA_INFO_MARGIN,
        /// `text[]`: marks of the model, in the order they were kept.
        Mark = STLTSA_INFO_MARK,
    }
    /// Kinds of failure. Each function lists those that it can return.
    ErrorKind {
        /// NULL where not allowed, unknown key, value out of range.
        Argument = STLTSA_E_ARGUMENT,
        /// Rows, columns or strides do not match.
        Shape = STLTSA_E_SHAPE,
        /// A NaN, an infinity, or a number beyond 1e100.
        NotFinite = STLTSA_E_NOT_FINITE,
        /// Fewer (distinct) frames than k requires.
        TooFewFrames = STLTSA_E_TOO_FEW_FRAMES,
        /// No memory, or rows * cols overflows.
        NoMemory = STLTSA_E_NO_MEMORY,
        /// A file cannot be opened, read or written.
        Io = STLTSA_E_IO,
        /// A file violates its format; the text names the line.
        Format = STLTSA_E_FORMAT,
        /// A connected neighborhood graph was needed.
        Disconnected = STLTSA_E_DISCONNECTED,
        /// The frames do not vary, or not in enough directions.
        Degenerate = STLTSA_E_DEGENERATE,
        /// The eigensolver did not converge.
        NotConverged = STLTSA_E_NOT_CONVERGED,
        /// The progress callback asked to stop.
        Cancelled = STLTSA_E_CANCELLED,
        /// Not supported for this clip, model or format.
        Unsupported = STLTSA_E_UNSUPPORTED,
        /// A bug in the library; the text says where to report it.
        Internal = STLTSA_E_INTERNAL,
        /// Two pieces have no common posture at which to join.
        NoCommonPosture = STLTSA_E_NO_COMMON_POSTURE,
        /// A clip lacks the stretch that was asked for.
        NoSuchPart = STLTSA_E_NO_SUCH_PART,
    }
}
