/* SPDX-License-Identifier: BSD-3-Clause */
/* A model file: what parses has the same bytes again, maps a row, and may follow a stream. */
#include "target.h"

static void follow(const stltsa_model* model, const double* row, int64_t columns) {
    stltsa_live* live = NULL;
    stltsa_live_frame now = {.size = sizeof now};
    const stltsa_in in = given(row, 1, columns);
    MAKES(stltsa_live_new(model, &live), live);
    for (int i = 0; live != NULL && i < 3; ++i)
        promise(stltsa_live_push(live, i / 30.0, &in, &now) != STLTSA_E_INTERNAL,
                "no internal error");
    stltsa_live_free(live);
}

static void map_there_and_back(const stltsa_model* model) {
    const stltsa_info* info = stltsa_model_info(model);
    int64_t columns = 0, dimension = 0;
    if (stltsa_info_int(info, STLTSA_INFO_FEATURE_COUNT, 0, &columns) != STLTSA_OK ||
        stltsa_info_int(info, STLTSA_INFO_DIMENSION, 0, &dimension) != STLTSA_OK ||
        columns > 1000 || dimension > 1000)
        return;
    double *row = calloc((size_t)columns, sizeof *row), *at = calloc((size_t)dimension, sizeof *at);
    if (row != NULL && at != NULL) {
        const stltsa_in frame = given(row, 1, columns), point = given(at, 1, dimension);
        const stltsa_out coords = packed(at, 1, dimension), back = packed(row, 1, columns);
        promise(stltsa_map(model, &frame, NULL, NULL, &coords, NULL, NULL) != STLTSA_E_INTERNAL,
                "no internal error");
        promise(stltsa_unmap(model, &point, NULL, NULL, &back, NULL, NULL) != STLTSA_E_INTERNAL,
                "no internal error");
        follow(model, row, columns);
    }
    free(row);
    free(at);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    stltsa_model* model = NULL;
    unsigned char* bytes = NULL;
    size_t count = 0;
    MAKES(stltsa_model_parse(data, size, &model), model);
    if (model == NULL)
        return 0;
    MAKES(stltsa_model_serialize(model, &bytes, &count), bytes);
    stltsa_free(bytes);
    map_there_and_back(model);
    stltsa_model_free(model);
    return 0;
}
