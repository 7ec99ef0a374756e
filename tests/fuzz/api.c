/* SPDX-License-Identifier: BSD-3-Clause */
/* Random options and small random matrices in the functions that compute. */
#include "target.h"

int accepted_inputs;

enum { most_rows = 64, most_columns = 5 };

typedef struct bytes {
    const uint8_t* data;
    size_t size;
} bytes;

static unsigned take(bytes* from) {
    if (from->size == 0)
        return 0;
    --from->size;
    return *from->data++;
}

/* Ordinary numbers for the most part; a few that are not. */
static double take_number(bytes* from) {
    static const double odd[] = {0, -0.0, 1e300, -1e300, 1e-310, NAN, INFINITY, 1e-163};
    const unsigned byte = take(from);
    return byte >= 248 ? odd[byte - 248] : ((double)byte - 124) / 16 + take(from) / 4096.0;
}

static void set_option(stltsa_options* options, bytes* from) {
    stltsa_option_info info = {.size = sizeof info};
    enum { options_there_are = STLTSA_OPT_INTRINSIC - 1 }; /* no option has the value 31 */
    if (stltsa_option_describe((int64_t)(take(from) % options_there_are), &info) != STLTSA_OK ||
        info.key == STLTSA_OPT_SKELETON)
        return;
    if (info.type == STLTSA_TYPE_INT)
        stltsa_options_set_int(options, info.key, (int64_t)take(from) - 2);
    else if (info.type == STLTSA_TYPE_REAL)
        stltsa_options_set_real(options, info.key, take_number(from));
}

static void use_model(const stltsa_model* model, const stltsa_in* frames, double* room) {
    int64_t dimension = 0;
    char* json = NULL;
    stltsa_denoising* denoising = NULL;
    MAKES(stltsa_info_json(stltsa_model_info(model), &json), json);
    read_all(stltsa_model_info(model));
    stltsa_free(json);
    stltsa_info_int(stltsa_model_info(model), STLTSA_INFO_DIMENSION, 0, &dimension);
    if (dimension <= most_columns) {
        const stltsa_out coords = packed(room, frames->rows, dimension);
        promise(stltsa_map(model, frames, NULL, NULL, &coords, NULL, NULL) != STLTSA_E_INTERNAL,
                "no internal error");
    }
    MAKES(stltsa_denoise_model(model, NULL, &denoising), denoising);
    read_all(stltsa_denoising_info(denoising));
    stltsa_denoising_free(denoising);
}

static void compare(const stltsa_clip* clip, const stltsa_phase* phase, const stltsa_in* frames,
                    const stltsa_options* options) {
    const double mark = (double)frames->rows / 2;
    const stltsa_in marks = given(&mark, 1, 1);
    stltsa_events* events = NULL;
    stltsa_cycles* cycles = NULL;
    stltsa_comparison *with_itself = NULL, *of_sides = NULL;
    MAKES(stltsa_events_find(phase, &marks, NULL, options, &events), events);
    MAKES(stltsa_cycles_resample(phase, 0, frames, 7, options, &cycles), cycles);
    MAKES(stltsa_compare(phase, -1, phase, -1, 7, options, &with_itself), with_itself);
    MAKES(stltsa_compare_left_right(clip, phase, -1, 7, options, &of_sides), of_sides);
    read_all(stltsa_events_info(events));
    read_all(stltsa_cycles_info(cycles));
    read_all(stltsa_comparison_info(with_itself));
    if (with_itself != NULL)
        promise(stltsa_comparison_report_save(with_itself, NULL, "", "/dev/null") == STLTSA_OK,
                "each comparison has a report");
    stltsa_comparison_free(of_sides);
    stltsa_comparison_free(with_itself);
    stltsa_cycles_free(cycles);
    stltsa_events_free(events);
}

typedef struct cycles {
    stltsa_decomposition* found;
    stltsa_phase* phase;
} cycles;

static cycles find_cycles(const stltsa_clip* clip, const stltsa_options* options) {
    cycles made = {NULL, NULL};
    MAKES(stltsa_decompose(clip, options, &made.found), made.found);
    if (made.found != NULL)
        MAKES(stltsa_phase_find(made.found, options, &made.phase), made.phase);
    return made;
}

static void free_cycles(cycles made) {
    stltsa_phase_free(made.phase);
    stltsa_decomposition_free(made.found);
}

static void decompose(const stltsa_clip* clip, const stltsa_in* frames,
                      const stltsa_options* options) {
    const cycles made = find_cycles(clip, options);
    stltsa_synthesis* loop = NULL;
    if (made.found != NULL) {
        MAKES(stltsa_synthesize_loop(clip, made.found, options, &loop), loop);
        promise(stltsa_report_save(clip, made.found, options, "", "/dev/null") != STLTSA_E_INTERNAL,
                "no internal error");
    }
    if (made.phase != NULL)
        compare(clip, made.phase, frames, options);
    stltsa_synthesis_free(loop);
    free_cycles(made);
}

