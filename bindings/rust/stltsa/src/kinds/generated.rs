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
        /// `int`: k; auto: 1.2 periods if a period is found, otherwise 1.2 s, or 12 rows if the
        /// frame rate is unknown.
        Neighbors = STLTSA_OPT_NEIGHBORS,
        /// `int`: w, frames to each side; auto: as neighbors.
        Window = STLTSA_OPT_WINDOW,
        /// `int`: d; auto: 2.
        Dimension = STLTSA_OPT_DIMENSION,
        /// `int`: STLTSA_MODE_*.
        Mode = STLTSA_OPT_MODE,
        /// `int`: 1: a frame is among its own k neighbors (Zhang and Zha); 0: it is not (as
        /// scikit-learn has it).
        IncludeSelf = STLTSA_OPT_INCLUDE_SELF,
        /// `int`: recurrent: neighbors from outside the exclusion zone.
        Links = STLTSA_OPT_LINKS,
        /// `int`: recurrent: half width of that zone in frames; auto: window.
        Exclusion = STLTSA_OPT_EXCLUSION,
        /// `int`: auto: every core.
        Threads = STLTSA_OPT_THREADS,
        /// `int`: STLTSA_FEATURES_*; auto: positions if there is a skeleton, points if the columns
        /// are named so, otherwise raw.
        Features = STLTSA_OPT_FEATURES,
        /// `int`: 1, 2, 3: x, y, z; auto: found from the skeleton; of points, the file's, or else
        /// guessed (a note says so).
        UpAxis = STLTSA_OPT_UP_AXIS,
        /// `int`: 1: do not drop a T-pose at the start.
        KeepStart = STLTSA_OPT_KEEP_START,
        /// `real`: frames a second, for files that have no rate; in others it replaces the rate and
        /// the times, and a note says so; auto: the file's. unmap_clip: points a second; auto: the
        /// model's rows.
        Fps = STLTSA_OPT_FPS,
        /// `real`: clips: keep one frame in fps / sample_rate, rounded; 0: all.
        SampleRate = STLTSA_OPT_SAMPLE_RATE,
        /// `real`: sigma in seconds of the Gaussian on the features; 0: none.
        Smoothing = STLTSA_OPT_SMOOTHING,
        /// `real`: shortest period looked for, seconds; rows if the rate is unknown, 4 unless it is
        /// set.
        PeriodMin = STLTSA_OPT_PERIOD_MIN,
        /// `real`: longest period looked for, seconds; rows if the rate is unknown, half of all and
        /// at most 1000 unless it is set. If only one of the two is set, the other end yields to
        /// it.
        PeriodMax = STLTSA_OPT_PERIOD_MAX,
        /// `real`: tau of section 2.3 as a fraction of k.
        Eigengap = STLTSA_OPT_EIGENGAP,
        /// `real`: share of local variance that local PCA must explain.
        Variance = STLTSA_OPT_VARIANCE,
        /// `text`: path of the ASF file of an AMC clip; auto: found beside the clip.
        Skeleton = STLTSA_OPT_SKELETON,
        /// `int`: 1: a model keeps its fitted frames, so it can map and unmap; 0: it keeps only the
        /// coordinates.
        KeepFrames = STLTSA_OPT_KEEP_FRAMES,
        /// `int`: rows for each local map; auto: max(d + 5, 10).
        MapNeighbors = STLTSA_OPT_MAP_NEIGHBORS,
        /// `int`: segments of the curve whose maps are blended.
        MapBlend = STLTSA_OPT_MAP_BLEND,
        /// `int`: rows to each side of a hint; auto: a fifth of k.
        HintWindow = STLTSA_OPT_HINT_WINDOW,
        /// `int`: unmap: component that the coordinates are of, 0-based; auto: the only one there
        /// is.
        Component = STLTSA_OPT_COMPONENT,
        /// `real`: gamma of section 3.2, in units of the coordinate; auto: one robust standard
        /// deviation of the residuals.
        Gamma = STLTSA_OPT_GAMMA,
        /// `real`: denoise: seconds (rows if the rate is unknown) between knots; auto: a tenth of
        /// the period, otherwise 2 rows.
        KnotSpacing = STLTSA_OPT_KNOT_SPACING,
        /// `int`: denoise: 1: reduce the influence of spikes.
        Robust = STLTSA_OPT_ROBUST,
        /// `real`: synthesize: seconds to each side of a seam; auto: a tenth of the cycle that is
        /// repeated, 0.15 s if clips are joined.
        Crossfade = STLTSA_OPT_CROSSFADE,
        /// `real`: synthesize: seconds by which a cut may move to find a common posture; auto: a
        /// tenth of the repeated cycle, half a cycle and at least 0.5 s if clips are joined.
        CutRange = STLTSA_OPT_CUT_RANGE,
        /// `real`: synthesize: largest distance of the postures at a seam, divided by the usual
        /// distance between repetitions of a motion; 0: none.
        PostureLimit = STLTSA_OPT_POSTURE_LIMIT,
        /// `int`: decompose: number of segments in motion; rests are not counted; auto: as many as
        /// the behavior changes.
        Segments = STLTSA_OPT_SEGMENTS,
        /// `int`: STLTSA_GAPS_*.
        Gaps = STLTSA_OPT_GAPS,
        /// `real`: points seen with less are missing.
        MinConfidence = STLTSA_OPT_MIN_CONFIDENCE,
        /// `int`: synthesize: 1: the last frame meets the first across a seam, the last of the
        /// synthesis.
        Loop = STLTSA_OPT_LOOP,
        /// `int`: synthesize: 1: of a loop, the root's horizontal travel and its turn are removed,
        /// evenly over the frames, so that the loop ends where it starts; heights are kept.
        InPlace = STLTSA_OPT_IN_PLACE,
        /// `int`: fits: 1: the intrinsic dimension is estimated, too: see STLTSA_INFO_LOCAL_PCA and
        /// _EIGENGAP.
        Intrinsic = STLTSA_OPT_INTRINSIC,
        /// `text`: which of several people or animals in a file is opened: the prefix of its
        /// points, "Viktor" of "Viktor:LHEE", or its name as an individual or a track; auto: the
        /// only one. They are never merged: if there are several and none is chosen, E_ARGUMENT,
        /// and the text lists them.
        Subject = STLTSA_OPT_SUBJECT,
    }
    /// Which frames can be neighbors of a frame.
    Mode {
        /// The frames of the same clip within the window.
        Temporal = STLTSA_MODE_TEMPORAL,
        /// All frames.
        Spatial = STLTSA_MODE_SPATIAL,
        /// Those of the window and, as links, the frames outside the exclusion zone.
        Recurrent = STLTSA_MODE_RECURRENT,
    }
    /// Which numbers describe a pose.
    Features {
        /// Joints and end sites, root position and yaw removed.
        Positions = STLTSA_FEATURES_POSITIONS,
        /// Two columns of each rotation matrix, root yaw removed.
        Rotations6d = STLTSA_FEATURES_ROTATIONS6D,
        /// Angles below the root in radians, unwrapped (the paper).
        Euler = STLTSA_FEATURES_EULER,
        /// The file's numbers.
        Raw = STLTSA_FEATURES_RAW,
        /// Points, such as markers, of a clip without a skeleton; auto if the clip is made of at
        /// least three (stltsa_clip_from_points; NPY frames x points x 3; CSV columns named heel_x,
        /// heel_y, heel_z, or heelX, heel.x, heel:x, "heel x"). A point at exactly 0, or without a
        /// value, is missing: option gaps. Removed: the path of the mean along the ground, slow
        /// changes of its height, the heading; in a plane, the path of the mean, and the heading if
        /// it turns by a right angle. Notes say what was done.
        Points = STLTSA_FEATURES_POINTS,
    }
    /// What becomes of missing points.
    Gaps {
        /// Gaps up to 0.25 s between two frames of the clip: linearly over time, points relative to
        /// the path of the body; others: as skip.
        Fill = STLTSA_GAPS_FILL,
        /// E_NOT_FINITE.
        Refuse = STLTSA_GAPS_REFUSE,
        /// What the points that are there imply (conditional mean), so that distances are those of
        /// what both frames have.
        Skip = STLTSA_GAPS_SKIP,
    }
    /// The format that a clip was read from.
    Format {
        /// BVH.
        Bvh = STLTSA_FORMAT_BVH,
        /// AMC; needs its ASF: option skeleton, or found by subject number.
        Amc = STLTSA_FORMAT_AMC,
        /// Numbers split by , ; tab or blanks; header lines are optional. Columns named x, y, z of
        /// each point, in any order, make a clip of points; an empty cell is a missing value.
        /// docs/formats.md lists the layouts that are read; a *_motion.tsv of Motion-BIDS is one.
        Csv = STLTSA_FORMAT_CSV,
        /// NumPy 1.0 to 3.0, float32, float64 or integers, C or Fortran order: frames, frames x
        /// columns, or frames x points x 2 or 3.
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
        /// MOT and STO of OpenSim, joint coordinates and the like: only read.
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
        /// Length in seconds.
        Time = STLTSA_QUANTITY_TIME,
        /// These four: see stltsa_part.
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
        /// Phases that are linear in time, so what rests on them is less sure.
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
        /// `text[]`: names of the clip's channels; none if the file has no names.
        Channel = STLTSA_INFO_CHANNEL,
        /// `int`: STLTSA_FEATURES_* used.
        Features = STLTSA_INFO_FEATURES,
        /// `int`: columns of the features.
        FeatureCount = STLTSA_INFO_FEATURE_COUNT,
        /// `int`: axis that points up: 1, 2, 3 for x, y, z; 0: none was needed.
        UpAxis = STLTSA_INFO_UP_AXIS,
        /// `real`: sigma in seconds of the Gaussian on the features; 0: none.
        Smoothing = STLTSA_INFO_SMOOTHING,
        /// `int`: rows that the method worked on.
        Rows = STLTSA_INFO_ROWS,
        /// `int[]`: rows of each clip; of a denoising, of each spline.
        Length = STLTSA_INFO_LENGTH,
        /// `int[]`: row i of a clip is its source frame first_frame + i * frame_step.
        FirstFrame = STLTSA_INFO_FIRST_FRAME,
        /// `int[]`: see first_frame; 1 for matrices.
        FrameStep = STLTSA_INFO_FRAME_STEP,
        /// `real`: rows a second; 0: unknown.
        Fps = STLTSA_INFO_FPS,
        /// `int`: Clips: joint that turns the body. Those before it, its ancestors, are not part of
        /// the body.
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
        /// `int`: Recurrent: neighbors from outside the exclusion zone.
        Links = STLTSA_INFO_LINKS,
        /// `int`: Recurrent: half width of that zone in rows.
        Exclusion = STLTSA_INFO_EXCLUSION,
        /// `real`: period in seconds; 0: none, or the rate is unknown: see PERIOD_ROWS.
        Period = STLTSA_INFO_PERIOD,
        /// `real`: match of the velocities one period apart; 1: perfect, 0: no period.
        LagQuality = STLTSA_INFO_LAG_QUALITY,
        /// `real`: shortest period looked for, in seconds; 0: no search was made.
        PeriodMin = STLTSA_INFO_PERIOD_MIN,
        /// `real`: longest period looked for, in seconds; 0: no search was made.
        PeriodMax = STLTSA_INFO_PERIOD_MAX,
        /// `real`: period in rows; 0: none.
        PeriodRows = STLTSA_INFO_PERIOD_ROWS,
        /// `int`: rows collapsed because they repeat the one before.
        Repeated = STLTSA_INFO_REPEATED,
        /// `real`: absolute rank correlation of coordinate 1 with time, over at most 2^14 frames of
        /// the largest component; 1: it only follows time.
        TimeCorrelation = STLTSA_INFO_TIME_CORRELATION,
        /// `real`: distance from the fitted frames, in units of the features, up to which a new
        /// frame is like them; 0: the model cannot map.
        Reach = STLTSA_INFO_REACH,
        /// Rows stltsa_component: those of the neighborhood graph.
        Component = STLTSA_INFO_COMPONENT,
        /// `int`: 1: the model keeps a mean cycle, see stltsa_model_keep_cycle.
        HasCycle = STLTSA_INFO_HAS_CYCLE,
        /// Array rows x d: the coordinates; of a decomposition, rows x 2: the curve, and itself a
        /// quarter of a cycle behind, the loop of Fig. 1.
        Coords = STLTSA_INFO_COORDS,
        /// Array components x (d + 2): lambda_1 = 0, lambda_2, ..., ascending; NaN if a component
        /// is too small.
        Eigenvalues = STLTSA_INFO_EIGENVALUES,
        /// Array rows x 1: component of each row, numbered from 0 in the order of their first rows.
        ComponentOf = STLTSA_INFO_COMPONENT_OF,
        /// `int`: 1-based coordinate of the fit whose margins count; 0: none.
        Coordinate = STLTSA_INFO_COORDINATE,
        /// `real`: how well that coordinate repeats once a period; 1: perfect.
        Cyclicity = STLTSA_INFO_CYCLICITY,
        /// `int`: index of the first cycle of the cyclic segment that lasts longest; -1: none.
        Representative = STLTSA_INFO_REPRESENTATIVE,
        /// `int`: index of the cycle most like the mean cycle of that segment; -1: none.
        Best = STLTSA_INFO_BEST,
        /// `text`: why nothing repeats; empty if anything does.
        Reason = STLTSA_INFO_REASON,
        /// `real[]`: eigenvalues of B, ascending, the zero one first; of a model, those of B / k
        /// that the estimate of the dimension rests on.
        Eigenvalue = STLTSA_INFO_EIGENVALUE,
        /// `int[]`: frames of up to 24 distinct postures, for pictures; to draw n, take the first
        /// n.
        Postures = STLTSA_INFO_POSTURES,
        /// Rows stltsa_segment, in temporal order; they cover [0, frames of the clip) without gap
        /// or overlap.
        Segment = STLTSA_INFO_SEGMENT,
        /// Rows stltsa_unit; they cover the clip, too.
        Unit = STLTSA_INFO_UNIT,
        /// Rows stltsa_part, in temporal order.
        Cycle = STLTSA_INFO_CYCLE,
        /// Rows stltsa_part: halves of cycles; none unless both sides alternate.
        Step = STLTSA_INFO_STEP,
        /// Rows stltsa_part: single actions of segments of repetitions.
        Repetition = STLTSA_INFO_REPETITION,
        /// Rows stltsa_summary: one for each label that repeats.
        Summary = STLTSA_INFO_SUMMARY,
        /// `int[]`: STLTSA_SIDE_* that side 0 and side 1 of parts are; STLTSA_SIDE_NONE if no names
        /// tell. Assumes right-handed axes.
        Side = STLTSA_INFO_SIDE,
        /// Array rows x 1: the smoothed coordinate whose margins count, 0 outside cyclic segments,
        /// each of which has a coordinate of its own; of a denoising, rows x columns: the fitted
        /// curve f_c.
        Curve = STLTSA_INFO_CURVE,
        /// Array labels x labels: how similar their segments are, 0 (different) to 1 (same): the
        /// mean over pairs of segments, at most 24 of each label. It compares the postures, the
        /// speeds, and which parts of the body move together; moderate differences in size and
        /// tempo change it little. From about 0.65 on, segments share a label, except repetitions,
        /// which are grouped by their course. NaN for a label of one segment with itself.
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
        /// `real[]`: mean share of a neighborhood's variance along each of its principal
        /// directions.
        LocalVariance = STLTSA_INFO_LOCAL_VARIANCE,
        /// Rows stltsa_denoised_column: one for each column.
        Column = STLTSA_INFO_COLUMN,
        /// Array rows x columns: the points after equation (1).
        Cleaned = STLTSA_INFO_CLEANED,
        /// Array rows x columns: displacement of each point; 0: not moved.
        Moves = STLTSA_INFO_MOVES,
        /// `real`: option gamma; none: chosen for each column.
        GammaOption = STLTSA_INFO_GAMMA_OPTION,
        /// `real`: rows between the knots of the curve.
        KnotRows = STLTSA_INFO_KNOT_ROWS,
        /// `int`: 1: the influence of spikes is reduced.
        Robust = STLTSA_INFO_ROBUST,
        /// `real`: period_min of the model whose coordinates these are; 0: none.
        FitPeriodMin = STLTSA_INFO_FIT_PERIOD_MIN,
        /// `real`: period_max of that model; 0: none.
        FitPeriodMax = STLTSA_INFO_FIT_PERIOD_MAX,
        /// `int`: 1: the noise of every column is below 0.5 % of its range, which cannot be seen in
        /// a figure.
        NothingToClean = STLTSA_INFO_NOTHING_TO_CLEAN,
        /// `real`: option crossfade; none: chosen for each seam.
        Crossfade = STLTSA_INFO_CROSSFADE,
        /// `real`: option cut_range; none: chosen for each seam.
        CutRange = STLTSA_INFO_CUT_RANGE,
        /// `real`: option posture_limit; 0: none.
        PostureLimit = STLTSA_INFO_POSTURE_LIMIT,
        /// Rows stltsa_piece_fact: what was joined.
        Piece = STLTSA_INFO_PIECE,
        /// Rows stltsa_seam, in temporal order.
        Seam = STLTSA_INFO_SEAM,
        /// `int`: 1: a loop; only loops have the next six facts.
        Loop = STLTSA_INFO_LOOP,
        /// `int`: option in_place.
        InPlace = STLTSA_INFO_IN_PLACE,
        /// `real[]`: x, y, z of the body's travel per loop along the ground, in the clip's unit; in
        /// place: what was removed.
        Travel = STLTSA_INFO_TRAVEL,
        /// `real`: degrees by which the body turns per loop, from above positive to its left; in
        /// place: what was removed.
        Turn = STLTSA_INFO_TURN,
        /// `real`: share of the clip's cycles that are in the loop (stltsa_synthesize_loop),
        /// otherwise of the pieces' frames.
        Coverage = STLTSA_INFO_COVERAGE,
        /// `int`: cycles in the loop, if chosen among the clip's.
        LoopCycles = STLTSA_INFO_LOOP_CYCLES,
        /// `int`: cycles of the clip, if chosen among them.
        SourceCycles = STLTSA_INFO_SOURCE_CYCLES,
        /// Rows stltsa_warning: what a user should know about the result.
        Warning = STLTSA_INFO_WARNING,
        /// `text`: unit of lengths, such as mm; empty: unknown.
        LengthUnit = STLTSA_INFO_LENGTH_UNIT,
        /// `int`: axis that points up: 1, 2, 3 for x, y, z (TRC: y, by convention); 0: the file
        /// does not say.
        FileUpAxis = STLTSA_INFO_FILE_UP_AXIS,
        /// Rows stltsa_joint, parents first; none without a skeleton.
        Joint = STLTSA_INFO_JOINT,
        /// Rows stltsa_file_event, in order of time.
        FileEvent = STLTSA_INFO_FILE_EVENT,
        /// `int`: channels, columns or coordinates of each frame.
        Channels = STLTSA_INFO_CHANNELS,
        /// Array frames x (3 * joints): world positions by forward kinematics; none without a
        /// skeleton.
        Positions = STLTSA_INFO_POSITIONS,
        /// Array frames x (4 * joints): local rotations w x y z, with signs continuous over time;
        /// none without a skeleton.
        Rotations = STLTSA_INFO_ROTATIONS,
        /// Array frames x 1, of each frame of the file, in [0, 1); NaN outside cycles.
        Phase = STLTSA_INFO_PHASE,
        /// Array frames x 1: distance from the mean cycle in pose and velocity, as a share of the
        /// root mean square deviation of the motion; NaN outside cycles.
        PhaseResidual = STLTSA_INFO_PHASE_RESIDUAL,
        /// Array frames x 1: index of the cycle; -1 outside cycles.
        PhaseCycle = STLTSA_INFO_PHASE_CYCLE,
        /// `real[]`: of each label, the phase, in [0, 1), at which the body is at the same place in
        /// every clip and person with the same features, wherever their cycles begin: where the
        /// legs pass each other, if the two sides of the body are known and swing; 0: a label with
        /// repetitions only; NaN: one with neither.
        PhaseZero = STLTSA_INFO_PHASE_ZERO,
        /// `text[]`: the joint, or the point or column of the file, that each column of the
        /// features belongs to: makes the groups of stltsa_cycles_group_distance.
        Owner = STLTSA_INFO_OWNER,
        /// Array[] samples x columns: each cycle.
        Values = STLTSA_INFO_VALUES,
        /// Array[] samples x columns: mean over the cycles; of a comparison, of the first and the
        /// second motion, at phases of the first.
        Mean = STLTSA_INFO_MEAN,
        /// Array[] the same: standard deviation; of a single cycle, NaN.
        Deviation = STLTSA_INFO_DEVIATION,
        /// Array cycles x samples: the frame of each sample, not rounded.
        SampleFrames = STLTSA_INFO_SAMPLE_FRAMES,
        /// Array cycles x samples: how much later than in linear time, as a share of the cycle.
        Warp = STLTSA_INFO_WARP,
        /// Array cycles x 1: distance of each cycle from the mean, root mean square over samples
        /// and columns, as a share of the root of the variance along the mean cycle.
        Distance = STLTSA_INFO_DISTANCE,
        /// Array cycles x columns: root mean square over the samples, in the unit of the signal.
        ColumnDistance = STLTSA_INFO_COLUMN_DISTANCE,
        /// Rows stltsa_event, in order of time.
        Event = STLTSA_INFO_EVENT,
        /// `real`: correlation of the mean cycles of the two clips; 1 within a clip. Events of
        /// another person are to be trusted less below 0.95; below 0.6 it is another motion, and
        /// there are none.
        Likeness = STLTSA_INFO_LIKENESS,
        /// Rows stltsa_compared: one, about the whole.
        Comparison = STLTSA_INFO_COMPARISON,
        /// Rows stltsa_compared_motion: the first, the second.
        Motion = STLTSA_INFO_MOTION,
        /// Rows stltsa_compared_part: joints, points or columns, in the order of the first clip.
        Part = STLTSA_INFO_PART,
        /// Rows stltsa_compared_part: the coordinates of the parts, part by part.
        PartChannel = STLTSA_INFO_PART_CHANNEL,
        /// Array samples x channels: second minus first.
        Difference = STLTSA_INFO_DIFFERENCE,
        /// Array samples x channels: its standard error.
        StandardError = STLTSA_INFO_STANDARD_ERROR,
        /// Array samples x channels: half the width of its 95 % interval, which holds for one
        /// sample: of 100 samples without a difference, about five exclude 0 by chance.
        Margin = STLTSA_INFO_MARGIN,
        /// `text[]`: marks of the model, in the order in which they were kept.
        Mark = STLTSA_INFO_MARK,
    }
    /// Kinds of failure. Each function lists those that it can return.
    ErrorKind {
        /// NULL where not allowed, unknown key, value out of range.
        Argument = STLTSA_E_ARGUMENT,
        /// Rows, columns or strides do not match.
        Shape = STLTSA_E_SHAPE,
        /// A NaN, an infinity, or a number beyond 1e100, for which distances would overflow.
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
