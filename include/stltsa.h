/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * libstltsa: motion clips as low-dimensional curves, motion units and cycles; for Linux.
 *
 * The method is spatio-temporal local tangent space alignment (STLTSA): Li, Niu, Zhang, Hu,
 * "Spatio-temporal LTSA and Its Application to Motion Decomposition", ICONIP 2012; LTSA itself:
 * Zhang, Zha, "Principal Manifolds and Nonlinear Dimension Reduction via Local Tangent Space
 * Alignment", SIAM J. Sci. Comput. 26, 2004. "Section" and "equation" below refer to the first.
 *
 * The shortest use takes three calls:
 *
 *     stltsa_clip *clip = NULL;
 *     stltsa_decomposition *units = NULL;
 *     if (stltsa_clip_open("walk.bvh", NULL, &clip) == STLTSA_OK &&
 *         stltsa_decompose(clip, NULL, &units) == STLTSA_OK) {
 *         const stltsa_info *info = stltsa_decomposition_info(units);
 *         stltsa_unit u;
 *         for (int64_t i = 0; i < stltsa_info_count(info, STLTSA_INFO_UNIT); ++i)
 *             if (stltsa_info_rows(info, STLTSA_INFO_UNIT, i, 1, &u, sizeof u) == STLTSA_OK)
 *                 printf("%s %.2f s .. %.2f s\n", stltsa_unit_name(u.kind), u.begin_s, u.end_s);
 *     } else {
 *         fprintf(stderr, "%s\n", stltsa_last_error());
 *     }
 *     stltsa_decomposition_free(units);
 *     stltsa_clip_free(clip);
 *
 * These rules apply to every function; below they are not repeated:
 *
 * Errors.      A function that can fail returns stltsa_status: STLTSA_OK (0) or a negative
 *              STLTSA_E_*. stltsa_last_error() then says what was wrong, where, and what to do.
 *              After a failure a handle output is NULL, arrays are unchanged, and the handles
 *              passed in remain usable. Comments name an error, as E_SHAPE, only where its meaning
 *              is special. The library does not print, install signal handlers, read the
 *              environment, change the floating-point mode, or end the process.
 * Ownership.   The caller owns every handle that a function creates, and frees it with the matching
 *              _free, which accepts NULL; texts and bytes returned through a char ** or unsigned
 *              char ** are freed with stltsa_free. A const char *, also in a row, and a stltsa_info
 *              are valid as long as the handle they came from. Inputs are read during the call
 *              only; if another thread changes them meanwhile, its results are meaningless.
 * Threads.     Any number of threads may use const handles at once; only one at a time may use a
 *              handle that is not const in the signature. ARPACK is not reentrant: the library
 *              solves one eigenproblem at a time, but cannot know of other users of the same
 *              libarpack in the process. The threads that a call starts end with it, so a process
 *              may fork between calls; a child forked during a call must exec or _exit. During a
 *              fit, OpenBLAS is set to one thread for the whole process, and then restored.
 * Determinism. The same input, options and build give the same bits on every run, for any number of
 *              threads. The entry of largest magnitude of each coordinate is positive.
 * Units.       Frames are the rows of arrays, and count from 0 in the source file. Intervals are
 *              half-open, [begin, end). Rotations are quaternions w x y z. Lengths are in the unit
 *              of the file. Seconds are frame / fps. Texts are UTF-8.
 * Structs.     Those that grow at their end carry the caller's sizeof: in lists as an argument, in
 *              others as the first member, size, which the caller sets. The library writes no more
 *              than that, and takes what is missing as 0. The others are frozen.
 * Options.     NULL means the defaults. An option that is not set has its default or, if its text
 *              says "auto", a value that the library chooses by the rule given there. No number
 *              means "auto": stltsa_options_unset restores it. Comments name the options that a
 *              function reads. Every function that takes options reports progress, on the thread
 *              that made the call, and can be cancelled (E_CANCELLED) if it takes long.
 */
#ifndef STLTSA_H
#define STLTSA_H

#include <stddef.h>
#include <stdint.h>

#define STLTSA_VERSION_MAJOR 0
#define STLTSA_VERSION_MINOR 2
#define STLTSA_VERSION_PATCH 0
#define STLTSA_VERSION_NUMBER                                                                      \
    (STLTSA_VERSION_MAJOR * 10000 + STLTSA_VERSION_MINOR * 100 + STLTSA_VERSION_PATCH)

#if !defined(__linux__)
#error "libstltsa runs on Linux only"
#endif
#define STLTSA_API __attribute__((visibility("default")))

