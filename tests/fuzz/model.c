/* SPDX-License-Identifier: BSD-3-Clause */
/* A model file, as it is and with its checksum mended: what parses has the same bytes again, maps a
 * row, and may follow a stream. */
#include <zlib.h>

#include "target.h"

int accepted_inputs;

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

/* magic, version, size of the content; after the content, its CRC-32 */
enum { start = 12, head = start + 8, tail = 4 };

/* The first bytes of every model file of this version. */
static const unsigned char* start_of_models(void) {
    static unsigned char bytes[start];
    if (bytes[0] != 0)
        return bytes;
    double x[60];
    for (int i = 0; i < 60; ++i)
        x[i] = sin(0.1 * i * (1 + i % 2));
    const stltsa_in in = given(x, 30, 2);
    stltsa_options* options = NULL;
    stltsa_model* model = NULL;
    unsigned char* made = NULL;
    size_t size = 0;
    if (stltsa_options_new(&options) == STLTSA_OK &&
        stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, 8) == STLTSA_OK &&
        stltsa_fit(&in, NULL, options, &model) == STLTSA_OK &&
        stltsa_model_serialize(model, &made, &size) == STLTSA_OK)
        memcpy(bytes, made, start);
    stltsa_free(made);
    stltsa_model_free(model);
    stltsa_options_free(options);
    promise(bytes[0] != 0, "a small model can be fitted");
    return bytes;
}

static void put(unsigned char* to, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
        to[i] = (unsigned char)(value >> (8 * i));
}

/* Makes the bytes pass the checks of the file as a whole, which random bytes never do. */
static void seal(unsigned char* bytes, size_t size) {
    memcpy(bytes, start_of_models(), start);
    put(bytes + start, size - head - tail, head - start);
    put(bytes + size - tail, crc32(0, bytes, (uInt)(size - tail)), tail);
}

static void use_model(const unsigned char* data, size_t size) {
    stltsa_model* model = NULL;
    unsigned char* bytes = NULL;
    size_t count = 0;
    MAKES(stltsa_model_parse(data, size, &model), model);
    if (model == NULL)
        return;
    ++accepted_inputs;
    MAKES(stltsa_model_serialize(model, &bytes, &count), bytes);
    promise(bytes == NULL || (count == size && memcmp(bytes, data, size) == 0), "the same bytes");
    stltsa_free(bytes);
    read_all(stltsa_model_info(model));
    map_there_and_back(model);
    stltsa_model_free(model);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    unsigned char* sealed = size < head + tail ? NULL : malloc(size);
    if (sealed == NULL) {
        use_model(data, size);
        return 0;
    }
    memcpy(sealed, data, size);
    seal(sealed, size);
    if (memcmp(sealed, data, size) != 0)
        use_model(data, size);
    use_model(sealed, size);
    free(sealed);
    return 0;
}
