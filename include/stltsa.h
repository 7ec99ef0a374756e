/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * libstltsa: motion clips as low-dimensional curves, motion units and cycles.
 *
 * The method is spatio-temporal local tangent space alignment (STLTSA): Li, Niu, Zhang, Hu,
 * "Spatio-temporal LTSA and Its Application to Motion Decomposition", ICONIP 2012; LTSA itself:
 * Zhang, Zha, "Principal Manifolds and Nonlinear Dimension Reduction via Local Tangent Space
 * Alignment", SIAM J. Sci. Comput. 26, 2004. "Section" and "equation" below are the former's.
 *
 * The short way, three calls:
 *
 *     stltsa_clip *clip = NULL;
 *     stltsa_decomposition *units = NULL;
 *     if (stltsa_clip_open("walk.bvh", NULL, &clip) == STLTSA_OK &&
 *         stltsa_decompose(clip, NULL, &units) == STLTSA_OK)
 *         for (int64_t i = 0; i < stltsa_decomposition_unit_count(units); ++i) {
 *             stltsa_interval u;
 *             stltsa_decomposition_unit(units, i, &u);
 *             printf("%s %.2f s .. %.2f s\n", stltsa_unit_name(u.kind), u.begin_s, u.end_s);
 *         }
 *     else
 *         fprintf(stderr, "%s\n", stltsa_last_error());
 *     stltsa_decomposition_free(units);
 *     stltsa_clip_free(clip);
 *
 * The library runs on Linux, and is built by GCC or Clang.
 *
 * Rules that hold for every function:
 *
 * Errors.     A function that can fail returns stltsa_status: STLTSA_OK (0) or a negative
 *             STLTSA_E_*. stltsa_last_error() then says in words what was wrong, where, and what
 *             to do. On failure a handle output is set to NULL, arrays are left as they were, and
 *             the handles passed in stay usable. Nothing is ever printed, no signal handler is
 *             installed, the environment is not read, the floating-point mode is not changed, and
 *             the process is never ended.
 * Ownership.  Handles are made by the library and belong to the caller, who ends them with the
 *             matching _free, which takes NULL. Texts and bytes that a function puts into a
 *             char ** or unsigned char ** belong to the caller, too, who ends them with
 *             stltsa_free. Inputs are read during the call only; if another thread changes them
 *             meanwhile, the call may fail (E_NOT_FINITE), and what it returns otherwise means
 *             nothing. A returned const char * belongs to the handle it came from and lives as
 *             long.
 * Threads.    Any number of threads may use const handles at once, and different calls may run at
 *             once (ARPACK is not reentrant: the library lets one eigenproblem run at a time; it
 *             cannot know of other users of the same libarpack in the process). A handle that is
 *             not const in a signature is used by one thread at a time. Progress callbacks run on
 *             the thread that made the call. Threads that a call starts end with it (so a process
 *             may fork between calls; what is forked off within a progress callback has to exec
 *             or _exit). While a fit runs, OpenBLAS is set to one thread for the whole process,
 *             then back.
 * Sameness.   Same input, options and build give the same bits on every run, for any number of
 *             threads. The sign of each coordinate is such that its entry of largest size is
 *             positive.
 * Units.      Frames count from 0 in the source file. Intervals are half-open, [begin, end).
 *             Rotations are quaternions w x y z. Lengths are in the file's own unit. Seconds are
 *             frame / fps.
 * Options.    A NULL options pointer means the defaults. An option that is not set has its default
 *             or, if its text says "auto", a value that the library chooses by the rule said there.
 *             No number stands for that; stltsa_options_unset goes back to it.
 */
#ifndef STLTSA_H
#define STLTSA_H

#include <stddef.h>
#include <stdint.h>

#define STLTSA_VERSION_MAJOR 0
#define STLTSA_VERSION_MINOR 1
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
    STLTSA_E_SHAPE = -2,         /* rows, columns or strides do not fit */
    STLTSA_E_NOT_FINITE = -3,    /* a NaN or an infinity among the numbers, or one beyond 1e100,
                                    where distances would be infinite */
    STLTSA_E_TOO_FEW_FRAMES = -4, /* fewer (distinct) frames than the neighbors ask for */
    STLTSA_E_NO_MEMORY = -5,     /* no memory, or rows * cols overflows */
    STLTSA_E_IO = -6,            /* a file cannot be opened, read or written */
    STLTSA_E_FORMAT = -7,        /* a file is not what its format says; text has the line */
    STLTSA_E_DISCONNECTED = -8,  /* the neighborhood graph falls apart and one was needed */
    STLTSA_E_DEGENERATE = -9,    /* the frames do not vary, or not in enough directions */
    STLTSA_E_NOT_CONVERGED = -10, /* the eigensolver gave up */
    STLTSA_E_CANCELLED = -11,    /* the progress callback asked to stop */
    STLTSA_E_UNSUPPORTED = -12,  /* not in this build (CHOLMOD), or not for this clip */
    STLTSA_E_INTERNAL = -13,     /* a defect of the library: please report */
    STLTSA_E_NO_COMMON_POSTURE = -14 /* two pieces of motion have no posture at which to join */
};

/* "STLTSA_E_SHAPE" and so on; "STLTSA_E_UNKNOWN" for values that this version does not know. */
STLTSA_API const char *stltsa_status_name(stltsa_status status) STLTSA_NOEXCEPT;

/* The text of the last failure on this thread; "" before any. Valid until this thread's next
 * call that fails. Never NULL. */
STLTSA_API const char *stltsa_last_error(void) STLTSA_NOEXCEPT;

/* "0.1.0". The version of the library that runs, not of this header. */
STLTSA_API const char *stltsa_version(void) STLTSA_NOEXCEPT;

/* The same as a number that compares: STLTSA_VERSION_NUMBER as it was when the library was built. */
STLTSA_API int32_t stltsa_version_number(void) STLTSA_NOEXCEPT;

/* Parts that a build of the library may be without. */
enum {
    STLTSA_HAS_CHOLMOD = 1, /* modes spatial and recurrent; without it: E_UNSUPPORTED */
    STLTSA_HAS_OPENBLAS = 2 /* BLAS is OpenBLAS: a fit sets it to one thread, and then back */
};
/* 1: this build has the part; 0: it does not, or does not know the part. */
STLTSA_API int32_t stltsa_has(int32_t part) STLTSA_NOEXCEPT;

/* Ends a text or bytes that a function put into a char ** or unsigned char ** of the caller, such
 * as JSON; takes NULL. Handles have a _free of their own. */
STLTSA_API void stltsa_free(void *memory) STLTSA_NOEXCEPT;

/* ---- Arrays ----------------------------------------------------------------------------- */

/* dtype: IEEE float32, IEEE float64, 64-bit integers, in native byte order. Numbers are F32 or F64,
 * whichever the caller has; rows, counts and labels are I64. E_ARGUMENT: another dtype. */
enum { STLTSA_F32 = 1, STLTSA_F64 = 2, STLTSA_I64 = 3 };

/* A caller's array, rows x cols: frames are rows, and a list is rows x 1. Strides are in bytes, may be negative, and need
 * not be multiples of the entry size; both 0 means packed rows. The entries of an output must not
 * overlap. Set reserved to 0. These two structs are frozen. */