#ifdef __cplusplus
#define STLTSA_NOEXCEPT noexcept
extern "C" {
#else
#define STLTSA_NOEXCEPT
#endif

/* ---- Status ----------------------------------------------------------------------------- */

typedef int32_t stltsa_status;

/* Values are never reused; new ones may be added: treat an unknown negative value as failure. */
enum {
    STLTSA_OK = 0,
    STLTSA_E_ARGUMENT = -1,      /* NULL where not allowed, unknown key, value out of range */
    STLTSA_E_SHAPE = -2,         /* rows, columns or strides do not match */
    STLTSA_E_NOT_FINITE = -3,    /* a NaN, an infinity, or a number beyond 1e100 */
    STLTSA_E_TOO_FEW_FRAMES = -4, /* fewer (distinct) frames than k requires */
    STLTSA_E_NO_MEMORY = -5,     /* no memory, or rows * cols overflows */
    STLTSA_E_IO = -6,            /* a file cannot be opened, read or written */
    STLTSA_E_FORMAT = -7,        /* a file violates its format; the text names the line */
    STLTSA_E_DISCONNECTED = -8,  /* a connected neighborhood graph was needed */
    STLTSA_E_DEGENERATE = -9,    /* the frames do not vary, or not in enough directions */
    STLTSA_E_NOT_CONVERGED = -10, /* the eigensolver did not converge */
    STLTSA_E_CANCELLED = -11,    /* the progress callback asked to stop */
    STLTSA_E_UNSUPPORTED = -12,  /* not supported for this clip, model or format */
    STLTSA_E_INTERNAL = -13,     /* a bug in the library; the text says where to report it */
    STLTSA_E_NO_COMMON_POSTURE = -14, /* two pieces have no common posture at which to join */
    STLTSA_E_NO_SUCH_PART = -15   /* a clip lacks the stretch that was asked for */
};

/* "STLTSA_E_SHAPE" and so on; "STLTSA_E_UNKNOWN" for values that this version does not know. */
STLTSA_API const char *stltsa_status_name(stltsa_status status) STLTSA_NOEXCEPT;
/* The text of this thread's last failure, valid until its next one; "" before any, never NULL. */
STLTSA_API const char *stltsa_last_error(void) STLTSA_NOEXCEPT;
/* The version of the library at run time, such as "0.1.0"; the header's may differ. */
STLTSA_API const char *stltsa_version(void) STLTSA_NOEXCEPT;

/* Optional parts of a build. */
enum {
    STLTSA_HAS_CHOLMOD = 1, /* modes spatial and recurrent use CHOLMOD; otherwise LDL, slower */
    STLTSA_HAS_OPENBLAS = 2 /* BLAS is OpenBLAS, which a fit sets to one thread and restores */
};
/* 1: this build has the part; 0: it does not, or the part is unknown. */
STLTSA_API int32_t stltsa_has(int32_t part) STLTSA_NOEXCEPT;
/* Frees a text or bytes that the caller owns, such as JSON; accepts NULL. */
STLTSA_API void stltsa_free(void *memory) STLTSA_NOEXCEPT;

/* ---- Arrays ----------------------------------------------------------------------------- */

/* dtype: IEEE float32, IEEE float64 or 64-bit integers, in native byte order. Real numbers may be
 * F32 or F64; rows, counts and labels are I64. */
enum { STLTSA_F32 = 1, STLTSA_F64 = 2, STLTSA_I64 = 3 };

/* The caller's array, rows x cols; a list is rows x 1. Strides are in bytes, may be negative, and
 * need not be multiples of the entry size; both 0: packed rows. Entries of an output must not
 * overlap. Set reserved to 0. Frozen, both. */
typedef struct stltsa_in {
    const void *data;
    int64_t rows, cols, row_stride, col_stride;
    int32_t dtype, reserved;
} stltsa_in;

typedef struct stltsa_out {
    void *data;
    int64_t rows, cols, row_stride, col_stride;
    int32_t dtype, reserved;
} stltsa_out;

/* ---- Options ---------------------------------------------------------------------------- */

typedef struct stltsa_options stltsa_options;

/* Keys. stltsa_option_describe() gives name, type, range, default and text of each; the command's
 * flags and the bindings' keywords come from that table. Options that say what to do are 1: yes, or
 * 0: no. If only one of period_min and period_max is set, the other yields to it. */
enum {
    STLTSA_OPT_NEIGHBORS = 1,   /* int  neighbors of each frame (k); auto: 1.2 periods, without a
                                   period 1.2 seconds, or 12 frames without a rate */
    STLTSA_OPT_WINDOW = 2,      /* int  window (w), frames to each side; auto: as neighbors */
    STLTSA_OPT_DIMENSION = 3,   /* int  tangent dimension, the number of coordinates (d); auto: 2 */
    STLTSA_OPT_MODE = 4,        /* int  candidates for neighbors: STLTSA_MODE_* */
    STLTSA_OPT_INCLUDE_SELF = 5, /* int  count a frame among its own neighbors */
    STLTSA_OPT_LINKS = 6,       /* int  recurrent: neighbors beyond the exclusion zone */
    STLTSA_OPT_EXCLUSION = 7,   /* int  recurrent: half width of that zone, frames; auto: window */
    STLTSA_OPT_THREADS = 8,     /* int  threads; auto: one for each core */
    STLTSA_OPT_FEATURES = 9,    /* int  description of a pose: STLTSA_FEATURES_*; auto: positions
                                   with a skeleton, points if columns are named so, otherwise raw */
    STLTSA_OPT_UP_AXIS = 10,    /* int  up axis: 1, 2, 3 for x, y, z; auto: found, or guessed */
    STLTSA_OPT_KEEP_START = 11, /* int  keep a T-pose at the start instead of dropping it */
    STLTSA_OPT_FPS = 12,        /* real frames per second, for files without a rate, or instead of
                                   theirs (not in batch); of unmapped points; auto: the file's, or
                                   the model's */
    STLTSA_OPT_SAMPLE_RATE = 13, /* real decimate clips to about this frame rate; 0: keep all */
    STLTSA_OPT_SMOOTHING = 14,  /* real smoothing of the features: sigma in seconds; 0: none */
    STLTSA_OPT_PERIOD_MIN = 15, /* real shortest period of the search, in seconds; in frames if the
                                   rate is unknown, 4 by default */
    STLTSA_OPT_PERIOD_MAX = 16, /* real longest period of the search, in seconds; in frames if the
                                   rate is unknown, half of all, at most 1000, by default */
    STLTSA_OPT_EIGENGAP = 17,   /* real smallest eigengap that counts (tau), as a share of k */
    STLTSA_OPT_VARIANCE = 18,   /* real share of local variance that local PCA must explain */
    STLTSA_OPT_SKELETON = 19,   /* text the ASF file of an AMC clip; auto: found beside the clip */
    STLTSA_OPT_KEEP_FRAMES = 20, /* int  keep the fitted frames in the model, so that it can map */
    STLTSA_OPT_MAP_NEIGHBORS = 21, /* int  rows for each local map; auto: d + 5, at least 10 */
    STLTSA_OPT_MAP_BLEND = 22,  /* int  local maps to blend, each from its own part of the curve */
    STLTSA_OPT_HINT_WINDOW = 23, /* int  rows to search on each side of a hint; auto: k / 5 */
    STLTSA_OPT_COMPONENT = 24,  /* int  component of the coordinates, from 0; auto: the only one */
    STLTSA_OPT_GAMMA = 25,      /* real distance from the curve beyond which a point is noisy; auto:
                                   one robust deviation of the residuals */
    STLTSA_OPT_KNOT_SPACING = 26, /* real seconds between knots, or rows if the rate is unknown;
                                   auto: a tenth of the period, otherwise 2 rows */
    STLTSA_OPT_ROBUST = 27,     /* int  reduce the influence of spikes on the curve */
    STLTSA_OPT_CROSSFADE = 28,  /* real seconds to blend on each side of a seam; auto: a tenth of
                                   the repeated cycle, or 0.15 between clips */
    STLTSA_OPT_CUT_RANGE = 29,  /* real seconds by which a cut may move; auto: a tenth of the
                                   repeated cycle; between clips half a cycle, at least 0.5 */
    STLTSA_OPT_POSTURE_LIMIT = 30, /* real max distance of the postures at a seam, relative to that
                                   of repetitions; 0: no limit */
    STLTSA_OPT_SEGMENTS = 32,   /* int  number of segments in motion; auto: as behavior changes */
    STLTSA_OPT_GAPS = 33,       /* int  what becomes of missing values: STLTSA_GAPS_* */
    STLTSA_OPT_MIN_CONFIDENCE = 34, /* real points seen with less confidence are missing */
    STLTSA_OPT_LOOP = 35,       /* int  make a loop: the last frame meets the first */
    STLTSA_OPT_IN_PLACE = 36,   /* int  remove the travel and the turn of a loop */
    STLTSA_OPT_INTRINSIC = 38,  /* int  also estimate the intrinsic dimension, in two ways */
    STLTSA_OPT_SUBJECT = 37     /* text person or animal in a file: the prefix of its points (Viktor
                                   of Viktor:LHEE) or its name; auto: the only one */
};

/* What becomes of missing values. Points or columns missing in more than half of the frames are
 * left out. Frames without most of the body for longer than 0.25 s are a rest with the reason
 * "nothing recorded", or at an end of the clip left out (docs/formats.md). */
enum {
    STLTSA_GAPS_FILL = 1,   /* up to 0.25 s: linear over time; longer ones: as skip */
    STLTSA_GAPS_REFUSE = 2, /* E_NOT_FINITE */
    STLTSA_GAPS_SKIP = 3    /* what the others in the frame imply, so that it adds no distance */
};

enum {
    STLTSA_MODE_TEMPORAL = 1, /* frames of the same clip within the window */
    STLTSA_MODE_SPATIAL = 2,  /* all frames */
    STLTSA_MODE_RECURRENT = 3 /* the window and, as links, what is beyond the exclusion zone */
};

enum {
    STLTSA_FEATURES_POSITIONS = 1,   /* joints and end sites, without root position and yaw */
    STLTSA_FEATURES_ROTATIONS6D = 2, /* two columns of each rotation matrix, without root yaw */
    STLTSA_FEATURES_EULER = 3,       /* angles below the root in radians, unwrapped (the paper) */
    STLTSA_FEATURES_RAW = 4,         /* the file's numbers */
    STLTSA_FEATURES_POINTS = 5       /* points, such as markers, without path and heading; auto if
                                        there are at least three (docs/formats.md) */
};

/* Types of options and keys. Rows and arrays: stltsa_info_rows, stltsa_info_array. */
enum {
    STLTSA_TYPE_INT = 1, STLTSA_TYPE_REAL = 2, STLTSA_TYPE_TEXT = 3,
    STLTSA_TYPE_ROWS = 4, STLTSA_TYPE_ARRAY = 5
};

/* Bits of stltsa_option_info.calls: the functions that read an option. */
enum {
    STLTSA_CALL_OPEN = 1,         /* stltsa_clip_open, _parse */
    STLTSA_CALL_FEATURES = 2,     /* stltsa_clip_features, _feature_count */
    STLTSA_CALL_FIT = 4,          /* stltsa_fit, _fit_clips */
    STLTSA_CALL_MAP = 16,         /* stltsa_map, _map_clip */
    STLTSA_CALL_UNMAP = 32,       /* stltsa_unmap, _unmap_clip */
    STLTSA_CALL_DECOMPOSE = 64,   /* stltsa_decompose */
    STLTSA_CALL_DENOISE = 128,    /* stltsa_denoise, _denoise_model */
    STLTSA_CALL_SYNTHESIZE = 256  /* stltsa_synthesize, _loop */
};

/* A row of the options table. `choices`: NULL, or "temporal=1 spatial=2" for named values. */
typedef struct stltsa_option_info {
    size_t size;
    int32_t key, type;
    const char *name;    /* "neighbors": the command's --neighbors */
    const char *text;    /* one sentence */
    const char *choices;
    double minimum, maximum; /* of ints and reals */
    double standard;     /* the default; NaN if automatic */
    int32_t automatic;   /* 1: no default; the library chooses as the text says after "auto" */
    int32_t calls;       /* STLTSA_CALL_*: the functions that read the option */
} stltsa_option_info;

/* Row `index`, from 0; E_ARGUMENT past the last one. */
STLTSA_API stltsa_status stltsa_option_describe(int64_t index, stltsa_option_info *info)
    STLTSA_NOEXCEPT;

STLTSA_API stltsa_status stltsa_options_new(stltsa_options **options) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_options_free(stltsa_options *options) STLTSA_NOEXCEPT;
/* Set one option; a text is copied. E_ARGUMENT: another type, an empty text, or out of range. */
STLTSA_API stltsa_status stltsa_options_set_int(stltsa_options *options, int32_t key,
    int64_t value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_options_set_real(stltsa_options *options, int32_t key,
    double value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_options_set_text(stltsa_options *options, int32_t key,
    const char *value) STLTSA_NOEXCEPT;
/* Restores the default or the automatic choice. */
STLTSA_API stltsa_status stltsa_options_unset(stltsa_options *options, int32_t key) STLTSA_NOEXCEPT;
/* 1: the option is set; 0: it is not, options is NULL, or the key is unknown. */
STLTSA_API int32_t stltsa_options_is_set(const stltsa_options *options, int32_t key)
    STLTSA_NOEXCEPT;
/* Read an option or its default; options may be NULL. E_ARGUMENT: automatic and not set. */
STLTSA_API stltsa_status stltsa_options_get_int(const stltsa_options *options, int32_t key,
    int64_t *value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_options_get_real(const stltsa_options *options, int32_t key,
    double *value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_options_get_text(const stltsa_options *options, int32_t key,
    const char **value) STLTSA_NOEXCEPT;

/* Stages that a progress callback receives. A call passes through some of them, in this order. */
enum {
    STLTSA_STAGE_READ = 0,      /* reading a clip */
    STLTSA_STAGE_FEATURES = 1,  /* features of its poses */
    STLTSA_STAGE_NEIGHBORS = 2, /* choice of k, neighbors; temporal ones are found with tangents */
    STLTSA_STAGE_TANGENTS = 3,  /* local tangents */
    STLTSA_STAGE_ALIGNMENT = 4, /* the alignment matrix */
    STLTSA_STAGE_SPECTRUM = 5,  /* its smallest eigenvectors */
    STLTSA_STAGE_UNITS = 6,     /* units and cycles */
    STLTSA_STAGE_MAP = 7,       /* mapping, in either direction */
    STLTSA_STAGE_DENOISE = 8,   /* denoising */
    STLTSA_STAGE_SYNTHESIS = 9, /* new motion */
    STLTSA_STAGE_WRITE = 10     /* writing a clip */
};

/* `fraction` of the stage is done, 0 to 1. It and the stage never decrease, but both may repeat, as
 * during the next fit of a decomposition. A fit of 300 frames makes about 20 callbacks, one of
 * 300 000 about 300. A nonzero return cancels (E_CANCELLED). It must not throw or long-jump through
 * the library. In the stage SPECTRUM it must not fit or decompose (E_ARGUMENT), nor wait for a
 * thread that does, which deadlocks: ARPACK solves one problem at a time. */
typedef int32_t (*stltsa_progress_fn)(void *user, int32_t stage, double fraction);

STLTSA_API stltsa_status stltsa_options_set_progress(stltsa_options *options,
    stltsa_progress_fn progress, void *user) STLTSA_NOEXCEPT;

/* ---- Facts, lists and arrays ------------------------------------------------------------ */

/* What a clip or a result says, by key: facts, lists and arrays. It belongs to the handle that it
 * came from; NULL for a NULL handle. */
typedef struct stltsa_info stltsa_info;

/* Keys. stltsa_info_describe() gives name, type and text of each. A key with [] has any number of
 * values; any other has one, or none if the handle lacks that fact. `rows` are structs of the type
 * that is named; `array` is a matrix of real numbers, with its shape; [] has several. */
enum {
    /* Where the frames come from. Of these four a result of a matrix has none. */
    STLTSA_INFO_PATH = 1,           /* text[] path of the clip as given; empty: from memory */
    STLTSA_INFO_FORMAT = 2,         /* int[]  STLTSA_FORMAT_* of the clip */
    STLTSA_INFO_CLIP_FRAMES = 3,    /* int[]  frames of the clip */
    STLTSA_INFO_CLIP_FPS = 4,       /* real[] frames a second of the clip; 0: unknown */
    STLTSA_INFO_NOTE = 5,           /* text[] what was assumed of the clip, and removed from it */
    STLTSA_INFO_CHANNEL = 6,        /* text[] names of its channels, if the file has names */
    STLTSA_INFO_FEATURES = 7,       /* int    STLTSA_FEATURES_* used */
    STLTSA_INFO_FEATURE_COUNT = 8,  /* int    columns of the features */
    STLTSA_INFO_UP_AXIS = 9,        /* int    up axis: 1, 2, 3 for x, y, z; 0: not needed */
    STLTSA_INFO_SMOOTHING = 10,     /* real   sigma of the smoothing, in seconds; 0: none */
    STLTSA_INFO_ROWS = 11,          /* int    rows that the method worked on */
    STLTSA_INFO_LENGTH = 12,        /* int[]  rows of each clip; of a denoising, of each spline */
    STLTSA_INFO_FIRST_FRAME = 13,   /* int[]  row i is frame first_frame + i * frame_step */
    STLTSA_INFO_FRAME_STEP = 14,    /* int[]  see first_frame; 1 for matrices */
    STLTSA_INFO_FPS = 15,           /* real   rows a second; 0: unknown */
    STLTSA_INFO_BODY_ROOT = 16,     /* int    joint that turns the body; its ancestors do not */
    /* The fit; of a decomposition, that of about 12 cycles at the start of the longest cyclic
     * segment, with 24 rows a cycle; not of a denoising of given coordinates. */
    STLTSA_INFO_MODE = 20,          /* int    STLTSA_MODE_* */
    STLTSA_INFO_NEIGHBORS = 21,     /* int    k used, in rows */
    STLTSA_INFO_WINDOW = 22,        /* int    w used, in rows to each side */
    STLTSA_INFO_DIMENSION = 23,     /* int    tangent dimension d */
    STLTSA_INFO_INCLUDE_SELF = 24,  /* int    1: a row is among its own neighbors */
    STLTSA_INFO_LINKS = 25,         /* int    recurrent: neighbors beyond the exclusion zone */
    STLTSA_INFO_EXCLUSION = 26,     /* int    recurrent: half width of that zone in rows */
    /* The period, if one was looked for. */
    STLTSA_INFO_PERIOD = 30,        /* real   period in seconds; 0: none, or rate unknown */
    STLTSA_INFO_LAG_QUALITY = 31,   /* real   match of velocities a period apart, 0 to 1 */
    STLTSA_INFO_PERIOD_MIN = 32,    /* real   shortest period of the search, seconds; 0: none */
    STLTSA_INFO_PERIOD_MAX = 33,    /* real   longest period of the search, seconds; 0: none */
    STLTSA_INFO_PERIOD_ROWS = 34,   /* real   period in rows; 0: none */
    /* Models. */
    STLTSA_INFO_REPEATED = 40,      /* int    rows collapsed because they repeat the one before */
    STLTSA_INFO_TIME_CORRELATION = 41, /* real   |rank correlation| of coordinate 1 and time */
    STLTSA_INFO_REACH = 42,         /* real   distance from the fitted frames up to which a frame is
                                       like them; 0: the model cannot map */
    STLTSA_INFO_COMPONENT = 43,     /* rows   stltsa_component: those of the neighborhood graph */
    STLTSA_INFO_HAS_CYCLE = 44,     /* int    1: keeps a mean cycle (stltsa_model_keep_cycle) */
    STLTSA_INFO_COORDS = 45,        /* array  rows x d: coordinates; of a decomposition, rows x 2:
                                       the curve, and itself a quarter cycle behind */
    STLTSA_INFO_EIGENVALUES = 46,   /* array  components x (d + 2), ascending from lambda_1 = 0;
                                       NaN: the component is too small */
    STLTSA_INFO_COMPONENT_OF = 47,  /* array  rows x 1: component of each row, in order, from 0 */
    /* Decompositions. */
    STLTSA_INFO_COORDINATE = 60,    /* int    coordinate whose margins count, from 1; 0: none */
    STLTSA_INFO_CYCLICITY = 61,     /* real   how well that coordinate repeats; 1: perfect */
    STLTSA_INFO_REPRESENTATIVE = 62, /* int    first cycle of the longest cyclic segment, or -1 */
    STLTSA_INFO_BEST = 63,          /* int    cycle there that is most like the mean; -1: none */
    STLTSA_INFO_REASON = 64,        /* text   why nothing repeats; empty if anything does */
    STLTSA_INFO_EIGENVALUE = 65,    /* real[] eigenvalues of B, ascending; of a model, of B / k */
    STLTSA_INFO_POSTURES = 68,      /* int[]  up to 24 distinct frames for pictures, best first */
    STLTSA_INFO_SEGMENT = 50,       /* rows   stltsa_segment, in order; they cover the clip */
    STLTSA_INFO_UNIT = 51,          /* rows   stltsa_unit, in order; they cover the clip, too */
    STLTSA_INFO_CYCLE = 52,         /* rows   stltsa_part, in order */
    STLTSA_INFO_STEP = 53,          /* rows   stltsa_part: half cycles, if sides alternate */
    STLTSA_INFO_REPETITION = 54,    /* rows   stltsa_part: the actions of repetitions */
    STLTSA_INFO_SUMMARY = 55,       /* rows   stltsa_summary: one for each label that repeats */
    STLTSA_INFO_SIDE = 56,          /* int[]  STLTSA_SIDE_* of sides 0 and 1, in right-handed axes;
                                       STLTSA_SIDE_NONE: no names tell */
    STLTSA_INFO_CURVE = 57,         /* array  rows x 1: smoothed coordinate of each cyclic segment,
                                       else 0; of a denoising, rows x columns: the curve f_c */
    STLTSA_INFO_LABEL_LIKENESS = 58, /* array  labels x labels: mean likeness of segments, 0 to 1;
                                       from about 0.65 on they share a label; NaN: a single
                                       segment */
    /* Models fitted with option intrinsic (section 2.3): two estimates, which need not agree, as
     * the eigengap depends on the tangent dimension d (docs/method.md). */
    STLTSA_INFO_LOCAL_PCA = 66,     /* int    intrinsic dimension by local PCA; 0: cannot tell */
    STLTSA_INFO_EIGENGAP = 67,      /* int    intrinsic dimension by the eigengap; 0: cannot tell */
    STLTSA_INFO_LOCAL_PCA_REASON = 70, /* text   why local PCA cannot tell; empty if it can */
    STLTSA_INFO_EIGENGAP_REASON = 71, /* text   why the eigengap cannot tell; empty if it can */
    STLTSA_INFO_VARIANCE = 72,      /* real   share of local variance that local PCA must explain */
    STLTSA_INFO_EIGENGAP_THRESHOLD = 73, /* real   tau of section 2.3 as a fraction of k */
    STLTSA_INFO_LOCAL_VARIANCE = 74, /* real[] mean share of variance of each local direction */
    /* Denoisings. */
    STLTSA_INFO_COLUMN = 80,        /* rows   stltsa_denoised_column: one for each column */
    STLTSA_INFO_CLEANED = 81,       /* array  rows x columns: the points after equation (1) */
    STLTSA_INFO_MOVES = 82,         /* array  rows x columns: how far each point was moved */
    STLTSA_INFO_GAMMA_OPTION = 85,  /* real   option gamma; none: chosen for each column */
    STLTSA_INFO_KNOT_ROWS = 86,     /* real   rows between the knots of the curve */
    STLTSA_INFO_ROBUST = 87,        /* int    1: the influence of spikes is reduced */
    STLTSA_INFO_FIT_PERIOD_MIN = 88, /* real   period_min of the coordinates' model; 0: none */
    STLTSA_INFO_FIT_PERIOD_MAX = 89, /* real   period_max of that model; 0: none */
    STLTSA_INFO_NOTHING_TO_CLEAN = 92, /* int    1: noise is below 0.5 % of each column's range */
    /* Syntheses. */
    STLTSA_INFO_CROSSFADE = 100,    /* real   option crossfade; none: chosen for each seam */
    STLTSA_INFO_CUT_RANGE = 101,    /* real   option cut_range; none: chosen for each seam */
    STLTSA_INFO_POSTURE_LIMIT = 102, /* real   option posture_limit; 0: none */
    STLTSA_INFO_PIECE = 103,        /* rows   stltsa_piece_fact: what was joined */
    STLTSA_INFO_SEAM = 104,         /* rows   stltsa_seam, in order */
    STLTSA_INFO_LOOP = 107,         /* int    1: a loop; only loops have the next six facts */
    STLTSA_INFO_IN_PLACE = 108,     /* int    option in_place; 1: travel and turn are removed */
    STLTSA_INFO_TRAVEL = 109,       /* real[] x, y, z of a loop's travel along the ground */
    STLTSA_INFO_TURN = 110,         /* real   degrees that a loop turns, positive to the left */
    STLTSA_INFO_COVERAGE = 111,     /* real   share of cycles, or pieces' frames, in the loop */
    STLTSA_INFO_LOOP_CYCLES = 112,  /* int    cycles in the loop, if chosen among the clip's */
    STLTSA_INFO_SOURCE_CYCLES = 113, /* int    cycles of the clip, if chosen among them */
    /* Everything but clips and streams. */
    STLTSA_INFO_WARNING = 120,      /* rows   stltsa_warning: what to know about the result */
    /* Clips: what the file states; joints, positions and rotations are of skeletons. */
    STLTSA_INFO_LENGTH_UNIT = 130,  /* text   unit of lengths, such as mm; empty: unknown */
    STLTSA_INFO_FILE_UP_AXIS = 131, /* int    up axis that the file states (TRC: y); 0: none */
    STLTSA_INFO_JOINT = 132,        /* rows   stltsa_joint, parents first */
    STLTSA_INFO_FILE_EVENT = 133,   /* rows   stltsa_file_event, in order of time */
    STLTSA_INFO_CHANNELS = 134,     /* int    channels, columns or coordinates of each frame */
    STLTSA_INFO_POSITIONS = 135,    /* array  frames x (3 * joints): positions in the world */
    STLTSA_INFO_ROTATIONS = 136,    /* array  frames x (4 * joints): local, w x y z, continuous */
    /* Phases. */
    STLTSA_INFO_PHASE = 140,        /* array  frames of the file x 1, in [0, 1); NaN: no cycle */
    STLTSA_INFO_PHASE_RESIDUAL = 141, /* array  frames x 1: distance from the mean cycle, as a share
                                       of the motion's rms deviation; NaN: no cycle */
    STLTSA_INFO_PHASE_CYCLE = 142,  /* array  frames x 1: index of the cycle; -1: no cycle */
    STLTSA_INFO_PHASE_ZERO = 143,   /* real[] of each label, phase of a place that all clips with
                                       these features share; 0: only repetitions; NaN: neither */
    STLTSA_INFO_OWNER = 144,        /* text[] joint, point or column of each feature */
    /* Signals over cycles. */
    STLTSA_INFO_VALUES = 150,       /* array[] samples x columns: each cycle */
    STLTSA_INFO_MEAN = 151,         /* array[] samples x columns: mean of the cycles; of a
                                       comparison, of both motions, at phases of the first */
    STLTSA_INFO_DEVIATION = 152,    /* array[] the same: standard deviation; of one cycle, NaN */
    STLTSA_INFO_SAMPLE_FRAMES = 153, /* array  cycles x samples: frame of each, not rounded */
    STLTSA_INFO_WARP = 154,         /* array  cycles x samples: delay, as a share of the cycle */
    STLTSA_INFO_DISTANCE = 155,     /* array  cycles x 1: rms distance from the mean cycle, as a
                                       share of the deviation along it */
    STLTSA_INFO_COLUMN_DISTANCE = 156, /* array  cycles x columns: the same, in the signal's unit */
    /* Events. */
    STLTSA_INFO_EVENT = 160,        /* rows   stltsa_event, in order of time */
    STLTSA_INFO_LIKENESS = 161,     /* real   correlation of both mean cycles, 1 within a clip;
                                       below 0.95 events are less sure, below 0.6 there are none */
    /* Comparisons. */
    STLTSA_INFO_COMPARISON = 170,   /* rows   stltsa_compared: one, about the whole */
    STLTSA_INFO_MOTION = 171,       /* rows   stltsa_compared_motion: the first, the second */
    STLTSA_INFO_PART = 172,         /* rows   stltsa_compared_part: joints, points or columns */
    STLTSA_INFO_PART_CHANNEL = 173, /* rows   stltsa_compared_part: coordinates, part by part */
    STLTSA_INFO_DIFFERENCE = 174,   /* array  samples x channels: second minus first */
    STLTSA_INFO_STANDARD_ERROR = 175, /* array  samples x channels: its standard error */
    STLTSA_INFO_MARGIN = 176,       /* array  samples x channels: half a pointwise 95 % interval */
    /* Streams. */
    STLTSA_INFO_MARK = 180          /* text[] marks of the model, in the order they were kept */
};

/* Kinds of warnings; new ones may be added. Those of a synthesis have the time of their seam. */
enum {
    STLTSA_WARNING_FOLLOWS_TIME = 1,    /* coordinate 1 only follows time */
    STLTSA_WARNING_RANK_DEFICIENT = 2,  /* windows vary in fewer than d directions */
    STLTSA_WARNING_SMALL_GAP = 3,       /* another dimension is better defined */
    STLTSA_WARNING_UNSCALED = 4,        /* rounding may rotate a direction: scale the features */
    STLTSA_WARNING_INACCURATE = 5,      /* eigenvalues at the limit of double precision */
    STLTSA_WARNING_DISCONNECTED = 6,    /* the neighborhood graph has several components */
    STLTSA_WARNING_JUMP = 7,            /* the pose jumps */
    STLTSA_WARNING_SEPARATE_MOTION = 8, /* a motion that was not searched for cycles */
    STLTSA_WARNING_OFFSETS_DIFFER = 9,  /* clips joined have slightly different skeletons */
    STLTSA_WARNING_RESAMPLED = 10,      /* a clip was resampled to the first one's frame rate */
    STLTSA_WARNING_SEAM_POSTURE = 11,   /* postures at a seam are far apart */
    STLTSA_WARNING_SEAM_SPEED = 12,     /* unusually fast near a seam */
    STLTSA_WARNING_SEAM_ACCELERATION = 13, /* unusual acceleration near a seam */
    STLTSA_WARNING_NOT_BLENDED = 14,    /* no frames beyond the cuts of a seam to blend */
    STLTSA_WARNING_NO_ORDER = 15,       /* consecutive rows are no closer than random ones */
    STLTSA_WARNING_LINEAR_PHASE = 16,   /* phases that are linear in time, so less sure */
    STLTSA_WARNING_SEVERAL_PLACES = 17, /* marks at several places of the cycle */
    STLTSA_WARNING_NOT_FOUND = 18,      /* repetitions without the event */
    STLTSA_WARNING_FEW_CYCLES = 19,     /* too few cycles for intervals */
    STLTSA_WARNING_NOT_ALIKE = 20,      /* the motions seem to be different */
    STLTSA_WARNING_UNCERTAIN_SHIFT = 21, /* another shift is nearly as good */
    STLTSA_WARNING_SIZES_DIFFER = 22    /* bodies of different size or unit */
};

/* Number of values, rows or arrays of a key; 0: none, or an unknown key. */
STLTSA_API int64_t stltsa_info_count(const stltsa_info *info, int32_t key) STLTSA_NOEXCEPT;
/* One value; index 0 if the key has only one. E_ARGUMENT: the handle lacks it, or another type. */
STLTSA_API stltsa_status stltsa_info_int(const stltsa_info *info, int32_t key, int64_t index,
    int64_t *value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_info_real(const stltsa_info *info, int32_t key, int64_t index,
    double *value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_info_text(const stltsa_info *info, int32_t key, int64_t index,
    const char **value) STLTSA_NOEXCEPT;
/* Copies rows [begin, begin + count) of a list to an array of the struct that the key names.
 * row_size: its sizeof. E_ARGUMENT: one of these rows is not there; nothing is written then. */
STLTSA_API stltsa_status stltsa_info_rows(const stltsa_info *info, int32_t key, int64_t begin,
    int64_t count, void *rows, size_t row_size) STLTSA_NOEXCEPT;
/* Writes an array, as F32, F64 or, if its numbers are whole, I64. index: which of several, or 0. */
STLTSA_API stltsa_status stltsa_info_array(const stltsa_info *info, int32_t key, int64_t index,
    const stltsa_out *array) STLTSA_NOEXCEPT;
/* Its shape, that of all arrays of a key. */
STLTSA_API stltsa_status stltsa_info_shape(const stltsa_info *info, int32_t key, int64_t *rows,
    int64_t *cols) STLTSA_NOEXCEPT;
/* The JSON object of a clip, a model, a decomposition, a comparison, a denoising or a synthesis
 * (docs/schema). E_UNSUPPORTED: other handles. */
STLTSA_API stltsa_status stltsa_info_json(const stltsa_info *info, char **json) STLTSA_NOEXCEPT;

/* A warning. A row. */
typedef struct stltsa_warning {
    int64_t code;          /* STLTSA_WARNING_* */
    const char *text;      /* what it is about, and what to do */
    double begin_s;        /* seconds in the clip at which it applies; NaN: it has no time */
    double end_s;          /* the end, or the begin of a moment; NaN: it has no time */
} stltsa_warning;

/* Bits of stltsa_info_key.handles. */
enum {
    STLTSA_HANDLE_CLIP = 1, STLTSA_HANDLE_MODEL = 2, STLTSA_HANDLE_PHASE = 4,
    STLTSA_HANDLE_DECOMPOSITION = 8, STLTSA_HANDLE_DENOISING = 16, STLTSA_HANDLE_SYNTHESIS = 32,
    STLTSA_HANDLE_CYCLES = 64, STLTSA_HANDLE_EVENTS = 128, STLTSA_HANDLE_COMPARISON = 256,
    STLTSA_HANDLE_LIVE = 512
};

/* A row of the table of facts. `choices` as in stltsa_option_info. */
typedef struct stltsa_info_key {
    size_t size;
    int32_t key, type;   /* STLTSA_INFO_*, STLTSA_TYPE_* */
    const char *name;    /* "neighbors" */
    const char *text;    /* one sentence */
    const char *choices;
    int32_t is_list;     /* 1: any number of values */
    int32_t handles;     /* handles that can have the fact: sum of STLTSA_HANDLE_* */
} stltsa_info_key;

/* Row `index`, from 0; E_ARGUMENT past the last one. */
STLTSA_API stltsa_status stltsa_info_describe(int64_t index, stltsa_info_key *key) STLTSA_NOEXCEPT;

/* ---- Clips ------------------------------------------------------------------------------ */

typedef struct stltsa_clip stltsa_clip;

/* docs/formats.md lists what is read of each. */
enum {
    STLTSA_FORMAT_BVH = 1,      /* BVH */
    STLTSA_FORMAT_AMC = 2,      /* needs its ASF: option skeleton, or found by subject number */
    STLTSA_FORMAT_CSV = 3,      /* numbers split by , ; tab or blanks, with or without header lines;
                                   columns x, y, z of points make a clip of points */
    STLTSA_FORMAT_NPY = 4,      /* frames, frames x columns, or frames x points x 2 or 3 */
    STLTSA_FORMAT_MATRIX = 5,   /* no file: stltsa_clip_from_matrix */
    STLTSA_FORMAT_POINTS = 6,   /* no file: stltsa_clip_from_points */
    STLTSA_FORMAT_SKELETON = 7, /* no file: stltsa_clip_from_skeleton */
    STLTSA_FORMAT_GLB = 8,      /* glTF 2.0, binary: only written */
    STLTSA_FORMAT_C3D = 9,      /* points and events, of any processor: only read */
    STLTSA_FORMAT_TRC = 10,     /* markers; y is up, by convention: only read */
    STLTSA_FORMAT_MOT = 11      /* MOT and STO of OpenSim, such as joint coordinates: only read */
};

/* Reads a clip. The suffix decides the format, or the content if the suffix is unknown. A folder of
 * a BIDS dataset stands for the one *_motion.tsv in it. Options: fps, skeleton, subject,
 * min_confidence. E_ARGUMENT: several subjects or such files; the text lists them. */
STLTSA_API stltsa_status stltsa_clip_open(const char *path, const stltsa_options *options,
    stltsa_clip **clip) STLTSA_NOEXCEPT;
/* The same, or a stretch whose name follows the path: "walk.bvh:2.5s-9s" (stltsa_clip_stretch); a
 * file of exactly this name comes first. Options of stltsa_decompose, too. */
STLTSA_API stltsa_status stltsa_clip_open_stretch(const char *text, const stltsa_options *options,
    stltsa_clip **clip) STLTSA_NOEXCEPT;
/* The same from memory; format 0: the content decides. name: NULL, or the path for messages. */
STLTSA_API stltsa_status stltsa_clip_parse(const void *bytes, size_t size, int32_t format,
    const char *name, const stltsa_options *options, stltsa_clip **clip) STLTSA_NOEXCEPT;
/* A clip without a skeleton from a matrix, rows = frames, which is copied. fps: 1e-9 to 1e6. */
STLTSA_API stltsa_status stltsa_clip_from_matrix(const stltsa_in *frames, double fps,
    stltsa_clip **clip) STLTSA_NOEXCEPT;

/* Points in space or in a plane, such as markers or key points. What is not used is 0 or NULL. */
typedef struct stltsa_points {
    size_t size;
    int32_t space, reserved;  /* coordinates of a point: 2 or 3 */
    stltsa_in positions;      /* frames x (space * points); a point of NaN, or all 0, is missing */
    const char *const *names; /* one per point; NULL: they have none */
    stltsa_in confidence;     /* frames x points, 0: missing; data NULL: all are seen */
    stltsa_in times;          /* frames x 1, seconds, increasing; data NULL: even, by fps */
    double fps;               /* 0: given by the times; otherwise both must agree within 1 % */
} stltsa_points;

/* A clip of points, which are copied. Frames at uneven times are resampled to the rate of the usual
 * step, with a note; frames that are missing there are gaps. Option: min_confidence. E_ARGUMENT:
 * times that do not increase, no rate, or one that differs from fps or is not from 1e-9 to 1e6.
 * E_FORMAT: more frames are missing than there are. */
STLTSA_API stltsa_status stltsa_clip_from_points(const stltsa_points *points,
    const stltsa_options *options, stltsa_clip **clip) STLTSA_NOEXCEPT;

/* A joint or an end site of a skeleton. A row; input as well. */
typedef struct stltsa_joint {
    const char *name;      /* not empty */
    int64_t parent;        /* index of an earlier joint; -1: the root, which is joint 0 */
    double offset[3];      /* from the parent, in the parent's axes; unit of the clip */
    /* Its values in each frame, in order: tx ty tz positions, which replace the offset (+tx +ty +tz
     * add to it), rx ry rz angles in degrees about moving axes, of which the first is the leftmost
     * matrix. "": none. NULL, as input: rz rx ry, for the root after tx ty tz, none for end sites;
     * as output: those of an ASF file, which this cannot describe. */
    const char *channels;
    int64_t is_end_site;   /* 1: the end of a chain, without rotation */
} stltsa_joint;

/* Forms of rotations. */
enum {
    STLTSA_ROTATIONS_QUATERNION = 1, /* 4 columns a joint: w x y z, of length 1 within 0.05 */
    STLTSA_ROTATIONS_MATRIX = 2,     /* 9 columns a joint: the rows of its rotation matrix */
    STLTSA_ROTATIONS_CHANNELS = 3    /* a column for each channel of each joint */
};

/* A clip of a skeleton, which is copied: joints (joint_size: sizeof(stltsa_joint)), local rotations
 * (child to parent axes; frames x columns of all joints) and positions of the root (frames x 3;
 * NULL: it stays at its offset, or the channels say where it is). Quaternions and matrices become
 * the angles of the channels nearest to those of the frame before; channels keep their bits. fps:
 * 1e-9 to 1e6. */
STLTSA_API stltsa_status stltsa_clip_from_skeleton(const stltsa_joint *joints, size_t joint_size,
    int64_t count, int32_t form, const stltsa_in *rotations, const stltsa_in *root_positions,
    double fps, stltsa_clip **clip) STLTSA_NOEXCEPT;
/* Sets the path of a clip made from arrays, for messages and results; NULL clears it. A path that
 * stltsa_info_text gave before is no longer valid. */
STLTSA_API stltsa_status stltsa_clip_set_path(stltsa_clip *clip, const char *path) STLTSA_NOEXCEPT;

/* A stretch of a clip, as a clip: its frames count from 0 again, which a note says. `what` is
 *   300-900, 2.5s-9s       frames [300, 900), seconds; one end may be left out
 *   cyclic, action, ...    the longest unit of this kind (stltsa_unit_name)
 *   cycle3, segment2, ...  cycle, segment or repetition, counted from 1
 *   best, representative   a cycle
 *   A                      all segments of this label, in order, with breaks between them
 * All but the first need a decomposition: options as stltsa_decompose. E_NO_SUCH_PART. */
STLTSA_API stltsa_status stltsa_clip_stretch(const stltsa_clip *clip, const char *what,
    const stltsa_options *options, stltsa_clip **stretch) STLTSA_NOEXCEPT;
/* The mirror image of a clip: what the left side did, the right one does. Joints or points whose
 * names differ in the side only (LeftFoot and RightFoot, L_toe and R_toe) change places. Option:
 * up_axis. E_UNSUPPORTED: no two such names, a skeleton whose sides differ, or a matrix. */
STLTSA_API stltsa_status stltsa_clip_mirror(const stltsa_clip *clip, const stltsa_options *options,
    stltsa_clip **mirrored) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_clip_free(stltsa_clip *clip) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_clip_info(const stltsa_clip *clip) STLTSA_NOEXCEPT;

STLTSA_API int64_t stltsa_clip_frames(const stltsa_clip *clip) STLTSA_NOEXCEPT;
STLTSA_API double stltsa_clip_fps(const stltsa_clip *clip) STLTSA_NOEXCEPT; /* 0: unknown */

/* Something that the file says happens, such as a foot strike in C3D. A row. */
typedef struct stltsa_file_event {
    const char *label;   /* "Foot Strike" */
    const char *context; /* what it happens to, such as "Left"; may be "" */
    double frame;        /* of the clip, not rounded; may lie outside it */
    double seconds;      /* from the first frame of the clip; NaN if the rate is unknown */
} stltsa_file_event;

/* Features of every frame, not smoothed: frames x count. Options: features, up_axis, gaps. */
STLTSA_API stltsa_status stltsa_clip_feature_count(const stltsa_clip *clip,
    const stltsa_options *options, int64_t *count) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_clip_features(const stltsa_clip *clip,
    const stltsa_options *options, const stltsa_out *features) STLTSA_NOEXCEPT;

/* Writes a clip, completely or not at all. Its suffix: .bvh (any skeleton), .amc (clips read from
 * AMC, with their ASF file beside it), .csv, .npy (any clip), which read back to the same bits, or
 * .glb (skeleton and animation, or moving points; 32-bit). E_UNSUPPORTED: the clip lacks the
 * skeleton or frame rate that the format needs. E_IO: also if another skeleton is in the place of
 * the ASF file. */
STLTSA_API stltsa_status stltsa_clip_save(const stltsa_clip *clip, const char *path,
    const stltsa_options *options) STLTSA_NOEXCEPT;

/* ---- The manifold curve: STLTSA --------------------------------------------------------- */

typedef struct stltsa_model stltsa_model;

/* Fits a model to frames x features (at most 1e100, but arbitrarily small; at least k + 1 distinct
 * frames in a row). Section 2.2. Several clips follow one another in `frames`; `lengths`, clips x
 * 1, I64, has the frames of each; NULL: one clip. Temporal neighbors never cross clips. Each
 * connected component of the neighborhood graph is embedded separately (columns centered, of unit
 * norm): check STLTSA_INFO_COMPONENT before you compare coordinates. Repeated frames are collapsed
 * and get the coordinates of the frame they repeat. Options: neighbors, window, dimension, mode,
 * include_self, links, exclusion, threads, fps (for the automatic k), period_min, period_max,
 * keep_frames, intrinsic. E_ARGUMENT: d + 2 <= k <= w + 1 is required. Memory: docs/method.md. */
STLTSA_API stltsa_status stltsa_fit(const stltsa_in *frames, const stltsa_in *lengths,
    const stltsa_options *options, stltsa_model **model) STLTSA_NOEXCEPT;
/* The same from the features of clips, each prepared separately: without a T-pose at its start and
 * frames without the body at either end, smoothed and decimated. Row i is frame
 * STLTSA_INFO_FIRST_FRAME + i * STLTSA_INFO_FRAME_STEP. Temporal neighbors do not cross a break
 * (stretches that were joined, as in "walk.bvh:A") nor the middle of a gap that is too long to
 * fill; a note says where. Up axis and skeleton are those of the first clip. E_TOO_FEW_FRAMES:
 * between two breaks. E_SHAPE: clips differ in joints, channels, features or decimated rate. */
STLTSA_API stltsa_status stltsa_fit_clips(const stltsa_clip *const *clips, int64_t count,
    const stltsa_options *options, stltsa_model **model) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_model_free(stltsa_model *model) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_model_info(const stltsa_model *model) STLTSA_NOEXCEPT;

/* A connected component of the neighborhood graph of a fit. A row. */
typedef struct stltsa_component {
    int64_t frames;             /* distinct rows */
    double residual;            /* largest ||B u - lambda u|| / k */
    double error_estimate_rad;  /* estimate of the largest principal angle to the exact embedding */
    double gap;                 /* lambda_{d+2} / lambda_{d+1}; near 1: the curve is ill-defined */
    int64_t rank_deficient_windows; /* windows of fewer than d directions */
    int64_t solves;             /* applications of the inverse operator by ARPACK */
} stltsa_component;

/* ---- Motion units and cycles (section 3.1) ----------------------------------------------- */

typedef struct stltsa_decomposition stltsa_decomposition;

enum {
    STLTSA_UNIT_PREPARING = 1, /* standing before a motion */
    STLTSA_UNIT_INITIAL = 2,   /* from the first movement to the first cycle */
    STLTSA_UNIT_CYCLIC = 3,    /* the cycles */
    STLTSA_UNIT_FINAL = 4,     /* from the last cycle to standing */
    STLTSA_UNIT_WIND_UP = 5,   /* standing after a motion */
    STLTSA_UNIT_ACTION = 6,    /* motion for which no cycles are reported */
    STLTSA_UNIT_HOLD = 8       /* keeping another posture than the one at rest */
};
/* "preparing", "initial", "cyclic", "final", "wind-up", "action", "hold"; "unknown" otherwise. */
STLTSA_API const char *stltsa_unit_name(int64_t kind) STLTSA_NOEXCEPT;

/* [begin, end) in source frames, rounded, and in seconds, with fractions of a frame. Frozen. */
typedef struct stltsa_interval {
    int64_t begin, end;
    double begin_s, end_s;
} stltsa_interval;

/* A unit, [begin, end) as in stltsa_interval. A row. */
typedef struct stltsa_unit {
    int64_t kind;          /* STLTSA_UNIT_* */
    int64_t segment;       /* index of its segment */
    int64_t begin, end;    /* frames, rounded */
    double begin_s, end_s; /* seconds, with fractions of a frame */
} stltsa_unit;

/* The intervals of a stretch as in stltsa_clip_stretch: `count` is set to their number (1, except
 * for labels), and the first `capacity` are written. */
STLTSA_API stltsa_status stltsa_clip_find(const stltsa_clip *clip, const char *what,
    const stltsa_options *options, int64_t capacity, stltsa_interval *intervals, int64_t *count)
    STLTSA_NOEXCEPT;

enum {
    STLTSA_SEGMENT_CYCLIC = 1,      /* cycles back to back */
    STLTSA_SEGMENT_REPETITIONS = 2, /* the same action again and again, with pauses */
    STLTSA_SEGMENT_ACTION = 3,      /* a motion that is seen once */
    STLTSA_SEGMENT_REST = 4
};
/* "cyclic", "repetitions", "action", "rest"; "unknown" otherwise. */
STLTSA_API const char *stltsa_segment_name(int64_t kind) STLTSA_NOEXCEPT;

/* A stretch of one behavior, [begin, end) as in stltsa_interval. A row. */
typedef struct stltsa_segment {
    int64_t kind;              /* STLTSA_SEGMENT_* */
    int64_t label;             /* 0, 1, ... in order of appearance; -1: a rest */
    const char *letters;       /* the label as it is shown: A, B, ... Z, AA, ...; "" for a rest */
    double likeness;           /* mean likeness to the others of its label, 0 to 1; NaN: none */
    int64_t begin, end;        /* frames, rounded */
    double begin_s, end_s;     /* seconds, with fractions of a frame */
    double period_s;           /* median length of the cycles; NaN: not cyclic */
    double candidate_period_s; /* a period that was seen but is not claimed; NaN: none */
    int64_t count;             /* cycles or repetitions; 1 for an action, 0 for a rest */
    const char *const *carried_by; /* names of the joints, markers or columns that carry half of the
                                  motion, those that move most first; NULL after the last */
    int64_t open_begin, open_end; /* 1: the clip begins, or ends, within this motion */
    double confidence;         /* share of such answers that are right, 0 to 1 */
    double begin_confidence;   /* the same of the border at its begin; NaN for the first */
    const char *reason;        /* why it has no cycles, with the numbers; "" if it has. Of a rest:
                                  "nothing recorded" if most of the body is missing */
    double first_step_share;   /* share of a cycle that the first step takes; exactly 0.5 if the
                                  estimate cannot be told from it; NaN: no steps */
    double first_step_margin;  /* half of its 95 % interval; NaN: no steps, or under three cycles */
    const char *steps_reason;  /* why its cycles have no steps; "" if they have, or no cycles */
} stltsa_segment;

/* A cycle, a step or a repetition, [begin, end) as in stltsa_interval, and how the body (its root,
 * or the mean of points) travels over the ground meanwhile. A row. */
typedef struct stltsa_part {
    int64_t segment;           /* index of its segment */
    int64_t cycle;             /* of a step, index of its cycle; else -1 */
    int64_t label;             /* of its segment */
    const char *letters;       /* of its segment */
    int64_t begin, end;        /* frames, rounded */
    double begin_s, end_s;     /* seconds, with fractions of a frame */
    int64_t side;              /* which side of the body leads: 0 or 1, the same in all clips of a
                                  skeleton, by the file's foot strikes if it has any; -1: unknown */
    const char *side_name;     /* "left" or "right"; "" if no names tell */
    double likeness;           /* how like the others of its segment, 0 to 1; NaN: unknown */
    double confidence;         /* share of such answers that are right, 0 to 1 */
    double path_length;        /* in the unit of the file, as the next two; NaN: unknown */
    double stride;             /* distance between the ends of the path; NaN: unknown */
    double speed;              /* path length / second; NaN: unknown */
    double turn_deg;           /* degrees, counterclockwise as seen from above; NaN: unknown */
} stltsa_part;

/* TIME: length in seconds. The others: see stltsa_part. */
enum {
    STLTSA_QUANTITY_TIME = 1, STLTSA_QUANTITY_PATH_LENGTH = 2, STLTSA_QUANTITY_STRIDE = 3,
    STLTSA_QUANTITY_SPEED = 4, STLTSA_QUANTITY_TURN = 5
};

/* Of one quantity of several parts; all are NaN if count is 0. Frozen. */
typedef struct stltsa_statistics {
    int64_t count;       /* parts */
    double mean, sd;     /* mean; standard deviation, 0 for one part */
    double cv;           /* sd / mean; NaN of turns */
    double trend;        /* relative change per minute; NaN of turns */
} stltsa_statistics;

/* Of the cycles or repetitions of one label. A row. */
typedef struct stltsa_summary {
    int64_t label;                  /* of the segments, 0 for A */
    const char *letters;            /* the label as it is shown */
    int64_t count;                  /* cycles or repetitions */
    double cycles_per_min;          /* 60 / mean cycle time */
    stltsa_statistics cycle_time_s; /* lengths of the cycles */
    double steps_per_min;           /* NaN without steps */
    stltsa_statistics step_time_s;  /* lengths of the steps */
    double step_time_side_0_s, step_time_side_1_s; /* means of each side; NaN without steps */
    stltsa_statistics path_length, stride, speed, turn_deg; /* of the cycles: see stltsa_part */
} stltsa_summary;

/* Says what is done when in a recording of any length, and what of it repeats: rests, changes of
 * behavior, the period over time, and the cycles of each segment that repeats, cut at the posture
 * of rest, or else where a coordinate that oscillates once per cycle is steepest (section 3.1).
 * Segments of one motion share a label; those without cycles have a reason, which is no error. If
 * the file states foot strikes (STLTSA_INFO_FILE_EVENT), cycles begin at those of one side, and
 * steps end at those of both, unless they contradict the cycles; notes say so. Options: features,
 * up_axis, gaps, keep_start, sample_rate, smoothing, period_min, period_max, segments, threads;
 * those of embeddings (neighbors, ...) are refused. E_ARGUMENT: the clip's fps is unknown. */
STLTSA_API stltsa_status stltsa_decompose(const stltsa_clip *clip, const stltsa_options *options,
    stltsa_decomposition **decomposition) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_decomposition_free(stltsa_decomposition *decomposition) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_decomposition_info(const stltsa_decomposition *decomposition)
    STLTSA_NOEXCEPT;
/* Of a quantity (STLTSA_QUANTITY_*) of the parts of one kind (STLTSA_INFO_CYCLE, _STEP or
 * _REPETITION), label and side (-1: of both). Parts whose quantity is unknown are left out. */
STLTSA_API stltsa_status stltsa_decomposition_statistics(const stltsa_decomposition *decomposition,
    int32_t kind, int64_t label, int32_t side, int32_t quantity, stltsa_statistics *statistics)
    STLTSA_NOEXCEPT;

/* ---- Mapping in both directions (section 2.4) ----------------------------------------- */

/* Maps new frames onto the curve, by linear maps near the rows of the model that are blended along
 * the curve (docs/method.md). A fitted frame gets its own coordinates, to the bit. If equal frames
 * recur, a hint selects one of them; without it the first is used.
 *
 * frames    rows x features of the model
 * hints     NULL, or rows x 1, I64: the model row near which each row is searched, within option
 *           hint_window; -1: everywhere. For a stream: the nearest row of the frame before
 * coords    rows x d
 * distance  NULL, or rows x 1: distance from the fitted frames divided by STLTSA_INFO_REACH; beyond
 *           1 the frame is unlike them, and its coordinates mean little
 * nearest   NULL, or rows x 1, I64: the nearest model row; the coordinates are of its component
 * Options: map_neighbors, map_blend, hint_window, threads. E_UNSUPPORTED: no frames were kept. */
STLTSA_API stltsa_status stltsa_map(const stltsa_model *model, const stltsa_in *frames,
    const stltsa_in *hints, const stltsa_options *options, const stltsa_out *coords,
    const stltsa_out *distance, const stltsa_out *nearest) STLTSA_NOEXCEPT;
/* The same for every source frame of a clip, prepared as the model's, so a fitted clip gets its own
 * coordinates at its model rows. E_UNSUPPORTED: the model is of a matrix. */
STLTSA_API stltsa_status stltsa_map_clip(const stltsa_model *model, const stltsa_clip *clip,
    const stltsa_options *options, const stltsa_out *coords, const stltsa_out *distance,
    const stltsa_out *nearest) STLTSA_NOEXCEPT;

/* The inverse: frames (rows x features) from points of the manifold (rows x d). Distance is from
 * the point to the rows of the model, divided by the usual distance of neighboring rows; beyond 1
 * the frame is a guess. Nearest is the nearer end of the segment of the curve that contains the
 * point. One coordinate cannot tell the two directions of a swing: give hints, or fit more. With a
 * skeleton bones keep their lengths. Also option component. E_DISCONNECTED: several, and none
 * chosen. */
STLTSA_API stltsa_status stltsa_unmap(const stltsa_model *model, const stltsa_in *coords,
    const stltsa_in *hints, const stltsa_options *options, const stltsa_out *frames,
    const stltsa_out *distance, const stltsa_out *nearest) STLTSA_NOEXCEPT;

/* Poses from points of the manifold, as a clip with the fitted skeleton: rotations of all joints,
 * height and tilt, above the origin and with one heading. Each point becomes a frame: option fps is
 * their rate; auto: STLTSA_INFO_FPS. E_UNSUPPORTED: the model is of a matrix. */
STLTSA_API stltsa_status stltsa_unmap_clip(const stltsa_model *model, const stltsa_in *coords,
    const stltsa_in *hints, const stltsa_options *options, const stltsa_out *distance,
    const stltsa_out *nearest, stltsa_clip **poses) STLTSA_NOEXCEPT;

/* ---- Model files ------------------------------------------------------------------------- */

/* A model as bytes: versioned, little-endian, checksummed, the same on every machine; a parsed
 * model has the same bits. Parsing is safe for untrusted bytes. */
STLTSA_API stltsa_status stltsa_model_serialize(const stltsa_model *model, unsigned char **bytes,
    size_t *size) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_model_parse(const void *bytes, size_t size, stltsa_model **model)
    STLTSA_NOEXCEPT;
/* The same to and from a file, which is written completely or not at all. */
STLTSA_API stltsa_status stltsa_model_save(const stltsa_model *model, const char *path,
    const stltsa_options *options) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_model_load(const char *path, const stltsa_options *options,
    stltsa_model **model) STLTSA_NOEXCEPT;

/* ---- Phase and mean cycles --------------------------------------------------------------- */

/* A phase for every frame of a clip's cycles: where it lies on the mean cycle of its motion, in
 * turns. It rises strictly. All segments of a label are registered to one mean cycle, by pose and
 * velocity; borders of cycles lie at phase 0 on average, and within about 1 %. The mean share of
 * time at each phase is uniform. */
typedef struct stltsa_phase stltsa_phase;

/* The phase of a clip that was decomposed, found by the first call, and kept by the decomposition,
 * which may be freed first. Every frame counts, without sample_rate or smoothing. If a mean cycle
 * explains less than 0.6 of the variance, the phase is linear in time, and a warning says so. */
STLTSA_API stltsa_status stltsa_phase_find(const stltsa_decomposition *decomposition,
    const stltsa_options *options, stltsa_phase **phase) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_phase_free(stltsa_phase *phase) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_phase_info(const stltsa_phase *phase) STLTSA_NOEXCEPT;

/* Signals on 0 to 100 % of each cycle. */
typedef struct stltsa_cycles stltsa_cycles;

/* Resamples any signals of the clip's frames, such as joint angles, forces or EMG, by the phase of
 * one motion, linearly between frames. Sample s is at phase s / (samples - 1), so that the last one
 * is phase 0 of the next cycle.
 *
 * label    of the segments, 0 for A
 * signals  frames of the file x columns; NaN is a missing value
 * samples  of each cycle, at least 2; 101 for percent
 *
 * Cycles are those of the decomposition, from border to border, or else repetitions; those shorter
 * than 6 frames are left out. A cycle that ends with the clip goes on at its beginning. E_ARGUMENT:
 * the label has neither. */
STLTSA_API stltsa_status stltsa_cycles_resample(const stltsa_phase *phase, int64_t label,
    const stltsa_in *signals, int64_t samples, const stltsa_options *options,
    stltsa_cycles **cycles) STLTSA_NOEXCEPT;
/* The same without registration: linear in time between `borders`, such as heel strikes: count x 1,
 * at least 2 ascending frames, not rounded, up to the number of frames. Samples after the beginning
 * of the last frame are NaN. */
STLTSA_API stltsa_status stltsa_cycles_between(const stltsa_in *borders, const stltsa_in *signals,
    int64_t samples, const stltsa_options *options, stltsa_cycles **cycles) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_cycles_free(stltsa_cycles *cycles) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_cycles_info(const stltsa_cycles *cycles) STLTSA_NOEXCEPT;
/* STLTSA_INFO_COLUMN_DISTANCE for groups of columns, such as the coordinates of each joint. groups:
 * columns x 1, I64, from 0; -1: none. distance: cycles x groups, root of the sum of squares. */
STLTSA_API stltsa_status stltsa_cycles_group_distance(const stltsa_cycles *cycles,
    const stltsa_in *groups, const stltsa_out *distance) STLTSA_NOEXCEPT;

enum { STLTSA_SIDE_NONE = -1, STLTSA_SIDE_LEFT = 0, STLTSA_SIDE_RIGHT = 1 };

/* The side that a name states: left for "left heel strike", "LHS", "LeftFoot" and "toe_l"; none if
 * the name is NULL or states neither side or both. */
STLTSA_API int32_t stltsa_side_of_name(const char *name) STLTSA_NOEXCEPT;

/* ---- Events ------------------------------------------------------------------------------- */

/* A moment, such as a heel strike, that was marked in one cycle and is found in all others. */
typedef struct stltsa_events stltsa_events;

/* A moment that was found, or a mark of the caller. A row. */
typedef struct stltsa_event {
    double frame;      /* of the file, not rounded */
    double seconds;    /* its time */
    int64_t cycle;     /* index among the cycles of the clip; -1: outside cycles */
    double confidence; /* 0 to 1: ranks the events by the size of their likely errors */
    int64_t marked;    /* 1: a mark of the caller, as it was given */
} stltsa_event;

/* Finds the event at one or more marked frames in every cycle or repetition of that motion, also a
 * little before the first and after the last cycle if the motion goes on there: the mean of where
 * the phase comes round, and of where the motion is like that at the marks and in other cycles.
 *
 * from   the phase of a clip
 * marks  count x 1: frames of that clip, not rounded
 * in     where they are found: NULL or `from`, or the phase of a clip with the same features
 *
 * Marks farther than a tenth of a cycle apart mark several places; each has its events, and a
 * warning says so. There are none if the other clip has no such motion (STLTSA_INFO_LIKENESS).
 * E_ARGUMENT: a mark lies in no motion that repeats, or they are spread all over the cycle. */
STLTSA_API stltsa_status stltsa_events_find(const stltsa_phase *from, const stltsa_in *marks,
    const stltsa_phase *in, const stltsa_options *options, stltsa_events **events) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_events_free(stltsa_events *events) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_events_info(const stltsa_events *events) STLTSA_NOEXCEPT;

/* ---- Comparison of two motions -------------------------------------------------------------- */

/* The cycles of two motions, such as those of a patient before and after treatment, aligned by
 * phase: the differences in timing and amplitude, and how precisely they are known. */
typedef struct stltsa_comparison stltsa_comparison;

/* A quantity of both mean cycles and its difference, with a 95 % confidence interval from the
 * spread between cycles: how well the mean of these cycles is known (docs/answers.md). Of 20
 * differences that are really zero, about one is significant by chance. Unknown values are NaN.
 * Frozen. */
typedef struct stltsa_estimate {
    double first, first_sd;   /* of the first motion: value, standard deviation between cycles */
    double second, second_sd; /* the same of the second */
    double difference;        /* second minus first */
    double standard_error;    /* of the difference */
    double low, high;         /* its confidence interval */
    int64_t significant;      /* 1: the interval excludes 0, by more than rounding */
} stltsa_estimate;

/* An estimate without its parts. Frozen. */
typedef struct stltsa_bounded {
    double value;             /* what is estimated */
    double low, high;         /* its 95 % confidence interval */
} stltsa_bounded;

/* About a whole comparison. A row. */
typedef struct stltsa_compared {
    int64_t sides;         /* 1: left against right */
    int64_t features;      /* STLTSA_FEATURES_* that were compared */
    int64_t samples;       /* of each cycle */
    double shift;          /* phase of the second motion at phase 0 of the first, -0.5 to 0.5 */
    double shift_error;    /* its standard error; NaN: it is half a cycle by definition */
    double shift_low, shift_high; /* its 95 % confidence interval */
    double likeness;       /* correlation of the two mean cycles; below 0.6 there is a warning */
    double runner_up;      /* the same at the next best shift; NaN: there is none */
    double turn_deg;       /* degrees by which the second body was turned about the up axis to face
                              as the first does; 0 for skeletons with the same joints */
    double size_ratio;     /* size of the second body divided by that of the first; NaN: unknown */
    stltsa_estimate cycle_time_s; /* mean length of the cycles */
    int64_t judged;        /* number of lags and amplitudes of parts that have an interval */
    int64_t significant;   /* how many of them are significant */
    double expected_by_chance; /* how many would be if nothing differed */
} stltsa_compared;

/* One of the two motions. A row. */
typedef struct stltsa_compared_motion {
    const char *path;      /* of the clip; "": from memory */
    int64_t frames;        /* of the clip */
    double fps;            /* of the clip; NaN: unknown */
    int64_t label;         /* of the segments, 0 for A */
    const char *letters;   /* the label as it is shown */
    int64_t cycles;        /* cycles that were compared */
    double cycles_per_min; /* 60 / mean cycle time */
    const char *const *left_out; /* names that the other clip lacks; NULL after the last */
} stltsa_compared_motion;

/* A joint, a point or a column of the file (part), or one of its coordinates (channel). Lengths and
 * angles are in the unit of the features. A row. */
typedef struct stltsa_compared_part {
    int64_t part;          /* index of the part; of a channel, of the part it belongs to */
    const char *first;     /* its name in the first motion */
    const char *second;    /* its name in the second; they differ for left and right */
    const char *axis;      /* of a channel, such as "x" of a position, "rz" of an angle, "1" to "6"
                              of a rotation matrix; "" for the only one of a part, and of parts */
    stltsa_estimate mean;  /* mean over the cycle; NaN for a part with several channels */
    stltsa_estimate lag;   /* how much later the second motion does the same, relative to the whole
                              body (left and right: to half a cycle), as a share of the cycle; first
                              is 0. NaN: the curves are not alike (correlation below 0.7) */
    stltsa_bounded lag_s;  /* the same in seconds, for the mean of both cycle times */
    stltsa_estimate amplitude; /* of the mean curve: largest distance between two of its points; of
                              one channel, maximum minus minimum */
    stltsa_bounded amplitude_ratio; /* amplitude of the second divided by that of the first */
    double rms_difference; /* root mean square, over the cycle, of second minus first */
    double rms_by_chance;  /* the same, expected from the spread between cycles alone */
    double correlation;    /* of the two mean curves after the lag is removed */
} stltsa_compared_part;

/* Compares the features of two cyclic motions.
 *
 * first, second  phases of two clips, or of one. What has the same name in both is compared:
 *                joints, points or columns, in the axes of the first
 * labels         of the segments; -1: the motion with the most frames in cycles, and one like it
 * samples        of each cycle, 5 to 1001; 101 for percent
 *
 * The cycles of the first motion go from border to border, those of the second from the shift on.
 * E_NO_SUCH_PART: a clip has no cycles. E_ARGUMENT: a label has none. E_SHAPE: different kinds of
 * features, or no name in common. */
STLTSA_API stltsa_status stltsa_compare(const stltsa_phase *first, int64_t first_label,
    const stltsa_phase *second, int64_t second_label, int64_t samples,
    const stltsa_options *options, stltsa_comparison **comparison) STLTSA_NOEXCEPT;

/* Compares the left side of a body with its right side: the first motion is the left side, the
 * second the mirror image of the right side (stltsa_clip_mirror) half a cycle later, so that every
 * coordinate of a symmetric walk differs by 0. Differences are taken within each cycle, so a change
 * of both sides alike does not widen the intervals. Lags are relative to half a cycle. clip,
 * options: those of stltsa_decompose. E_UNSUPPORTED: the halves of a cycle are not known to be one
 * motion of opposite sides, or the clip has no pairs of sides or cannot be mirrored. */
STLTSA_API stltsa_status stltsa_compare_left_right(const stltsa_clip *clip,
    const stltsa_phase *phase, int64_t label, int64_t samples, const stltsa_options *options,
    stltsa_comparison **comparison) STLTSA_NOEXCEPT;
/* The same of any signals, over cycles that were found, or that begin with an event of the left
 * side (stltsa_cycles_between), of 5 to 1001 samples; those with missing values are left out.
 * names: one for each column; knee_l and knee_r are a pair, as are LeftKnee and RightKnee, with the
 * same sign convention, as of flexion. fps: of the signals; 0: unknown, so that times are NaN. */
STLTSA_API stltsa_status stltsa_cycles_compare_left_right(const stltsa_cycles *cycles,
    const char *const *names, double fps, const stltsa_options *options,
    stltsa_comparison **comparison) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_comparison_free(stltsa_comparison *comparison) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_comparison_info(const stltsa_comparison *comparison)
    STLTSA_NOEXCEPT;

/* ---- Live phase ----------------------------------------------------------------------------- */

/* Keeps in a model, and its file, what a stream is compared with: the mean cycle of the motion with
 * the most frames in cycles. Earlier marks are forgotten. E_ARGUMENT: no cycles, or too short ones.
 * E_SHAPE: other features. E_DEGENERATE: all columns only drift. */
STLTSA_API stltsa_status stltsa_model_keep_cycle(stltsa_model *model, const stltsa_phase *phase,
    const stltsa_options *options) STLTSA_NOEXCEPT;
/* Names the phase of a frame (not rounded) in those cycles, which a stream reports as it passes. At
 * most 62. E_ARGUMENT: the frame lies in no cycle of that motion; no name. */
STLTSA_API stltsa_status stltsa_model_keep_mark(stltsa_model *model, const stltsa_phase *phase,
    double frame, const char *name) STLTSA_NOEXCEPT;
/* Follows one stream, frame after frame, without delay or look at later frames. The model may be
 * freed before it. Only stltsa_live_new allocates memory. */
typedef struct stltsa_live stltsa_live;

/* An answer about a frame. */
typedef struct stltsa_live_frame {
    size_t size;
    int64_t passed;    /* bit i: mark i (STLTSA_INFO_MARK) was passed since the frame before */
    double phase;      /* of the clip that was kept, in [0, 1) */
    double rate_hz;    /* turns a second */
    double cycles;     /* turns since the first frame, not rounded */
    double distance;   /* from the mean cycle; above 1 it is another motion; NaN: missing frame */
    double confidence; /* 0 to 1: how sharply the phase is known; falls while frames are missing */
    int32_t known;     /* 0: another motion, for 0.1 s at least, or a frame that is missing */
    int32_t kind;      /* STLTSA_SEGMENT_CYCLIC, _ACTION (not known) or _REST (the body is still) */
} stltsa_live_frame;

/* E_UNSUPPORTED: the model keeps no mean cycle. */
STLTSA_API stltsa_status stltsa_live_new(const stltsa_model *model, stltsa_live **live)
    STLTSA_NOEXCEPT;
STLTSA_API void stltsa_live_free(stltsa_live *live) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_live_info(const stltsa_live *live) STLTSA_NOEXCEPT;

/* Each of these functions takes the next frame, and answers about it.
 * seconds  its time. Frames may be dropped. If it is that of the frame before, or up to 0.25 s
 *          earlier, the frame is left out, and the answer is that of the frame before. If it falls
 *          by more, or after more than a second without frames, the filter starts anew and settles
 *          within 0.15 s, in which no mark is passed. E_ARGUMENT: not finite, or beyond 1e12
 * If too little is known of a frame, or it is too far away for any body, it is missing: the phase
 * goes on as before, less and less surely, and `known` is 0.
 * E_UNSUPPORTED: the model's frames have another form. */

/* points      points x 2 or 3, in the order and the unit of the model's clip, at any place and
 *             heading. A point is lost if it is NaN, or all of its coordinates are 0; it gets the
 *             place that the others imply. If more than half are lost, the frame is missing
 * confidence  points x 1, 0: lost; NULL: all are seen */
STLTSA_API stltsa_status stltsa_live_push_points(stltsa_live *live, double seconds,
    const stltsa_in *points, const stltsa_in *confidence, stltsa_live_frame *frame) STLTSA_NOEXCEPT;
/* form       STLTSA_ROTATIONS_*
 * rotations  of the joints, as in stltsa_clip_from_skeleton, one row; a frame with a number that is
 *            not finite is missing. E_ARGUMENT: the numbers are no rotation
 * root       1 x 3, position of the root; NULL: its offset, or in the channels. It counts only if a
 *            joint above the body's root moves */
STLTSA_API stltsa_status stltsa_live_push_pose(stltsa_live *live, double seconds, int32_t form,
    const stltsa_in *rotations, const stltsa_in *root, stltsa_live_frame *frame) STLTSA_NOEXCEPT;
/* Replays frame `index` of a clip with the joints or columns of the model's; bones may differ. */
STLTSA_API stltsa_status stltsa_live_push_frame(stltsa_live *live, double seconds,
    const stltsa_clip *clip, int64_t index, stltsa_live_frame *frame) STLTSA_NOEXCEPT;
/* features  1 x features of the model, with a skeleton as in stltsa_clip_features; otherwise the
 *           numbers of the columns of the file, NaN if one is lost */
STLTSA_API stltsa_status stltsa_live_push(stltsa_live *live, double seconds,
    const stltsa_in *features, stltsa_live_frame *frame) STLTSA_NOEXCEPT;

/* ---- Reports -------------------------------------------------------------------------------- */

/* Writes a report of a clip that was decomposed, completely or not at all: one HTML page that needs
 * no network, with the moving body, timeline, curve and loop, mean cycles, tables and warnings (an
 * hour takes at most 10 MB; it has fewer postures); or a figure if the path ends in .svg. options:
 * those of the decomposition. command: what makes the report again, to be shown; NULL: unknown. The
 * same input gives the same bytes. E_ARGUMENT: the decomposition is of another clip. */
STLTSA_API stltsa_status stltsa_report_save(const stltsa_clip *clip,
    const stltsa_decomposition *decomposition, const stltsa_options *options, const char *command,
    const char *path) STLTSA_NOEXCEPT;
/* The same of a comparison: both mean cycles as moving bodies, the largest differences in timing
 * and amplitude with their intervals, the curves of each part, tables and warnings. */
STLTSA_API stltsa_status stltsa_comparison_report_save(const stltsa_comparison *comparison,
    const stltsa_options *options, const char *command, const char *path) STLTSA_NOEXCEPT;

/* ---- Denoising (section 3.2) ------------------------------------------------------------- */

typedef struct stltsa_denoising stltsa_denoising;

/* Denoises coordinates, rows x columns, each column separately. The curve is a penalized cubic
 * spline over time, smoothed by generalized cross-validation. Points farther than gamma from it are
 * moved towards it by their mean distance, as in equation (1), but never across it. Several clips:
 * as in stltsa_fit, each with its own spline. Locate extrema on the curve, not on the points.
 * Options: gamma, knot_spacing, robust, fps, period_min, period_max. E_TOO_FEW_FRAMES: below 8 rows
 * in a clip. */
STLTSA_API stltsa_status stltsa_denoise(const stltsa_in *coords, const stltsa_in *lengths,
    const stltsa_options *options, stltsa_denoising **denoising) STLTSA_NOEXCEPT;
/* The coordinates of a model, component by component; rate and period are those of the model. */
STLTSA_API stltsa_status stltsa_denoise_model(const stltsa_model *model,
    const stltsa_options *options, stltsa_denoising **denoising) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_denoising_free(stltsa_denoising *denoising) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_denoising_info(const stltsa_denoising *denoising)
    STLTSA_NOEXCEPT;

/* One column of a denoising. A row. */
typedef struct stltsa_denoised_column {
    double gamma;              /* threshold that was used */
    double shift;              /* d_t: mean distance of the points beyond gamma */
    double noise;              /* robust standard deviation of the residuals */
    double noise_share;        /* noise as a share of the range of the curve */
    double degrees_of_freedom; /* effective, of the curve */
    int64_t moved;             /* points that were moved */
} stltsa_denoised_column;

/* ---- New motion from units (section 4) ---------------------------------------------------- */

/* Frames [begin, end) of a clip, `repeat` times (1: once). Set reserved to 0. Frozen. */
typedef struct stltsa_piece {
    const stltsa_clip *clip;
    int64_t begin, end, repeat, reserved;
} stltsa_piece;

typedef struct stltsa_synthesis stltsa_synthesis;

/* Joins pieces, in order, into one clip. If a piece does not continue the one before, the cuts move
 * (option cut_range) to the frames with the most similar postures and velocities, and the two are
 * crossfaded. The body continues from its position and heading. Pieces that follow each other in
 * their clip are joined unchanged. All clips need the same hierarchy; the first determines
 * channels, units and frame rate, to which others are resampled. With option loop the last piece
 * continues as the first: the wrap is the last seam, its `frame` the number of frames, and only the
 * path goes on (STLTSA_INFO_TRAVEL), unless in_place removes it. Options: crossfade, cut_range,
 * posture_limit, loop, in_place, up_axis. E_UNSUPPORTED: no skeleton, different hierarchies, no
 * frame rate. E_NO_COMMON_POSTURE: beyond posture_limit; the text says where. */
STLTSA_API stltsa_status stltsa_synthesize(const stltsa_piece *pieces, int64_t count,
    const stltsa_options *options, stltsa_synthesis **synthesis) STLTSA_NOEXCEPT;
/* The loop of a clip: of the ranges of consecutive cycles in `decomposition`, which is of this
 * clip, the longest with a good seam (docs/method.md), or else that with the smallest seam; without
 * cycles, the whole clip. A note says which. Otherwise as stltsa_synthesize. */
STLTSA_API stltsa_status stltsa_synthesize_loop(const stltsa_clip *clip,
    const stltsa_decomposition *decomposition, const stltsa_options *options,
    stltsa_synthesis **synthesis) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_synthesis_free(stltsa_synthesis *synthesis) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_synthesis_info(const stltsa_synthesis *synthesis)
    STLTSA_NOEXCEPT;
/* The new clip; it belongs to the synthesis. */
STLTSA_API const stltsa_clip *stltsa_synthesis_clip(const stltsa_synthesis *synthesis)
    STLTSA_NOEXCEPT;

/* The place at which one piece is followed by another, or by its own repetition. A row. */
typedef struct stltsa_seam {
    int64_t frame;         /* first frame of the later piece; of a wrap, the number of frames */
    double time_s;         /* its time */
    int64_t piece, next;   /* indices of the pieces that meet */
    int64_t cut_end;       /* the earlier piece ends before this frame of its clip, as resampled */
    int64_t cut_begin;     /* the later piece starts at this frame of its clip */
    int64_t crossfade;     /* frames to each side that are blended; 0: none */
    double crossfade_s;    /* the same in seconds */
    double posture;        /* distance of postures and velocities at the cuts, divided by the usual
                              distance between repetitions of the same motion */
    double step;           /* largest pose step near the seam, divided by the 95th percentile in the
                              pieces; invisible up to 1 */
    double acceleration;   /* the same of the second difference */
    int64_t wrap;          /* 1: the wrap of a loop */
} stltsa_seam;

/* What a piece was made of. A row. */
typedef struct stltsa_piece_fact {
    const char *path;        /* of its clip; "": from memory */
    int64_t begin, end;      /* its frames there, [begin, end) */
    int64_t repeat;          /* how often it is played */
} stltsa_piece_fact;

/* ---- Many clips ------------------------------------------------------------------------- */

/* Which clips are decomposed into which files of a folder (docs/batch.md). It does not change:
 * threads, and processes that make one with the same arguments, may run its clips at once. */
typedef struct stltsa_batch stltsa_batch;

/* Finds the clips, and creates the folder of the results. The result of a/b.bvh is a__b.bvh.json.
 *
 * paths    files and folders, which are searched, with those below, for files with the suffix of a
 *          format, but for hidden files, tables that describe BIDS recordings, and summaries
 * shard    NULL: all clips; "2/8": every 8th from the 2nd on, for a run on 8 machines
 * options  of stltsa_clip_open and stltsa_decompose, copied; fps only for clips that need it
 *
 * E_ARGUMENT: there is no clip, two would have one result, or a wrong option or shard. */
STLTSA_API stltsa_status stltsa_batch_new(const char *const *paths, int64_t count,
    const char *folder, const char *shard, const stltsa_options *options, stltsa_batch **batch)
    STLTSA_NOEXCEPT;
STLTSA_API void stltsa_batch_free(stltsa_batch *batch) STLTSA_NOEXCEPT;
/* The path of a clip; NULL beyond the last one. */
STLTSA_API const char *stltsa_batch_path(const stltsa_batch *batch, int64_t index) STLTSA_NOEXCEPT;

/* Decomposes one clip and writes its result, completely or not at all, unless its file is that of
 * an earlier run on the same content, with the same options, by the same version.
 *
 * clip     NULL: the library opens it; or what the caller read at that path
 * kept     NULL, or receives 1: the result is of an earlier run; 0: it is not
 * row      receives the clip's row of the summary, which the caller frees, also if the clip fails.
 *          NULL: the call was wrong or cancelled, or memory ran out
 *
 * E_IO: the result is that of another clip, or cannot be written. */
STLTSA_API stltsa_status stltsa_batch_run(const stltsa_batch *batch, int64_t index,
    const stltsa_clip *clip, const stltsa_options *options, int32_t *kept, char **row)
    STLTSA_NOEXCEPT;

/* Writes the rows (count texts of stltsa_batch_run) as a table, summary.csv, or summary-2-8.csv of
 * a shard, in the folder. summary: NULL, or receives its path, which belongs to the batch. */
STLTSA_API stltsa_status stltsa_batch_finish(const stltsa_batch *batch, const char *const *rows,
    int64_t count, const char **summary) STLTSA_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif /* STLTSA_H */
