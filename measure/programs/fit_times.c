/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Measures each stage of stltsa_fit in microseconds of processor time per frame, and the wall-clock
 * time: one row of the table of measure/speed. The frames come from motion.h.
 *
 *     fit_times FRAMES NEIGHBORS THREADS REPEATS [MODE]
 *
 * MODE is the value of the option mode; default: 1 (temporal). Prints the shortest of the repeats.
 */
#define _POSIX_C_SOURCE 199309L
#include <string.h>

#include "motion.h"
#include "timing.h"

/* A fit of a matrix reads no file before the neighbors and finds no units after the spectrum. */
enum { first_stage = STLTSA_STAGE_NEIGHBORS, last_stage = STLTSA_STAGE_SPECTRUM };

int main(int argc, char** argv) {
    struct stage_times times, best;
    double shortest = 0, best_wall = 0;
    stltsa_options* options = NULL;
    stltsa_in in;
    long repeats, r;
    int stage;
    if (argc < 5) {
        fprintf(stderr, "usage: fit_times FRAMES NEIGHBORS THREADS REPEATS [MODE]\n");
        return 2;
    }
    memset(&in, 0, sizeof in);
    memset(&best, 0, sizeof best);
    in.rows = atol(argv[1]);
    in.cols = motion_features;
    in.dtype = STLTSA_F64;
    in.data = make_motion(in.rows);
    repeats = atol(argv[4]);
    check(stltsa_options_new(&options));
    check(stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, atol(argv[2])));
    check(stltsa_options_set_int(options, STLTSA_OPT_WINDOW, atol(argv[2])));
    check(stltsa_options_set_int(options, STLTSA_OPT_DIMENSION, 2));
    check(stltsa_options_set_int(options, STLTSA_OPT_THREADS, atol(argv[3])));
    if (argc > 5)
        check(stltsa_options_set_int(options, STLTSA_OPT_MODE, atol(argv[5])));
    check(stltsa_options_set_int(options, STLTSA_OPT_KEEP_FRAMES, 0));
    check(stltsa_options_set_progress(options, record_stage, &times));
    for (r = 0; r < repeats; ++r) {
        stltsa_model* model = NULL;
        double begin, wall, total;
        wall = seconds_of(CLOCK_MONOTONIC);
        begin = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
        times = start_stages(CLOCK_PROCESS_CPUTIME_ID);
        check(stltsa_fit(&in, NULL, options, &model));
        total = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - begin;
        wall = seconds_of(CLOCK_MONOTONIC) - wall;
        stltsa_model_free(model);
        if (r == 0 || total < shortest) {
            shortest = total;
            best = times;
        }
        if (r == 0 || wall < best_wall)
            best_wall = wall;
    }
    printf("%8lld %4s %7s", (long long)in.rows, argv[2], argv[3]);
    for (stage = first_stage; stage <= last_stage; ++stage)
        printf(" %9.2f", 1e6 * best.seconds[stage] / (double)in.rows);
    printf(" %9.2f %9.2f\n", 1e6 * shortest / (double)in.rows, 1e6 * best_wall / (double)in.rows);
    stltsa_options_free(options);
    free((void*)in.data);
    return 0;
}
