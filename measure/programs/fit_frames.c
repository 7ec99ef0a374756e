/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Fits two coordinates to frames from a file, twice, for scripts/benchmark. The first fit measures
 * peak memory; the second one, which reuses that memory, measures time in total and by stage.
 * Prints one line of JSON and writes the coordinates to a file of doubles.
 *
 *     fit_frames FILE FRAMES FEATURES temporal|spatial NEIGHBORS THREADS COORDS
 *
 * temporal: the nearest among as many frames to each side, including the frame itself. spatial: the
 * nearest among all other frames, as in other programs.
 */
#define _POSIX_C_SOURCE 199309L
#include <string.h>

#include "memory.h"
#include "motion.h"
#include "timing.h"

enum { dimension = 2, first_stage = STLTSA_STAGE_NEIGHBORS, last_stage = STLTSA_STAGE_SPECTRUM };

static const char* const stage_names[] = {"neighbors", "tangents", "alignment", "spectrum"};

static stltsa_in read_frames(const char* path, int64_t rows, int64_t cols) {
    const size_t count = (size_t)(rows * cols);
    double* x = allocate(count * sizeof *x);
    FILE* file = fopen(path, "rb");
    stltsa_in in;
    if (file == NULL || fread(x, sizeof *x, count, file) != count) {
        fprintf(stderr, "fit_frames: %s: cannot be read, or has fewer frames\n", path);
        exit(1);
    }
    fclose(file);
    memset(&in, 0, sizeof in);
    in.data = x;
    in.rows = rows;
    in.cols = cols;
    in.dtype = STLTSA_F64;
    return in;
}

static stltsa_options* options_of(char** arguments, struct stage_times* times) {
    const int temporal = strcmp(arguments[0], "temporal") == 0;
    stltsa_options* options = NULL;
    check(stltsa_options_new(&options));
    check(stltsa_options_set_int(options, STLTSA_OPT_MODE,
                                 temporal ? STLTSA_MODE_TEMPORAL : STLTSA_MODE_SPATIAL));
    check(stltsa_options_set_int(options, STLTSA_OPT_INCLUDE_SELF, temporal));
    check(stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, atol(arguments[1])));
    check(stltsa_options_set_int(options, STLTSA_OPT_WINDOW, atol(arguments[1])));
    check(stltsa_options_set_int(options, STLTSA_OPT_THREADS, atol(arguments[2])));
    check(stltsa_options_set_int(options, STLTSA_OPT_DIMENSION, dimension));
    check(stltsa_options_set_int(options, STLTSA_OPT_KEEP_FRAMES, 0));
    check(stltsa_options_set_progress(options, record_stage, times));
    return options;
}

static void write_coords(const stltsa_model* model, int64_t rows, const char* path) {
    const size_t count = (size_t)(rows * dimension);
    double* y = allocate(count * sizeof *y);
    FILE* file = fopen(path, "wb");
    stltsa_out out;
    memset(&out, 0, sizeof out);
    out.data = y;
    out.rows = rows;
    out.cols = dimension;
    out.dtype = STLTSA_F64;
    check(stltsa_info_array(stltsa_model_info(model), STLTSA_INFO_COORDS, 0, &out));
    if (file == NULL || fwrite(y, sizeof *y, count, file) != count || fclose(file) != 0) {
        fprintf(stderr, "fit_frames: %s cannot be written\n", path);
        exit(1);
    }
    free(y);
}

static void print_model(const stltsa_model* model) {
    const stltsa_info* info = stltsa_model_info(model);
    const int64_t components = stltsa_info_count(info, STLTSA_INFO_COMPONENT);
    int64_t solves = 0;
    double largest = 0;
    for (int64_t i = 0; i < components; ++i) {
        stltsa_component part;
        check(stltsa_info_rows(info, STLTSA_INFO_COMPONENT, i, 1, &part, sizeof part));
        solves += part.solves;
        largest = part.error_estimate_rad > largest ? part.error_estimate_rad : largest;
    }
    printf("\"solves\": %lld, \"components\": %lld, \"error_estimate\": %.3g", (long long)solves,
           (long long)components, largest);
}

/* Memory that the first fit of this process needs in addition to the memory in use before it. */
static long long fit_memory(const stltsa_in* in, const stltsa_options* options) {
    const long long before = peak_memory();
    stltsa_model* model = NULL;
    check(stltsa_fit(in, NULL, options, &model));
    stltsa_model_free(model);
    return peak_memory() - before;
}

int main(int argc, char** argv) {
    struct stage_times times = start_stages(CLOCK_MONOTONIC);
    stltsa_model* model = NULL;
    double seconds, processor;
    int stage;
    if (argc != 8) {
        fprintf(stderr, "usage: fit_frames FILE FRAMES FEATURES temporal|spatial NEIGHBORS THREADS "
                        "COORDS\n");
        return 2;
    }
    const stltsa_in in = read_frames(argv[1], atoll(argv[2]), atoll(argv[3]));
    stltsa_options* options = options_of(argv + 4, &times);
    const long long memory = fit_memory(&in, options);
    keep_memory(memory + memory / 4); /* reserve for fragmentation */
    processor = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    seconds = seconds_of(CLOCK_MONOTONIC);
    times = start_stages(CLOCK_MONOTONIC);
    check(stltsa_fit(&in, NULL, options, &model));
    seconds = seconds_of(CLOCK_MONOTONIC) - seconds;
    processor = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - processor;
    printf("{\"seconds\": %.6f, \"processor\": %.6f, \"memory\": %lld, \"stages\": {", seconds,
           processor, memory);
    for (stage = first_stage; stage <= last_stage; ++stage)
        printf("%s\"%s\": %.6f", stage == first_stage ? "" : ", ", stage_names[stage - first_stage],
               times.seconds[stage]);
    printf("}, ");
    print_model(model);
    printf("}\n");
    write_coords(model, in.rows, argv[7]);
    stltsa_model_free(model);
    stltsa_options_free(options);
    free((void*)in.data);
    return 0;
}