/* A hip with two feet: the columns are the channels of the hip. Decomposes it, and joins two
 * pieces. */
static void move_body(const stltsa_in* frames, const stltsa_options* options) {
    static const char* const channels[] = {"",         "rx",          "rz rx",
                                           "rz rx ry", "ty rz rx ry", "tx ty rz rx ry"};
    const stltsa_joint joints[] = {{"hip", -1, {0, 0, 0}, channels[frames->cols], 0},
                                   {"l_foot", 0, {1, -4, 0}, "", 1},
                                   {"r_foot", 0, {-1, -4, 0}, "", 1}};
    stltsa_clip* clip = NULL;
    stltsa_synthesis* synthesis = NULL;
    MAKES(stltsa_clip_from_skeleton(joints, sizeof *joints, 3, STLTSA_ROTATIONS_CHANNELS, frames,
                                    NULL, 10, &clip),
          clip);
    if (clip == NULL)
        return;
    const int64_t half = frames->rows / 2;
    const stltsa_piece pieces[] = {{clip, 0, half, 2, 0}, {clip, half / 2, frames->rows, 1, 0}};
    decompose(clip, frames, options);
    MAKES(stltsa_synthesize(pieces, 2, options, &synthesis), synthesis);
    read_all(stltsa_synthesis_info(synthesis));
    stltsa_synthesis_free(synthesis);
    stltsa_clip_free(clip);
}

static void stream(const stltsa_clip* clip, const stltsa_in* frames,
                   const stltsa_options* options) {
    const cycles made = find_cycles(clip, options);
    stltsa_model* model = NULL;
    stltsa_live* live = NULL;
    if (made.phase != NULL)
        MAKES(fit_clip(clip, options, &model), model);
    if (model != NULL && stltsa_model_keep_cycle(model, made.phase, options) == STLTSA_OK)
        MAKES(stltsa_live_new(model, &live), live);
    for (int64_t i = 0; live != NULL && i < frames->rows; ++i) {
        stltsa_live_frame frame = {.size = sizeof frame};
        promise(stltsa_live_push_frame(live, 0.1 * (double)i, clip, i, &frame) != STLTSA_E_INTERNAL,
                "no internal error");
    }
    stltsa_live_free(live);
    stltsa_model_free(model);
    free_cycles(made);
}

static void use_matrix(const stltsa_in* frames, const stltsa_options* options,
                       void (*use)(const stltsa_clip*, const stltsa_in*, const stltsa_options*)) {
    stltsa_clip* clip = NULL;
    MAKES(stltsa_clip_from_matrix(frames, 10, &clip), clip);
    if (clip != NULL)
        use(clip, frames, options);
    stltsa_clip_free(clip);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    bytes from = {data, size};
    double values[most_rows * most_columns], room[most_rows * most_columns];
    const unsigned what = take(&from) % 8, settings = take(&from) % 6;
    const int64_t rows = 1 + take(&from) % most_rows, columns = 1 + take(&from) % most_columns;
    stltsa_options* options = NULL;
    stltsa_model* model = NULL;
    stltsa_denoising* denoising = NULL;
    if (stltsa_options_new(&options) != STLTSA_OK)
        return 0;
    ++accepted_inputs;
    for (unsigned i = 0; i < settings; ++i)
        set_option(options, &from);
    stltsa_options_set_int(options, STLTSA_OPT_THREADS, 1);
    for (int64_t i = 0; i < rows * columns; ++i)
        values[i] = take_number(&from);
    stltsa_in frames = given(values, rows, columns);
    if (rows % 2 == 0) { /* columns one after another */
        frames.row_stride = sizeof *values;
        frames.col_stride = rows * (int64_t)sizeof *values;
    }
    if (what == 0 || what == 2) {
        if (what == 2)
            stltsa_options_set_int(options, STLTSA_OPT_INTRINSIC, 1);
        MAKES(stltsa_fit(&frames, NULL, options, &model), model);
        if (model != NULL)
            use_model(model, &frames, room);
    } else if (what == 1 || what == 4) {
        use_matrix(&frames, options, decompose);
    } else if (what == 5 || what == 6) {
        move_body(&frames, options);
    } else if (what == 7) {
        use_matrix(&frames, options, stream);
    } else {
        MAKES(stltsa_denoise(&frames, NULL, options, &denoising), denoising);
    }
    stltsa_denoising_free(denoising);
    stltsa_model_free(model);
    stltsa_options_free(options);
    return 0;
}