typedef struct stltsa_in {
    const void *data;
    int64_t rows, cols;
    int64_t row_stride, col_stride;
    int32_t dtype, reserved;
} stltsa_in;

typedef struct stltsa_out {
    void *data;
    int64_t rows, cols;
    int64_t row_stride, col_stride;
    int32_t dtype, reserved;
} stltsa_out;

/* ---- Options ---------------------------------------------------------------------------- */

typedef struct stltsa_options stltsa_options;

/* Keys. stltsa_option_describe() gives name, type, range, default and text of each at run time;
 * the command's flags and the bindings' keywords are made from that table. */
enum {
    STLTSA_OPT_NEIGHBORS = 1,    /* int   k; auto: 1.2 periods if a period is found, otherwise
                                      1.2 s, or 12 if the frame rate is unknown */
    STLTSA_OPT_WINDOW = 2,       /* int   w, frames to each side; auto: as neighbors */
    STLTSA_OPT_DIMENSION = 3,    /* int   d; auto: fit 2, decompose the best of 1 to 3 */
    STLTSA_OPT_MODE = 4,         /* int   STLTSA_MODE_* */
    STLTSA_OPT_INCLUDE_SELF = 5, /* int   1: a frame is among its own k neighbors (Zhang and Zha);
                                      0: it is not (as scikit-learn has it) */
    STLTSA_OPT_LINKS = 6,        /* int   recurrent: neighbors from outside the exclusion zone */
    STLTSA_OPT_EXCLUSION = 7,    /* int   recurrent: half width of that zone in frames; auto: window */
    STLTSA_OPT_THREADS = 8,      /* int   auto: every core */
    STLTSA_OPT_FEATURES = 9,     /* int   STLTSA_FEATURES_*; auto: positions if there is a skeleton,
                                      otherwise raw */
    STLTSA_OPT_UP_AXIS = 10,     /* int   1, 2, 3: x, y, z; auto: found from the skeleton */
    STLTSA_OPT_KEEP_START = 11,  /* int   1: do not drop a T-pose at the start */
    STLTSA_OPT_FPS = 12,         /* real  frames a second, over what the file says; auto: the
                                      file's. unmap_clip: points a second; auto: the
                                      model's rows */
    STLTSA_OPT_SAMPLE_RATE = 13, /* real  clips: keep one frame in fps / sample_rate, rounded; 0:
                                      all */
    STLTSA_OPT_SMOOTHING = 14,   /* real  sigma in seconds of the Gaussian on the features; 0: none */
    STLTSA_OPT_PERIOD_MIN = 15,  /* real  shortest period looked for, seconds */
    STLTSA_OPT_PERIOD_MAX = 16,  /* real  longest period looked for, seconds */
    STLTSA_OPT_EIGENGAP = 17,    /* real  tau of section 2.3 as a fraction of k */
    STLTSA_OPT_VARIANCE = 18,    /* real  share of local variance that local PCA must hold */
    STLTSA_OPT_SKELETON = 19,    /* text  path of the ASF file of an AMC clip; auto: found beside
                                      the clip */
    STLTSA_OPT_KEEP_FRAMES = 20, /* int   1: a model keeps the frames it was fitted to, and so can map
                                      and unmap; 0: it keeps the coordinates only */
    STLTSA_OPT_MAP_NEIGHBORS = 21, /* int rows that a local map rests on; auto: max(d + 5, 10) */
    STLTSA_OPT_MAP_BLEND = 22,   /* int   stretches of the curve whose maps are blended */
    STLTSA_OPT_HINT_WINDOW = 23, /* int   rows to each side of a hint; auto: a fifth of k */
    STLTSA_OPT_COMPONENT = 24,   /* int   unmap: component that the coordinates are of, 0-based;
                                      auto: the only one there is */
    STLTSA_OPT_GAMMA = 25,       /* real  gamma of section 3.2, in units of the coordinate; auto:
                                      one robust standard deviation of the residuals */
    STLTSA_OPT_KNOT_SPACING = 26, /* real denoise: seconds (rows if the rate is unknown) between
                                      knots; auto: a tenth of the period, otherwise 2 rows */
    STLTSA_OPT_ROBUST = 27,      /* int   denoise: 1: spikes do not pull at the curve */
    STLTSA_OPT_CROSSFADE = 28,   /* real  synthesize: seconds to each side of a seam; auto: a tenth of
                                      the cycle that is repeated, 0.15 s where clips join */
    STLTSA_OPT_CUT_RANGE = 29,   /* real  synthesize: seconds by which a cut may move to find a common
                                      posture; auto: a tenth of the cycle that is repeated,
                                      half a cycle and at least 0.5 s where clips join */
    STLTSA_OPT_POSTURE_LIMIT = 30, /* real synthesize: largest distance of the postures at a seam, over
                                      what is common between a motion's own repetitions; 0: none */
    STLTSA_OPT_DIMENSION_ESTIMATE = 31 /* int decompose: 1: also estimate the intrinsic dimension of
                                      what is embedded (STLTSA_INFO_LOCAL_PCA, _EIGENGAP) */
};

enum {
    STLTSA_MODE_TEMPORAL = 1, /* the frames of the same clip within the window */
    STLTSA_MODE_SPATIAL = 2,  /* all frames; needs CHOLMOD */
    STLTSA_MODE_RECURRENT = 3 /* those of the window and, as links, the frames outside the
                                 exclusion zone; needs CHOLMOD */
};

enum {
    STLTSA_FEATURES_POSITIONS = 1,   /* joints and end sites, root position and yaw removed */
    STLTSA_FEATURES_ROTATIONS6D = 2, /* two columns of each rotation matrix, root yaw removed */
    STLTSA_FEATURES_EULER = 3,       /* the angles below the root in radians, unwrapped (the paper) */
    STLTSA_FEATURES_RAW = 4          /* the file's numbers */
};

enum { STLTSA_TYPE_INT = 1, STLTSA_TYPE_REAL = 2, STLTSA_TYPE_TEXT = 3 };

/* Bits of stltsa_option_info.calls: the functions that read an option. */
enum {
    STLTSA_CALL_OPEN = 1,         /* stltsa_clip_open, _parse */
    STLTSA_CALL_FEATURES = 2,     /* stltsa_clip_features, _feature_count */
    STLTSA_CALL_FIT = 4,          /* stltsa_fit, _fit_clip, _fit_clips */
    STLTSA_CALL_DIMENSION = 8,    /* stltsa_estimate_dimension, _clip, _clips */
    STLTSA_CALL_MAP = 16,         /* stltsa_map, _map_clip */
    STLTSA_CALL_UNMAP = 32,       /* stltsa_unmap, _unmap_clip */
    STLTSA_CALL_DECOMPOSE = 64,   /* stltsa_decompose */
    STLTSA_CALL_DENOISE = 128,    /* stltsa_denoise, _denoise_model */
    STLTSA_CALL_SYNTHESIZE = 256  /* stltsa_synthesize */
};

/* One row of the options table. Texts are static. `choices` is NULL, or "temporal=1 spatial=2"
 * for keys whose values have names. Append-only: set size to sizeof(stltsa_option_info). */
