/* SPDX-License-Identifier: BSD-3-Clause */
/* Random options and small random matrices in the functions that compute. */
#include "target.h"

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
    const int64_t count = stltsa_option_count();
    if (stltsa_option_describe((int64_t)take(from) % count, &info) != STLTSA_OK ||
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
    MAKES(stltsa_model_json(model, &json), json);
    stltsa_free(json);
    stltsa_info_int(stltsa_model_info(model), STLTSA_INFO_DIMENSION, 0, &dimension);
    if (dimension <= most_columns) {
        const stltsa_out coords = packed(room, frames->rows, dimension);
        promise(stltsa_map(model, frames, NULL, NULL, &coords, NULL, NULL) != STLTSA_E_INTERNAL,
                "no internal error");
    }
    MAKES(stltsa_denoise_model(model, NULL, &denoising), denoising);
    stltsa_denoising_free(denoising);
}

static void decompose(const stltsa_in* frames, const stltsa_options* options) {
    stltsa_clip* clip = NULL;
    stltsa_decomposition* found = NULL;
    stltsa_phase* phase = NULL;
    stltsa_events* events = NULL;
    MAKES(stltsa_clip_from_matrix(frames, 10, &clip), clip);
    if (clip != NULL)
        MAKES(stltsa_decompose(clip, options, &found), found);
    if (found != NULL)
        MAKES(stltsa_phase_find(clip, found, options, &phase), phase);
    if (phase != NULL) {
        const double mark = (double)frames->rows / 2;
        const stltsa_in marks = given(&mark, 1, 1);
        MAKES(stltsa_events_find(phase, &marks, NULL, &events), events);
    }
    stltsa_events_free(events);
    stltsa_phase_free(phase);
    stltsa_decomposition_free(found);
    stltsa_clip_free(clip);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    bytes from = {data, size};
    double values[most_rows * most_columns], room[most_rows * most_columns];
    const unsigned what = take(&from) % 4, settings = take(&from) % 6;
    const int64_t rows = 1 + take(&from) % most_rows, columns = 1 + take(&from) % most_columns;
    stltsa_options* options = NULL;
    stltsa_model* model = NULL;
    stltsa_dimension* dimension = NULL;
    stltsa_denoising* denoising = NULL;
    if (stltsa_options_new(&options) != STLTSA_OK)
        return 0;
    for (unsigned i = 0; i < settings; ++i)
        set_option(options, &from);
    stltsa_options_set_int(options, STLTSA_OPT_THREADS, 1);
    for (int64_t i = 0; i < rows * columns; ++i)
        values[i] = take_number(&from);
    const stltsa_in frames = given(values, rows, columns);
    if (what == 0) {
        MAKES(stltsa_fit(&frames, NULL, options, &model), model);
        if (model != NULL)
            use_model(model, &frames, room);
    } else if (what == 1) {
        decompose(&frames, options);
    } else if (what == 2) {
        MAKES(stltsa_estimate_dimension(&frames, NULL, options, &dimension), dimension);
    } else {
        MAKES(stltsa_denoise(&frames, NULL, options, &denoising), denoising);
    }
    stltsa_denoising_free(denoising);
    stltsa_dimension_free(dimension);
    stltsa_model_free(model);
    stltsa_options_free(options);
    return 0;
}
