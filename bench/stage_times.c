/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Where the time of one decomposition goes, as the progress callback sees it: the time between two
 * calls of the callback belongs to the stage that the second one names.
 *
 *     stage_times CLIP [THREADS]
 */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "stltsa.h"

static const char* const stage_names[] = {"read",      "features", "neighbors", "tangents",
                                          "alignment", "spectrum", "units"};
enum { stages = 7 };

struct times {
    double last;
    double seconds[stages];
};

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int32_t record(void* user, int32_t stage, double fraction) {
    struct times* times = user;
    const double time = now();
    (void)fraction;
    if (stage >= 0 && stage < stages)
        times->seconds[stage] += time - times->last;
    times->last = time;
    return 0;
}

static void check(stltsa_status status) {
    if (status != STLTSA_OK) {
        fprintf(stderr, "stage_times: %s\n", stltsa_last_error());
        exit(1);
    }
}

int main(int argc, char** argv) {
    struct times times = {0, {0}};
    stltsa_options* options = NULL;
    stltsa_clip* clip = NULL;
    stltsa_decomposition* units = NULL;
    double total;
    int stage;
    if (argc < 2) {
        fprintf(stderr, "usage: stage_times CLIP [THREADS]\n");
        return 2;
    }
    check(stltsa_options_new(&options));
    check(stltsa_options_set_int(options, STLTSA_THREADS, argc > 2 ? atoi(argv[2]) : 1));
    check(stltsa_options_set_progress(options, record, &times));
    const double start = times.last = now();
    check(stltsa_clip_open(argv[1], options, &clip));
    check(stltsa_decompose(clip, options, &units));
    total = now() - start;
    printf("%lld frames, %lld channels\n", (long long)stltsa_clip_frames(clip),
           (long long)stltsa_clip_channels(clip));
    for (stage = 0; stage < stages; ++stage)
        printf("  %-10s %8.4f s  %5.1f %%\n", stage_names[stage], times.seconds[stage],
               100 * times.seconds[stage] / total);
    printf("  %-10s %8.4f s\n", "total", total);
    stltsa_decomposition_free(units);
    stltsa_clip_free(clip);
    stltsa_options_free(options);
    return 0;
}
