/* SPDX-License-Identifier: BSD-3-Clause */
/* Shared by the fuzz targets: each takes any bytes, must answer with a status, and leaks nothing.
 */
#ifndef STLTSA_FUZZ_TARGET_H
#define STLTSA_FUZZ_TARGET_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <stltsa.h>

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
/* Inputs that were not refused; each target defines it. */
extern int accepted_inputs;

/* Ends the process: a broken promise of the interface is a finding, as a crash is. */
static inline void promise(int kept, const char* text) {
    if (!kept) {
        fprintf(stderr, "broken promise: %s (%s)\n", text, stltsa_last_error());
        abort();
    }
}

static inline void promise_status(stltsa_status status, const void* made) {
    promise((status == STLTSA_OK) == (made != NULL), "a handle if, and only if, the call succeeds");
    promise(status != STLTSA_E_INTERNAL, "no internal error");
    promise(status == STLTSA_OK || stltsa_last_error()[0] != '\0', "a sentence for each error");
}

/* The call must make the handle or fail; the handle is looked at afterwards. */
#define MAKES(call, made)                                                                          \
    do {                                                                                           \
        const stltsa_status status_ = (call);                                                      \
        promise_status(status_, made);                                                             \
    } while (0)

static inline stltsa_out packed(double* values, int64_t rows, int64_t cols) {
    stltsa_out out = {NULL, 0, 0, 0, 0, STLTSA_F64, 0};
    out.data = values;
    out.rows = rows;
    out.cols = cols;
    return out;
}

static inline stltsa_in given(const double* values, int64_t rows, int64_t cols) {
    stltsa_in in = {NULL, 0, 0, 0, 0, STLTSA_F64, 0};
    in.data = values;
    in.rows = rows;
    in.cols = cols;
    return in;
}

static inline stltsa_status fit_clip(const stltsa_clip* clip, const stltsa_options* options,
                                     stltsa_model** model) {
    return stltsa_fit_clips(&clip, 1, options, model);
}

/* Reads the first value, row or array of each key; a handle has what it counts. */
static inline void read_all(const stltsa_info* info) {
    stltsa_info_key key = {.size = sizeof key};
    for (int64_t i = 0; stltsa_info_describe(i, &key) == STLTSA_OK; ++i) {
        int64_t whole = 0, rows = 0, cols = 0;
        double real = 0;
        const char* text = NULL;
        char row[1024];
        if (stltsa_info_count(info, key.key) == 0)
            continue;
        stltsa_status status =
            key.type == STLTSA_TYPE_INT    ? stltsa_info_int(info, key.key, 0, &whole)
            : key.type == STLTSA_TYPE_REAL ? stltsa_info_real(info, key.key, 0, &real)
            : key.type == STLTSA_TYPE_TEXT ? stltsa_info_text(info, key.key, 0, &text)
            : key.type == STLTSA_TYPE_ROWS ? stltsa_info_rows(info, key.key, 0, 1, row, sizeof row)
                                           : stltsa_info_shape(info, key.key, &rows, &cols);
        if (status == STLTSA_OK && key.type == STLTSA_TYPE_ARRAY && rows * cols < 100000) {
            double* values = malloc((size_t)(rows * cols) * sizeof *values + 1);
            const stltsa_out to = packed(values, rows, cols);
            if (values != NULL)
                status = stltsa_info_array(info, key.key, 0, &to);
            free(values);
        }
        promise(status == STLTSA_OK, key.name);
    }
}

/* Asks a clip for all that is cheap, and decomposes it if it is small. */
static inline void use_clip(const stltsa_clip* clip) {
    const int64_t frames = stltsa_clip_frames(clip);
    int64_t columns = 0;
    char* json = NULL;
    MAKES(stltsa_info_json(stltsa_clip_info(clip), &json), json);
    stltsa_free(json);
    read_all(stltsa_clip_info(clip));
    if (stltsa_clip_feature_count(clip, NULL, &columns) != STLTSA_OK || frames * columns > 20000)
        return;
    double* values = malloc((size_t)(frames * columns) * sizeof *values);
    const stltsa_out out = packed(values, frames, columns);
    if (values != NULL)
        promise(stltsa_clip_features(clip, NULL, &out) != STLTSA_E_INTERNAL, "no internal error");
    free(values);
    if (frames * columns > 4000)
        return;
    stltsa_decomposition* found = NULL;
    stltsa_phase* phase = NULL;
    stltsa_clip* image = NULL;
    MAKES(stltsa_decompose(clip, NULL, &found), found);
    if (found != NULL) {
        read_all(stltsa_decomposition_info(found));
        MAKES(stltsa_phase_find(found, NULL, &phase), phase);
    }
    MAKES(stltsa_clip_mirror(clip, NULL, &image), image);
    stltsa_clip_free(image);
    stltsa_phase_free(phase);
    stltsa_decomposition_free(found);
}

/* Reads bytes in a format, at the rate that they say. */
static inline void read_with(const stltsa_options* options, int32_t format, const uint8_t* data,
                             size_t size) {
    stltsa_clip* clip = NULL;
    MAKES(stltsa_clip_parse(data, size, format, NULL, options, &clip), clip);
    if (clip != NULL) {
        ++accepted_inputs;
        use_clip(clip);
    }
    stltsa_clip_free(clip);
}

/* The same; the rate is given, since many formats have none. */
static inline void read_as(int32_t format, const uint8_t* data, size_t size) {
    stltsa_options* options = NULL;
    if (stltsa_options_new(&options) != STLTSA_OK)
        return;
    stltsa_options_set_real(options, STLTSA_OPT_FPS, 30);
    read_with(options, format, data, size);
    stltsa_options_free(options);
}

#endif