typedef struct stltsa_option_info {
    size_t size;
    int32_t key, type;
    const char *name;    /* "neighbors": the command's --neighbors */
    const char *text;    /* one sentence */
    const char *choices;
    double minimum, maximum; /* of ints and reals */
    double standard;     /* the default; NaN if automatic */
    int32_t automatic;   /* 1: there is no default, and the library chooses by the rule that the text
                            gives after "auto"; 0: not set means `standard` */
    int32_t calls;       /* STLTSA_CALL_*: the functions that read it */
} stltsa_option_info;

STLTSA_API int64_t stltsa_option_count(void) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_option_describe(int64_t index,
                                                stltsa_option_info *info) STLTSA_NOEXCEPT;

STLTSA_API stltsa_status stltsa_options_new(stltsa_options **options) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_options_free(stltsa_options *options) STLTSA_NOEXCEPT;

/* Set one option. E_ARGUMENT: unknown key, key of another type, or value outside its range; the
 * text says the range. A text is copied, and must not be empty. */
STLTSA_API stltsa_status stltsa_options_set_int(stltsa_options *options, int32_t key,
                                                int64_t value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_options_set_real(stltsa_options *options, int32_t key,
                                                 double value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_options_set_text(stltsa_options *options, int32_t key,
                                                 const char *value) STLTSA_NOEXCEPT;
/* Back to the default or, if there is none, to what the library chooses. E_ARGUMENT: unknown key. */
STLTSA_API stltsa_status stltsa_options_unset(stltsa_options *options, int32_t key) STLTSA_NOEXCEPT;
/* 1: the option was set; 0: it was not, or options is NULL, or the key is unknown. */
STLTSA_API int32_t stltsa_options_is_set(const stltsa_options *options,
                                         int32_t key) STLTSA_NOEXCEPT;
/* Read one option back, or its default if it is not set or options is NULL. E_ARGUMENT: as for
 * setting, and for an automatic option that is not set. */
STLTSA_API stltsa_status stltsa_options_get_int(const stltsa_options *options, int32_t key,
                                                int64_t *value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_options_get_real(const stltsa_options *options, int32_t key,
                                                 double *value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_options_get_text(const stltsa_options *options, int32_t key,
                                                 const char **value) STLTSA_NOEXCEPT;

/* Stages of the work as the progress callback sees them; a call passes through some of them, in
 * this order. */
enum {
    STLTSA_STAGE_READ = 0,      /* reading a clip */
    STLTSA_STAGE_FEATURES = 1,  /* features of its poses */
    STLTSA_STAGE_NEIGHBORS = 2, /* choice of k and neighbors; temporal ones come with the tangents */
    STLTSA_STAGE_TANGENTS = 3,  /* local tangents */
    STLTSA_STAGE_ALIGNMENT = 4, /* the alignment matrix */
    STLTSA_STAGE_SPECTRUM = 5,  /* its smallest eigenvectors */
    STLTSA_STAGE_UNITS = 6,     /* units and cycles */
    STLTSA_STAGE_MAP = 7,       /* mapping, either way */
    STLTSA_STAGE_DENOISE = 8,   /* denoising */
    STLTSA_STAGE_SYNTHESIS = 9  /* new motion */
};

/* `fraction` of the stage is done, 0 to 1; within a call neither the stage nor its fraction goes
 * back, but both may be the same as before, as while a decomposition makes its next fit. The rate of
 * the calls is not limited: a fit of 300 frames makes about 20 of them, one of 300 000 about 300.
 * Nonzero cancels: the call returns E_CANCELLED. It runs on the caller's thread and must not
 * throw or long-jump through the library. In the stage SPECTRUM it must not fit, decompose or
 * estimate a dimension, which returns E_ARGUMENT, nor wait for a thread that does, which never ends:
 * ARPACK works on one problem at a time. */
typedef int32_t (*stltsa_progress_fn)(void *user, int32_t stage, double fraction);

STLTSA_API stltsa_status stltsa_options_set_progress(stltsa_options *options,
                                                     stltsa_progress_fn progress,
                                                     void *user) STLTSA_NOEXCEPT;

/* ---- Facts ------------------------------------------------------------------------------ */

/* What a clip or a result says about itself, by key. Together with the arrays, intervals and seams
 * that have functions of their own these are all the facts of its JSON. An info belongs to the
 * handle that it came from and lives as long; it is NULL for NULL. */
typedef struct stltsa_info stltsa_info;

/* Keys. stltsa_info_describe() gives name, type and text of each at run time. A key with [] has any
 * number of values, any other has one, or none if the handle does not have that fact. */
enum {
    /* Where the frames come from. Of these four a result of a matrix has none. */
    STLTSA_INFO_PATH = 1,               /* text[] path of the clip as given; empty: from memory */
    STLTSA_INFO_FORMAT = 2,             /* int[]  STLTSA_FORMAT_* of the clip */
    STLTSA_INFO_CLIP_FRAMES = 3,        /* int[]  frames of the clip */
    STLTSA_INFO_CLIP_FPS = 4,           /* real[] frames a second of the clip; 0: unknown */
    STLTSA_INFO_NOTE = 5,               /* text[] what the reader of the clip assumed */
    STLTSA_INFO_CHANNEL = 6,            /* text[] names of the clip's channels; none if the
                                                  file has no names */
    STLTSA_INFO_FEATURES = 7,           /* int    STLTSA_FEATURES_* used */
    STLTSA_INFO_FEATURE_COUNT = 8,      /* int    columns of the features */
    STLTSA_INFO_UP_AXIS = 9,            /* int    axis that points up: 1, 2, 3 for x, y, z; 0:
                                                  none was needed */
    STLTSA_INFO_SMOOTHING = 10,         /* real   sigma in seconds of the Gaussian on the
                                                  features; 0: none */
    STLTSA_INFO_ROWS = 11,              /* int    rows that the method worked on */
    STLTSA_INFO_LENGTH = 12,            /* int[]  rows of each clip; of a denoising, of each
                                                  spline */
    STLTSA_INFO_FIRST_FRAME = 13,       /* int[]  row i of a clip is its source frame
                                                  first_frame + i * frame_step */
    STLTSA_INFO_FRAME_STEP = 14,        /* int[]  see first_frame; 1 for matrices */
    STLTSA_INFO_FPS = 15,               /* real   rows a second; 0: unknown */
    /* The fit. A denoising of given coordinates has none of these seven. */
    STLTSA_INFO_MODE = 20,              /* int    STLTSA_MODE_* */
    STLTSA_INFO_NEIGHBORS = 21,         /* int    k used, in rows */
    STLTSA_INFO_WINDOW = 22,            /* int    w used, in rows to each side */
    STLTSA_INFO_DIMENSION = 23,         /* int    tangent dimension d */
    STLTSA_INFO_INCLUDE_SELF = 24,      /* int    1: a row is among its own neighbors */
    STLTSA_INFO_LINKS = 25,             /* int    Recurrent: neighbors from outside the
                                                  exclusion zone */
    STLTSA_INFO_EXCLUSION = 26,         /* int    Recurrent: half width of that zone in rows */
    /* The period, if one was looked for. */
    STLTSA_INFO_PERIOD = 30,            /* real   period in seconds; 0: none */
    STLTSA_INFO_LAG_QUALITY = 31,       /* real   1 - D(T) of the period; 1: perfect, 0: no
                                                  period */
    STLTSA_INFO_PERIOD_MIN = 32,        /* real   shortest period looked for, in seconds; 0: no
                                                  search was made */
    STLTSA_INFO_PERIOD_MAX = 33,        /* real   longest period looked for, in seconds; 0: no
                                                  search was made */
    /* Models. */
    STLTSA_INFO_REPEATED = 40,          /* int    rows collapsed because they repeat the one
                                                  before */
    STLTSA_INFO_TIME_CORRELATION = 41,  /* real   absolute rank correlation of coordinate 1
                                                  with time, over at most 2^14 frames of the
                                                  largest component; 1: it only follows time */
    STLTSA_INFO_REACH = 42,             /* real   distance from the fitted frames, in units of
                                                  the features, up to which a new frame is like
                                                  them; 0: the model cannot map */
    STLTSA_INFO_COMPONENT_ROWS = 43,    /* int[]  distinct rows of each component of the
                                                  neighborhood graph */
    STLTSA_INFO_RANK_DEFICIENT = 44,    /* int[]  windows of fewer than d directions in each
                                                  component */
    STLTSA_INFO_SOLVES = 45,            /* int[]  applications of the inverse operator by
                                                  ARPACK, for each component */
    STLTSA_INFO_RESIDUAL = 46,          /* real[] largest ||B u - lambda u|| / k of each
                                                  component */
    STLTSA_INFO_ERROR_ESTIMATE = 47,    /* real[] estimate of the largest principal angle to
                                                  the exact embedding, in radians, for each
                                                  component */
    STLTSA_INFO_GAP = 48,               /* real[] lambda_{d+2} / lambda_{d+1} of each
                                                  component; near 1: the curve is ill-defined */
    STLTSA_INFO_COMPONENTS = 49,        /* int    components of the neighborhood graph */
    /* Decompositions; the last three are facts of a dimension, too. */
    STLTSA_INFO_COORDINATE = 60,        /* int    1-based column that was cut; 0: none */
    STLTSA_INFO_CYCLICITY = 61,         /* real   how well that coordinate repeats once a
                                                  period; 1: perfect */
    STLTSA_INFO_REPRESENTATIVE = 62,    /* int    index of the paper's cycle (first to third
                                                  candidate); -1: none */
    STLTSA_INFO_BEST = 63,              /* int    index of the cycle most like the others; -1:
                                                  none */
    STLTSA_INFO_REASON = 64,            /* text   why no cycle is claimed; empty if cycles are */
    STLTSA_INFO_EIGENVALUE = 65,        /* real[] eigenvalues, ascending, the zero one first:
                                                  of B, and of B / k in a dimension */
    STLTSA_INFO_LOCAL_PCA = 66,         /* int    intrinsic dimension by local PCA; 0: cannot
                                                  tell */
    STLTSA_INFO_EIGENGAP = 67,          /* int    intrinsic dimension by the eigengap; 0:
                                                  cannot tell */
    /* Dimensions. */
    STLTSA_INFO_LOCAL_PCA_REASON = 70,  /* text   why local PCA cannot tell; empty if it can */
    STLTSA_INFO_EIGENGAP_REASON = 71,   /* text   why the eigengap cannot tell; empty if it can */
    STLTSA_INFO_VARIANCE = 72,          /* real   share of local variance that local PCA must
                                                  hold */
    STLTSA_INFO_EIGENGAP_THRESHOLD = 73, /* real   tau of section 2.3 as a fraction of k */
    STLTSA_INFO_LOCAL_VARIANCE = 74,    /* real[] mean share of a neighborhood's variance along
                                                  each of its principal directions */
    /* Denoisings; the next five have a value for each column. */
    STLTSA_INFO_GAMMA = 80,             /* real[] threshold used in each column */
    STLTSA_INFO_SHIFT = 81,             /* real[] d_t: mean distance of the points beyond gamma
                                                  in each column */
    STLTSA_INFO_NOISE = 82,             /* real[] robust standard deviation of the residuals of
                                                  each column */
    STLTSA_INFO_DEGREES_OF_FREEDOM = 83, /* real[] effective degrees of freedom of the curve of
                                                   each column */
    STLTSA_INFO_MOVED = 84,             /* int[]  points that were moved in each column */
    STLTSA_INFO_GAMMA_OPTION = 85,      /* real   option gamma; none: chosen for each column */
    STLTSA_INFO_KNOT_ROWS = 86,         /* real   rows between the knots of the curve */
    STLTSA_INFO_ROBUST = 87,            /* int    1: spikes do not pull at the curve */
    STLTSA_INFO_FIT_PERIOD_MIN = 88,    /* real   period_min of the model whose coordinates
                                                  these are; 0: none */
    STLTSA_INFO_FIT_PERIOD_MAX = 89,    /* real   period_max of that model; 0: none */
    STLTSA_INFO_COLUMNS = 90,           /* int    columns of the coordinates */
    /* Syntheses. */
    STLTSA_INFO_CROSSFADE = 100,        /* real   option crossfade; none: chosen for each seam */
    STLTSA_INFO_CUT_RANGE = 101,        /* real   option cut_range; none: chosen for each seam */
    STLTSA_INFO_POSTURE_LIMIT = 102,    /* real   option posture_limit; 0: none */
    STLTSA_INFO_PIECE_PATH = 103,       /* text[] path of the clip of each piece; empty: from
                                                  memory */
    STLTSA_INFO_PIECE_BEGIN = 104,      /* int[]  first frame of each piece */
    STLTSA_INFO_PIECE_END = 105,        /* int[]  frame after the last of each piece */
    STLTSA_INFO_PIECE_REPEAT = 106,     /* int[]  how often each piece is played */
    /* Everything but clips. */
    STLTSA_INFO_WARNING = 120,          /* text[] what a user should know about the result */
    STLTSA_INFO_WARNING_CODE = 121,     /* int[]  STLTSA_WARNING_* of each warning */
    STLTSA_INFO_WARNING_BEGIN = 122,    /* real[] seconds in the clip at which each warning
                                                  applies; NaN: it has no time */
    STLTSA_INFO_WARNING_END = 123       /* real[] end of that time; the begin for a moment */
};

/* Kinds of warnings; new ones may be added. Those of a synthesis have the time of the seam. */
enum {
    STLTSA_WARNING_FOLLOWS_TIME = 1,    /* coordinate 1 only follows time */
    STLTSA_WARNING_RANK_DEFICIENT = 2,  /* windows vary in fewer than d directions */
    STLTSA_WARNING_SMALL_GAP = 3,       /* another dimension is better defined */
    STLTSA_WARNING_UNSCALED = 4,        /* rounding may turn a direction: scale the features */
    STLTSA_WARNING_INACCURATE = 5,      /* eigenvalues at the limit of double precision */
    STLTSA_WARNING_DISCONNECTED = 6,    /* the neighborhood graph falls apart */
    STLTSA_WARNING_JUMP = 7,            /* the pose jumps */
    STLTSA_WARNING_SEPARATE_MOTION = 8, /* a motion in which no cycle was looked for */
    STLTSA_WARNING_OFFSETS_DIFFER = 9,  /* clips joined have slightly different skeletons */
    STLTSA_WARNING_RESAMPLED = 10,      /* a clip was resampled to the first one's frame rate */
    STLTSA_WARNING_SEAM_POSTURE = 11,   /* postures at a seam are far apart */
    STLTSA_WARNING_SEAM_SPEED = 12,     /* unusually fast near a seam */
    STLTSA_WARNING_SEAM_ACCELERATION = 13, /* unusual acceleration near a seam */
    STLTSA_WARNING_NOT_BLENDED = 14     /* no frames beyond the cuts of a seam to blend */
};

/* How many values a key has here; 0: none, or an unknown key. */
STLTSA_API int64_t stltsa_info_count(const stltsa_info *info, int32_t key) STLTSA_NOEXCEPT;

/* One value; index 0 if there is one only. A text lives as long as the handle. E_ARGUMENT: the
 * handle does not have that fact or that many values, or the key is of another type. */
STLTSA_API stltsa_status stltsa_info_int(const stltsa_info *info, int32_t key, int64_t index,
                                         int64_t *value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_info_real(const stltsa_info *info, int32_t key, int64_t index,
                                          double *value) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_info_text(const stltsa_info *info, int32_t key, int64_t index,
                                          const char **value) STLTSA_NOEXCEPT;

/* Bits of stltsa_info_key.handles. */
enum {
    STLTSA_HANDLE_CLIP = 1,
    STLTSA_HANDLE_MODEL = 2,
    STLTSA_HANDLE_DIMENSION = 4,
    STLTSA_HANDLE_DECOMPOSITION = 8,
    STLTSA_HANDLE_DENOISING = 16,
    STLTSA_HANDLE_SYNTHESIS = 32
};

/* One row of the table of facts. Texts are static. `choices` is NULL, or "temporal=1 spatial=2" for
 * keys whose values have names. Append-only: set size to sizeof(stltsa_info_key). */
typedef struct stltsa_info_key {
    size_t size;
    int32_t key, type;   /* STLTSA_INFO_*, STLTSA_TYPE_* */
    const char *name;    /* "neighbors" */
    const char *text;    /* one sentence */
    const char *choices;
    int32_t is_list;     /* 1: any number of values */
    int32_t handles;     /* handles that can have it: STLTSA_HANDLE_*, added up */
} stltsa_info_key;

STLTSA_API int64_t stltsa_info_key_count(void) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_info_describe(int64_t index, stltsa_info_key *key) STLTSA_NOEXCEPT;

/* ---- Clips ------------------------------------------------------------------------------ */

typedef struct stltsa_clip stltsa_clip;

enum {
    STLTSA_FORMAT_BVH = 1, /* BVH */
    STLTSA_FORMAT_AMC = 2, /* AMC; needs its ASF: option skeleton, or found by subject number */
    STLTSA_FORMAT_CSV = 3, /* numbers split by , ; tab or blanks; a header line is optional */
    STLTSA_FORMAT_NPY = 4, /* NumPy 1.0 to 3.0, 1-D or 2-D, float32 or float64, C or Fortran;
                              others, as frames x joints x 3, are refused: reshape them */
    STLTSA_FORMAT_MATRIX = 5 /* no file: stltsa_clip_from_matrix */
};

/* Reads a clip; the format is told by the suffix, else by the content. Options used: fps,
 * skeleton, progress. E_IO, E_FORMAT (text: path, line, what to do), E_NOT_FINITE. */
STLTSA_API stltsa_status stltsa_clip_open(const char *path, const stltsa_options *options,
                                          stltsa_clip **clip) STLTSA_NOEXCEPT;

/* The same from memory; format 0: told by the content. */
STLTSA_API stltsa_status stltsa_clip_parse(const void *bytes, size_t size, int32_t format,
                                           const stltsa_options *options,
                                           stltsa_clip **clip) STLTSA_NOEXCEPT;

/* A clip of bare features, rows = frames; copied. fps > 0. */
STLTSA_API stltsa_status stltsa_clip_from_matrix(const stltsa_in *frames, double fps,
                                                 stltsa_clip **clip) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_clip_free(stltsa_clip *clip) STLTSA_NOEXCEPT;
/* Path, format, frames, notes, ...: see STLTSA_INFO_*. */
STLTSA_API const stltsa_info *stltsa_clip_info(const stltsa_clip *clip) STLTSA_NOEXCEPT;

STLTSA_API int64_t stltsa_clip_frames(const stltsa_clip *clip) STLTSA_NOEXCEPT;
STLTSA_API double stltsa_clip_fps(const stltsa_clip *clip) STLTSA_NOEXCEPT; /* 0: unknown */
STLTSA_API int32_t stltsa_clip_format(const stltsa_clip *clip) STLTSA_NOEXCEPT;
STLTSA_API int64_t stltsa_clip_channels(const stltsa_clip *clip) STLTSA_NOEXCEPT;
/* Joints and end sites in file order, parents first; 0 for a bare matrix. */
STLTSA_API int64_t stltsa_clip_joints(const stltsa_clip *clip) STLTSA_NOEXCEPT;
/* Index of the parent, -1 for the root. */
STLTSA_API stltsa_status stltsa_clip_joint(const stltsa_clip *clip, int64_t joint,
                                           const char **name, int64_t *parent,
                                           int32_t *is_end_site) STLTSA_NOEXCEPT;

/* World positions by forward kinematics: frames x (3 * joints), x y z of joint 0, joint 1, ...
 * E_UNSUPPORTED without a skeleton. */
STLTSA_API stltsa_status stltsa_clip_positions(const stltsa_clip *clip,
                                               const stltsa_out *positions) STLTSA_NOEXCEPT;
/* Local rotations: frames x (4 * joints), w x y z, of continuous sign over time. */
STLTSA_API stltsa_status stltsa_clip_rotations(const stltsa_clip *clip,
                                               const stltsa_out *rotations) STLTSA_NOEXCEPT;

/* Features of every source frame, unsmoothed: frames x the count below. Options: features, up
 * axis. */
STLTSA_API stltsa_status stltsa_clip_feature_count(const stltsa_clip *clip,
                                                   const stltsa_options *options,
                                                   int64_t *count) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_clip_features(const stltsa_clip *clip,
                                              const stltsa_options *options,
                                              const stltsa_out *features) STLTSA_NOEXCEPT;

/* One JSON object that says all of the above (schema: stltsa-clip/1); end it with
 * stltsa_free. */
STLTSA_API stltsa_status stltsa_clip_json(const stltsa_clip *clip, char **json) STLTSA_NOEXCEPT;

/* Writes a clip, whole or not at all. The format is told by the suffix: .bvh (any skeleton: its
 * hierarchy, channel order, units and frame time), .amc (only what was read from AMC; the ASF file
 * stays as it is), .csv, .npy (the numbers of any clip; CSV with a first column of time where the
 * frame rate is known). Numbers read back to the same bits.
 * E_ARGUMENT (another suffix), E_UNSUPPORTED (the clip has no skeleton, or none of that kind, or no
 * frame rate where the format needs one), E_IO. */
STLTSA_API stltsa_status stltsa_clip_save(const stltsa_clip *clip,
                                          const char *path) STLTSA_NOEXCEPT;

/* ---- The manifold curve: STLTSA --------------------------------------------------------- */

typedef struct stltsa_model stltsa_model;

/* Fits a model to frames x features (finite; at least k + 1 distinct frames in a row). Several
 * clips: one after another in `frames`; `lengths`, clips x 1, I64, has the frames of each, which
 * sum to rows; NULL: one clip. Temporal neighbors never cross clips. Every connected component of the
 * neighborhood graph is embedded on its own (columns centered, of unit norm); ask
 * STLTSA_INFO_COMPONENTS before you compare coordinates across clips or cuts.
 * Numbers may be as small as they like, but not beyond 1e100.
 * Options: neighbors, window, dimension, mode, include_self, links, exclusion, threads, fps (for
 * the automatic k), period_min, period_max, progress. Repeated frames are collapsed first and
 * get the coordinates of the one they repeat.
 * Memory: packed rows of float64 are read where they lie, so a mapped file will do; others are
 * copied. Beside them temporal neighbors take about 4k + 8kd bytes a frame, 8 for each column of
 * the band (between w and 2w), and 250; each thread up to 100 w^2 + 9000 w for distances, at most
 * 55 MB. Option keep_frames off spares the model its copy.
 * E_SHAPE, E_NOT_FINITE, E_TOO_FEW_FRAMES, E_ARGUMENT (needs d + 2 <= k <= w + 1), E_DEGENERATE,
 * E_NOT_CONVERGED, E_UNSUPPORTED (spatial, recurrent without CHOLMOD), E_CANCELLED,
 * E_NO_MEMORY. Section 2.2. */
STLTSA_API stltsa_status stltsa_fit(const stltsa_in *frames, const stltsa_in *lengths,
                                    const stltsa_options *options,
                                    stltsa_model **model) STLTSA_NOEXCEPT;

/* The same from a clip: its features, T-pose start dropped, smoothed and (option sample_rate)
 * decimated. Row i of the model is source frame STLTSA_INFO_FIRST_FRAME + i * STLTSA_INFO_FRAME_STEP. */
STLTSA_API stltsa_status stltsa_fit_clip(const stltsa_clip *clip, const stltsa_options *options,
                                         stltsa_model **model) STLTSA_NOEXCEPT;

/* The same from several clips, one after another, each prepared as by itself. STLTSA_INFO_LENGTH,
 * _FIRST_FRAME, _FRAME_STEP, _PATH and so on then have a value for each clip. The axis that points
 * up, and the skeleton of stltsa_unmap_clip, are those of the first. E_SHAPE: a clip has other joints
 * or channels than the first one, other features, or another rate after decimation. */
STLTSA_API stltsa_status stltsa_fit_clips(const stltsa_clip *const *clips, int64_t count,
                                          const stltsa_options *options,
                                          stltsa_model **model) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_model_free(stltsa_model *model) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *stltsa_model_info(const stltsa_model *model) STLTSA_NOEXCEPT;

/* rows x d. */
STLTSA_API stltsa_status stltsa_model_coords(const stltsa_model *model,
                                             const stltsa_out *coords) STLTSA_NOEXCEPT;
/* components x (d + 2): lambda_1 = 0, lambda_2, ... lambda_{d+2} of each, ascending; NaN where a
 * component is too small to have as many. */
STLTSA_API stltsa_status stltsa_model_eigenvalues(const stltsa_model *model,
                                                  const stltsa_out *values) STLTSA_NOEXCEPT;
/* rows x 1, I64: component of each row, counted from 0 in the order of their first rows. */
STLTSA_API stltsa_status stltsa_model_components(const stltsa_model *model,
                                                 const stltsa_out *labels) STLTSA_NOEXCEPT;
/* What a user should know: a coordinate that only follows time, a disconnected graph,
 * rank-deficient windows, a small gap, features of very different sizes. */
STLTSA_API int64_t stltsa_model_warning_count(const stltsa_model *model) STLTSA_NOEXCEPT;
STLTSA_API const char *stltsa_model_warning(const stltsa_model *model,
                                            int64_t index) STLTSA_NOEXCEPT; /* "" past the end */
STLTSA_API stltsa_status stltsa_model_json(const stltsa_model *model, char **json) STLTSA_NOEXCEPT;

/* ---- Intrinsic dimension (section 2.3) --------------------------------------------------- */

typedef struct stltsa_dimension stltsa_dimension;

/* Two estimates of the dimension of the manifold: the paper's first eigengap above tau, and the
 * median number of local principal directions that hold `variance` of a neighborhood. B is built
 * with tangent dimension `dimension` (auto: 2). The eigengap counts lambda_1 = 0, and one eigenvalue
 * more than that dimension is small by construction, so it moves with what was put in: read it
 * beside local PCA. Inputs and errors as stltsa_fit; a disconnected or degenerate graph is an
 * answer ("cannot tell"), not an error. */
STLTSA_API stltsa_status stltsa_estimate_dimension(const stltsa_in *frames,
                                                   const stltsa_in *lengths,
                                                   const stltsa_options *options,
                                                   stltsa_dimension **dimension) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status
stltsa_estimate_dimension_clip(const stltsa_clip *clip, const stltsa_options *options,
                               stltsa_dimension **dimension) STLTSA_NOEXCEPT;
/* Clips as stltsa_fit_clips takes them. */
STLTSA_API stltsa_status
stltsa_estimate_dimension_clips(const stltsa_clip *const *clips, int64_t count,
                                const stltsa_options *options,
                                stltsa_dimension **dimension) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_dimension_free(stltsa_dimension *dimension) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *
stltsa_dimension_info(const stltsa_dimension *dimension) STLTSA_NOEXCEPT;

/* 0: cannot tell; the reason then is the text ("" otherwise). */
STLTSA_API int64_t stltsa_dimension_eigengap(const stltsa_dimension *dimension,
                                             const char **reason) STLTSA_NOEXCEPT;
STLTSA_API int64_t stltsa_dimension_local_pca(const stltsa_dimension *dimension,
                                              const char **reason) STLTSA_NOEXCEPT;
/* Eigenvalues of B / k, ascending, the zero one first: as many rows as STLTSA_INFO_EIGENVALUE has
 * values (stltsa_info_count), one column. */
STLTSA_API stltsa_status stltsa_dimension_eigenvalues(const stltsa_dimension *dimension,
                                                      const stltsa_out *values) STLTSA_NOEXCEPT;
/* Mean share of a neighborhood's variance along its principal direction 1, 2, ...: as many rows as
 * STLTSA_INFO_LOCAL_VARIANCE has values, one column. */
STLTSA_API stltsa_status
stltsa_dimension_local_variances(const stltsa_dimension *dimension,
                                 const stltsa_out *shares) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_dimension_json(const stltsa_dimension *dimension,
                                               char **json) STLTSA_NOEXCEPT;

/* ---- Motion units and cycles (section 3.1) ----------------------------------------------- */

typedef struct stltsa_decomposition stltsa_decomposition;

enum {
    STLTSA_UNIT_PREPARING = 1, /* standing before a motion */
    STLTSA_UNIT_INITIAL = 2,   /* from the first movement to the first cycle */
    STLTSA_UNIT_CYCLIC = 3,    /* the cycles */
    STLTSA_UNIT_FINAL = 4,     /* from the last cycle to standing */
    STLTSA_UNIT_WIND_UP = 5,   /* standing after a motion */
    STLTSA_UNIT_ACTION = 6,    /* moving, and no cycle is claimed there */
    STLTSA_UNIT_CYCLE = 7      /* one cycle of the cyclic unit */
};
/* "preparing", "initial", "cyclic", "final", "wind-up", "action", "cycle"; "unknown" for
 * others. */
STLTSA_API const char *stltsa_unit_name(int32_t kind) STLTSA_NOEXCEPT;

/* [begin, end) in source frames, rounded; in seconds with fractions of a frame kept. Frozen. */
typedef struct stltsa_interval {
    int64_t begin, end;
    double begin_s, end_s;
    int32_t kind, reserved;
} stltsa_interval;

/* Cuts a clip into units and cycles. The period is found first, k and w follow from it, the
 * coordinate that swings once per cycle is chosen among tangent dimensions 1 to 3, smoothed, and
 * cut at its steepest points between peaks and valleys (the second derivative's zeros). Units
 * that are absent are left out; what moves apart from the one run of cycles, with standing
 * between, is an action, and a warning says when. A clip without trustworthy cycles gets activity
 * segments and a reason. That is an answer (STLTSA_OK), not an error.
 * Options: all of features, up axis, keep_start, sample_rate, smoothing, period_*, neighbors,
 * window, dimension, mode, dimension_estimate (with eigengap and variance), threads, progress. A clip
 * of unknown fps: E_ARGUMENT (set option fps when opening it). Other errors as stltsa_fit. */
STLTSA_API stltsa_status stltsa_decompose(const stltsa_clip *clip, const stltsa_options *options,
                                          stltsa_decomposition **decomposition) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_decomposition_free(stltsa_decomposition *decomposition) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *
stltsa_decomposition_info(const stltsa_decomposition *decomposition) STLTSA_NOEXCEPT;

/* Units in order of time; they cover [0, frames of the clip) without gap or overlap. */
STLTSA_API int64_t
stltsa_decomposition_unit_count(const stltsa_decomposition *decomposition) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_decomposition_unit(const stltsa_decomposition *decomposition,
                                                   int64_t index,
                                                   stltsa_interval *unit) STLTSA_NOEXCEPT;
/* Cycles in order of time, each from margin i to margin i + 2, back to back. */
STLTSA_API int64_t
stltsa_decomposition_cycle_count(const stltsa_decomposition *decomposition) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_decomposition_cycle(const stltsa_decomposition *decomposition,
                                                    int64_t index,
                                                    stltsa_interval *cycle) STLTSA_NOEXCEPT;

/* The smoothed coordinate that was cut: samples x 1. */
STLTSA_API stltsa_status stltsa_decomposition_curve(const stltsa_decomposition *decomposition,
                                                    const stltsa_out *curve) STLTSA_NOEXCEPT;
/* All coordinates of the fit that was cut, not smoothed: samples x STLTSA_INFO_DIMENSION;
 * zeros if there was nothing to fit (STLTSA_INFO_COORDINATE 0). Samples outside the moving
 * part of the clip have the coordinates of its nearest end. */
STLTSA_API stltsa_status stltsa_decomposition_coords(const stltsa_decomposition *decomposition,
                                                     const stltsa_out *coords) STLTSA_NOEXCEPT;
/* The two coordinates of the loop (Fig. 1): samples x 2. */
STLTSA_API stltsa_status stltsa_decomposition_loop(const stltsa_decomposition *decomposition,
                                                   const stltsa_out *loop) STLTSA_NOEXCEPT;
/* Why no cycle is claimed, in words with the numbers; "" where cycles are. */
STLTSA_API const char *
stltsa_decomposition_reason(const stltsa_decomposition *decomposition) STLTSA_NOEXCEPT;
STLTSA_API int64_t
stltsa_decomposition_warning_count(const stltsa_decomposition *decomposition) STLTSA_NOEXCEPT;
STLTSA_API const char *
stltsa_decomposition_warning(const stltsa_decomposition *decomposition,
                             int64_t index) STLTSA_NOEXCEPT;
/* The object of schema stltsa-decomposition/1; end it with stltsa_free. */
STLTSA_API stltsa_status stltsa_decomposition_json(const stltsa_decomposition *decomposition,
                                                   char **json) STLTSA_NOEXCEPT;

/* ---- Mapping, both ways (section 2.4) ---------------------------------------------------- */

/* Places new frames on the curve. Near each frame of the model the map is linear, as LTSA assumes,
 * resting on STLTSA_OPT_MAP_NEIGHBORS frames of the whole model. Between a frame and the next the maps
 * of both are blended, and the STLTSA_OPT_MAP_BLEND nearest such stretches of the curve are blended in
 * turn (the nearest frames, for spatial neighborhoods). A frame that was fitted gets its own
 * coordinates, to the bit; where equal frames come back after others, a hint must say which one is
 * meant, else it is the first of them.
 *
 * frames    rows x features of the model, finite
 * hints     NULL, or rows x 1, I64: the model row near which each row is looked for (within
 *           STLTSA_OPT_HINT_WINDOW rows of the same clip), -1: everywhere. For a stream: the
 *           nearest row of the frame before, plus a small STLTSA_OPT_HINT_WINDOW, so that time
 *           never runs back.
 * coords    rows x d
 * distance  NULL, or rows x 1: distance from the fitted frames over STLTSA_INFO_REACH. Beyond 1
 *           the frame is unlike what was learned, and its coordinates mean little.
 * nearest   NULL, or rows x 1, I64: the nearest model row of each row; the coordinates belong to
 *           the component of that row (stltsa_model_components)
 * Options: map_neighbors, map_blend, hint_window, threads, progress. E_SHAPE, E_NOT_FINITE,
 * E_ARGUMENT, E_UNSUPPORTED (the model kept no frames), E_CANCELLED. */
STLTSA_API stltsa_status stltsa_map(const stltsa_model *model, const stltsa_in *frames,
                                    const stltsa_in *hints, const stltsa_options *options,
                                    const stltsa_out *coords, const stltsa_out *distance,
                                    const stltsa_out *nearest) STLTSA_NOEXCEPT;

/* The same for every source frame of a clip: rows = stltsa_clip_frames(clip). Features, up axis and
 * smoothing are the model's; so a clip that was fitted gets its own coordinates at its model rows.
 * The model must be fitted to a clip; E_SHAPE where the two have other features. */
STLTSA_API stltsa_status stltsa_map_clip(const stltsa_model *model, const stltsa_clip *clip,
                                         const stltsa_options *options, const stltsa_out *coords,
                                         const stltsa_out *distance,
                                         const stltsa_out *nearest) STLTSA_NOEXCEPT;

/* The way back: frames (rows x features) from points of the manifold (rows x d). Distance is the
 * point's from the rows of the model, over what is common between neighboring ones; beyond 1 the
 * frame is a guess. Nearest is the nearer end of the stretch of the curve that the point is on:
 * where the curve passes itself by, a row of another stretch may be nearer. One coordinate alone
 * cannot tell a swing to from the swing fro: give hints, or fit more. For a model of a clip with a
 * skeleton the frames are the features of the poses that stltsa_unmap_clip gives, so that bones keep
 * their lengths. Options: as stltsa_map, and component. E_DISCONNECTED: the model has several
 * components, and option component does not say which. */
STLTSA_API stltsa_status stltsa_unmap(const stltsa_model *model, const stltsa_in *coords,
                                      const stltsa_in *hints, const stltsa_options *options,
                                      const stltsa_out *frames, const stltsa_out *distance,
                                      const stltsa_out *nearest) STLTSA_NOEXCEPT;

/* Poses from points of the manifold, as a clip with the skeleton that was fitted: rotations of all
 * joints, height and tilt; the body stays over the origin and faces one way. A point becomes a
 * frame, so the clip's rate is that of the points: option fps, which for what stltsa_map_clip gave
 * is the rate of that clip; auto: STLTSA_INFO_FPS, the rate of the rows. Other options: as
 * stltsa_unmap. E_UNSUPPORTED for a model of bare numbers, E_SHAPE for no points at all. */
STLTSA_API stltsa_status stltsa_unmap_clip(const stltsa_model *model, const stltsa_in *coords,
                                           const stltsa_in *hints, const stltsa_options *options,
                                           const stltsa_out *distance, const stltsa_out *nearest,
                                           stltsa_clip **poses) STLTSA_NOEXCEPT;

/* ---- Model files ------------------------------------------------------------------------- */

/* A model as bytes: versioned, little-endian, checksummed, the same on every machine; what comes
 * back has the same bits. Parsing takes hostile bytes: E_FORMAT says what is wrong with them. End
 * the bytes with stltsa_free. */
STLTSA_API stltsa_status stltsa_model_serialize(const stltsa_model *model, unsigned char **bytes,
                                                size_t *size) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_model_parse(const void *bytes, size_t size,
                                            stltsa_model **model) STLTSA_NOEXCEPT;

/* The same to and from a file, which is written whole or not at all. E_IO, E_FORMAT. */
STLTSA_API stltsa_status stltsa_model_save(const stltsa_model *model,
                                           const char *path) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_model_load(const char *path, stltsa_model **model) STLTSA_NOEXCEPT;

/* ---- Denoising (section 3.2) ------------------------------------------------------------- */

typedef struct stltsa_denoising stltsa_denoising;

/* Cleans coordinates, rows x columns, each column for itself. The curve is a penalized least-squares
 * cubic spline over time, its smoothing chosen by generalized cross-validation; points farther than
 * gamma from it are moved towards it by their mean distance, as in equation (1), but never across
 * it. Several clips: as in stltsa_fit; each has a spline of its own. Look for extrema and margins on
 * the curve, never on the moved points. Options: gamma, knot_spacing, robust, fps, period_min,
 * period_max, progress. E_SHAPE, E_NOT_FINITE, E_TOO_FEW_FRAMES (fewer than 8 rows in a clip). */
STLTSA_API stltsa_status stltsa_denoise(const stltsa_in *coords, const stltsa_in *lengths,
                                        const stltsa_options *options,
                                        stltsa_denoising **denoising) STLTSA_NOEXCEPT;
/* The coordinates of a model, component by component; rate and period are the model's. */
STLTSA_API stltsa_status stltsa_denoise_model(const stltsa_model *model,
                                              const stltsa_options *options,
                                              stltsa_denoising **denoising) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_denoising_free(stltsa_denoising *denoising) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *
stltsa_denoising_info(const stltsa_denoising *denoising) STLTSA_NOEXCEPT;

/* rows x columns: the fitted curve f_c; the points after equation (1); by how much each was moved
 * (0: it was not). */
STLTSA_API stltsa_status stltsa_denoising_curve(const stltsa_denoising *denoising,
                                                const stltsa_out *curve) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_denoising_cleaned(const stltsa_denoising *denoising,
                                                  const stltsa_out *cleaned) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_denoising_moves(const stltsa_denoising *denoising,
                                                const stltsa_out *moves) STLTSA_NOEXCEPT;
/* The object of schema stltsa-denoising/1. */
STLTSA_API stltsa_status stltsa_denoising_json(const stltsa_denoising *denoising,
                                               char **json) STLTSA_NOEXCEPT;

/* ---- New motion from units (section 4) ---------------------------------------------------- */

/* Frames [begin, end) of a clip, `repeat` times (1: once). Set reserved to 0. Frozen. */
typedef struct stltsa_piece {
    const stltsa_clip *clip;
    int64_t begin, end;
    int64_t repeat, reserved;
} stltsa_piece;

typedef struct stltsa_synthesis stltsa_synthesis;

/* Joins pieces, in order, into one clip. Where a piece does not go on where the one before ended,
 * the cuts are moved (option cut_range) to the pair of frames whose postures and velocities are most
 * alike, and the two are crossfaded; the body goes on from where it stood, facing the way it faced, and
 * repetitions do not add up what is no turn of the body but the swing of its heading.
 * Pieces that follow each other in their clip are joined as they were, so the units of a clip give
 * the clip back; of what is left out between pieces of one clip, or played twice, at least half
 * stays so. All clips need one hierarchy; the first one gives hierarchy, channels, units and
 * frame rate, to which others are resampled. Options: crossfade, cut_range, posture_limit, up axis,
 * progress. E_ARGUMENT, E_UNSUPPORTED (bare numbers, other hierarchies, no frame rate),
 * E_NO_COMMON_POSTURE (beyond posture_limit; the text says at which seam and by how much). */
STLTSA_API stltsa_status stltsa_synthesize(const stltsa_piece *pieces, int64_t count,
                                           const stltsa_options *options,
                                           stltsa_synthesis **synthesis) STLTSA_NOEXCEPT;
STLTSA_API void stltsa_synthesis_free(stltsa_synthesis *synthesis) STLTSA_NOEXCEPT;
STLTSA_API const stltsa_info *
stltsa_synthesis_info(const stltsa_synthesis *synthesis) STLTSA_NOEXCEPT;
/* The new clip; it belongs to the synthesis. */
STLTSA_API const stltsa_clip *
stltsa_synthesis_clip(const stltsa_synthesis *synthesis) STLTSA_NOEXCEPT;

/* A place where one piece gives way to another (or to its own repetition). Append-only: set size
 * to sizeof(stltsa_seam). */
typedef struct stltsa_seam {
    size_t size;
    int64_t frame;           /* first frame of the new clip that is the later piece's */
    int64_t piece, next;     /* indices of the pieces that meet there */
    int64_t cut_end, cut_begin; /* the cuts, in frames of their clips (resampled, where they were):
                                   the earlier piece ends before cut_end, the later begins there */
    int64_t crossfade;       /* frames to each side that are blended; 0: none */
    double posture;          /* distance of postures and velocities at the cuts over what is common
                                between repetitions of the same motion; 1: as alike as those */
    double step, acceleration; /* largest pose step, and second difference, near the seam over the
                                95th percentile of the pieces': 1 and below is not to be seen */
} stltsa_seam;
STLTSA_API int64_t stltsa_synthesis_seam_count(const stltsa_synthesis *synthesis) STLTSA_NOEXCEPT;
STLTSA_API stltsa_status stltsa_synthesis_seam(const stltsa_synthesis *synthesis, int64_t index,
                                               stltsa_seam *seam) STLTSA_NOEXCEPT;
STLTSA_API int64_t
stltsa_synthesis_warning_count(const stltsa_synthesis *synthesis) STLTSA_NOEXCEPT;
STLTSA_API const char *stltsa_synthesis_warning(const stltsa_synthesis *synthesis,
                                                int64_t index) STLTSA_NOEXCEPT;
/* The object of schema stltsa-synthesis/1. */
STLTSA_API stltsa_status stltsa_synthesis_json(const stltsa_synthesis *synthesis,
                                               char **json) STLTSA_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif /* STLTSA_H */
