// SPDX-License-Identifier: BSD-3-Clause
//! The constants of `stltsa.h`, in its order.

/// Versions of the header that these declarations were written from; see also `stltsa_version`.
pub const STLTSA_VERSION_MAJOR: i32 = 0;
pub const STLTSA_VERSION_MINOR: i32 = 1;
pub const STLTSA_VERSION_PATCH: i32 = 0;

pub const STLTSA_OK: i32 = 0;
pub const STLTSA_E_ARGUMENT: i32 = -1;
pub const STLTSA_E_SHAPE: i32 = -2;
pub const STLTSA_E_NOT_FINITE: i32 = -3;
pub const STLTSA_E_TOO_FEW_FRAMES: i32 = -4;
pub const STLTSA_E_NO_MEMORY: i32 = -5;
pub const STLTSA_E_IO: i32 = -6;
pub const STLTSA_E_FORMAT: i32 = -7;
pub const STLTSA_E_DISCONNECTED: i32 = -8;
pub const STLTSA_E_DEGENERATE: i32 = -9;
pub const STLTSA_E_NOT_CONVERGED: i32 = -10;
pub const STLTSA_E_CANCELLED: i32 = -11;
pub const STLTSA_E_UNSUPPORTED: i32 = -12;
pub const STLTSA_E_INTERNAL: i32 = -13;
pub const STLTSA_E_NO_COMMON_POSTURE: i32 = -14;

pub const STLTSA_F32: i32 = 1;
pub const STLTSA_F64: i32 = 2;

pub const STLTSA_NEIGHBORS: i32 = 1;
pub const STLTSA_WINDOW: i32 = 2;
pub const STLTSA_DIMENSION: i32 = 3;
pub const STLTSA_MODE: i32 = 4;
pub const STLTSA_INCLUDE_SELF: i32 = 5;
pub const STLTSA_LINKS: i32 = 6;
pub const STLTSA_EXCLUSION: i32 = 7;
pub const STLTSA_THREADS: i32 = 8;
pub const STLTSA_FEATURES: i32 = 9;
pub const STLTSA_UP_AXIS: i32 = 10;
pub const STLTSA_KEEP_START: i32 = 11;
pub const STLTSA_FPS: i32 = 12;
pub const STLTSA_RATE: i32 = 13;
pub const STLTSA_SMOOTHING: i32 = 14;
pub const STLTSA_PERIOD_MIN: i32 = 15;
pub const STLTSA_PERIOD_MAX: i32 = 16;
pub const STLTSA_EIGENGAP: i32 = 17;
pub const STLTSA_VARIANCE: i32 = 18;
pub const STLTSA_SKELETON: i32 = 19;
pub const STLTSA_KEEP_FRAMES: i32 = 20;
pub const STLTSA_MAP_NEIGHBORS: i32 = 21;
pub const STLTSA_MAP_BLEND: i32 = 22;
pub const STLTSA_HINT_WINDOW: i32 = 23;
pub const STLTSA_COMPONENT: i32 = 24;
pub const STLTSA_GAMMA: i32 = 25;
pub const STLTSA_KNOTS: i32 = 26;
pub const STLTSA_ROBUST: i32 = 27;
pub const STLTSA_CROSSFADE: i32 = 28;
pub const STLTSA_SEARCH: i32 = 29;
pub const STLTSA_POSTURE_LIMIT: i32 = 30;
pub const STLTSA_MEMORY_MAP: i32 = 31;

pub const STLTSA_MODE_TEMPORAL: i32 = 1;
pub const STLTSA_MODE_SPATIAL: i32 = 2;
pub const STLTSA_MODE_RECURRENT: i32 = 3;

pub const STLTSA_FEATURES_AUTO: i32 = 0;
pub const STLTSA_FEATURES_POSITIONS: i32 = 1;
pub const STLTSA_FEATURES_ROTATIONS6D: i32 = 2;
pub const STLTSA_FEATURES_EULER: i32 = 3;
pub const STLTSA_FEATURES_RAW: i32 = 4;

pub const STLTSA_TYPE_INT: i32 = 1;
pub const STLTSA_TYPE_REAL: i32 = 2;
pub const STLTSA_TYPE_TEXT: i32 = 3;

