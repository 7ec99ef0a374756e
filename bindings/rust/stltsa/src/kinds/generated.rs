// SPDX-License-Identifier: BSD-3-Clause
// Made by scripts/generate-bindings: do not edit.
kinds! {
    /// Which frames can be neighbors of a frame.
    Mode {
        /// The frames of the same clip within the window.
        Temporal = STLTSA_MODE_TEMPORAL,
        /// All frames; needs CHOLMOD.
        Spatial = STLTSA_MODE_SPATIAL,
        /// Those of the window and, as links, the frames outside the exclusion zone; needs CHOLMOD.
        Recurrent = STLTSA_MODE_RECURRENT,
    }
    /// Which numbers describe a pose.
    Features {
        /// Positions where there is a skeleton, else raw.
        Auto = STLTSA_FEATURES_AUTO,
        /// Joints and end sites, root position and yaw removed.
        Positions = STLTSA_FEATURES_POSITIONS,
        /// Two columns of each rotation matrix, root yaw removed.
        Rotations6d = STLTSA_FEATURES_ROTATIONS6D,
        /// The angles below the root in radians, unwrapped (the paper).
        Euler = STLTSA_FEATURES_EULER,
        /// The file's numbers.
        Raw = STLTSA_FEATURES_RAW,
    }
    /// The format that a clip was read from.
    Format {
        /// BVH.
        Bvh = STLTSA_FORMAT_BVH,
        /// AMC; needs its ASF: option skeleton, or found by subject number.
        Amc = STLTSA_FORMAT_AMC,
        /// Numbers split by , ; tab or blanks; a header line is optional.
        Csv = STLTSA_FORMAT_CSV,
        /// NumPy 1.0 to 3.0, 1-D or 2-D, float32 or float64, C or Fortran; others, as frames x
        /// joints x 3, are refused: reshape them.
        Npy = STLTSA_FORMAT_NPY,
        /// No file: stltsa_clip_from_matrix.
        Matrix = STLTSA_FORMAT_MATRIX,
    }
    /// Stages that a progress closure sees; a call has some of them.
    Stage {
        /// Reading a clip.
        Read = STLTSA_STAGE_READ,
        /// Features of its poses.
        Features = STLTSA_STAGE_FEATURES,
        /// Neighbors among all frames; temporal ones come with the tangents.
        Neighbors = STLTSA_STAGE_NEIGHBORS,
        /// Local tangents.
        Tangents = STLTSA_STAGE_TANGENTS,
        /// The alignment matrix.
        Alignment = STLTSA_STAGE_ALIGNMENT,
        /// Its smallest eigenvectors.
        Spectrum = STLTSA_STAGE_SPECTRUM,
        /// Units and cycles.
        Units = STLTSA_STAGE_UNITS,
        /// Mapping, either way.
        Map = STLTSA_STAGE_MAP,
        /// Denoising.
        Denoise = STLTSA_STAGE_DENOISE,
        /// New motion.
        Synthesis = STLTSA_STAGE_SYNTHESIS,
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
        /// Moving, and no cycle is claimed there.
        Action = STLTSA_UNIT_ACTION,
        /// One cycle of the cyclic unit.
        Cycle = STLTSA_UNIT_CYCLE,
    }
    /// Kinds of failure. Each function lists those that it can return.
    ErrorKind {
        /// NULL where not allowed, unknown key, value out of range.
        Argument = STLTSA_E_ARGUMENT,
        /// Rows, columns or strides do not fit.
        Shape = STLTSA_E_SHAPE,
        /// A NaN or an infinity among the numbers, or one beyond 1e100, where distances would be
        /// infinite.
        NotFinite = STLTSA_E_NOT_FINITE,
        /// Fewer (distinct) frames than the neighbors ask for.
        TooFewFrames = STLTSA_E_TOO_FEW_FRAMES,
        /// No memory, or rows * cols overflows.
        NoMemory = STLTSA_E_NO_MEMORY,
        /// A file cannot be opened, read or written.
        Io = STLTSA_E_IO,
        /// A file is not what its format says; text has the line.
        Format = STLTSA_E_FORMAT,
        /// The neighborhood graph falls apart and one was needed.
        Disconnected = STLTSA_E_DISCONNECTED,
        /// The frames do not vary, or not in enough directions.
        Degenerate = STLTSA_E_DEGENERATE,
        /// The eigensolver gave up.
        NotConverged = STLTSA_E_NOT_CONVERGED,
        /// The progress callback asked to stop.
        Cancelled = STLTSA_E_CANCELLED,
        /// Not in this build (CHOLMOD), or not for this clip.
        Unsupported = STLTSA_E_UNSUPPORTED,
        /// A defect of the library: please report.
        Internal = STLTSA_E_INTERNAL,
        /// Two pieces of motion have no posture at which to join.
        NoCommonPosture = STLTSA_E_NO_COMMON_POSTURE,
    }
}