pub const STLTSA_STAGE_READ: i32 = 0;
pub const STLTSA_STAGE_FEATURES: i32 = 1;
pub const STLTSA_STAGE_NEIGHBORS: i32 = 2;
pub const STLTSA_STAGE_TANGENTS: i32 = 3;
pub const STLTSA_STAGE_ALIGNMENT: i32 = 4;
pub const STLTSA_STAGE_SPECTRUM: i32 = 5;
pub const STLTSA_STAGE_UNITS: i32 = 6;
pub const STLTSA_STAGE_MAP: i32 = 7;
pub const STLTSA_STAGE_DENOISE: i32 = 8;
pub const STLTSA_STAGE_SYNTHESIS: i32 = 9;

pub const STLTSA_FORMAT_BVH: i32 = 1;
pub const STLTSA_FORMAT_AMC: i32 = 2;
pub const STLTSA_FORMAT_CSV: i32 = 3;
pub const STLTSA_FORMAT_NPY: i32 = 4;
pub const STLTSA_FORMAT_MATRIX: i32 = 5;

pub const STLTSA_MODEL_FRAMES: i32 = 1;
pub const STLTSA_MODEL_FEATURES: i32 = 2;
pub const STLTSA_MODEL_DIMENSION: i32 = 3;
pub const STLTSA_MODEL_NEIGHBORS: i32 = 4;
pub const STLTSA_MODEL_WINDOW: i32 = 5;
pub const STLTSA_MODEL_MODE: i32 = 6;
pub const STLTSA_MODEL_INCLUDE_SELF: i32 = 7;
pub const STLTSA_MODEL_LINKS: i32 = 8;
pub const STLTSA_MODEL_EXCLUSION: i32 = 9;
pub const STLTSA_MODEL_COMPONENTS: i32 = 10;
pub const STLTSA_MODEL_REPEATED: i32 = 11;
pub const STLTSA_MODEL_RANK_DEFICIENT: i32 = 12;
pub const STLTSA_MODEL_SOLVES: i32 = 13;
pub const STLTSA_MODEL_FIRST_FRAME: i32 = 14;
pub const STLTSA_MODEL_FRAME_STEP: i32 = 15;
pub const STLTSA_MODEL_RESIDUAL: i32 = 16;
pub const STLTSA_MODEL_ERROR_ESTIMATE: i32 = 17;
pub const STLTSA_MODEL_GAP: i32 = 18;
pub const STLTSA_MODEL_CLOCK: i32 = 19;
pub const STLTSA_MODEL_FPS: i32 = 20;
pub const STLTSA_MODEL_PERIOD: i32 = 21;
pub const STLTSA_MODEL_SUPPORT: i32 = 22;

pub const STLTSA_UNIT_PREPARING: i32 = 1;
pub const STLTSA_UNIT_INITIAL: i32 = 2;
pub const STLTSA_UNIT_CYCLIC: i32 = 3;
pub const STLTSA_UNIT_FINAL: i32 = 4;
pub const STLTSA_UNIT_WIND_UP: i32 = 5;
pub const STLTSA_UNIT_ACTION: i32 = 6;
pub const STLTSA_UNIT_CYCLE: i32 = 7;

pub const STLTSA_DECOMPOSITION_SAMPLES: i32 = 1;
pub const STLTSA_DECOMPOSITION_FIRST_FRAME: i32 = 2;
pub const STLTSA_DECOMPOSITION_FRAME_STEP: i32 = 3;
pub const STLTSA_DECOMPOSITION_NEIGHBORS: i32 = 4;
pub const STLTSA_DECOMPOSITION_WINDOW: i32 = 5;
pub const STLTSA_DECOMPOSITION_DIMENSION: i32 = 6;
pub const STLTSA_DECOMPOSITION_COORDINATE: i32 = 7;
pub const STLTSA_DECOMPOSITION_REPRESENTATIVE: i32 = 8;
pub const STLTSA_DECOMPOSITION_BEST: i32 = 9;
pub const STLTSA_DECOMPOSITION_FEATURES: i32 = 10;
pub const STLTSA_DECOMPOSITION_PERIOD: i32 = 11;
pub const STLTSA_DECOMPOSITION_CYCLICITY: i32 = 12;
pub const STLTSA_DECOMPOSITION_LAG_QUALITY: i32 = 13;
pub const STLTSA_DECOMPOSITION_FPS: i32 = 14;

pub const STLTSA_DENOISING_ROWS: i32 = 1;
pub const STLTSA_DENOISING_COLUMNS: i32 = 2;
pub const STLTSA_DENOISING_MOVED: i32 = 3;
pub const STLTSA_DENOISING_GAMMA: i32 = 4;
pub const STLTSA_DENOISING_SHIFT: i32 = 5;
pub const STLTSA_DENOISING_NOISE: i32 = 6;
pub const STLTSA_DENOISING_FREEDOM: i32 = 7;
