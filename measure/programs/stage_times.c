/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Prints the wall-clock time of each stage of one decomposition.
 *
 *     stage_times CLIP [THREADS]
 */
#define _POSIX_C_SOURCE 199309L
#include "timing.h"

static const char* const stage_names[stages] = {"read",      "features", "neighbors", "tangents",
                                                "alignment", "spectrum", "units"};

int main(int argc, char** argv) {
    struct stage_times times;
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
    check(stltsa_options_set_int(options, STLTSA_OPT_THREADS, argc > 2 ? atoi(argv[2]) : 1));
    check(stltsa_options_set_progress(options, record_stage, &times));
    const double start = seconds_of(CLOCK_MONOTONIC);
    times = start_stages(CLOCK_MONOTONIC);
    check(stltsa_clip_open(argv[1], options, &clip));
    check(stltsa_decompose(clip, options, &units));
    total = seconds_of(CLOCK_MONOTONIC) - start;
    int64_t channels = 0;
    check(stltsa_info_int(stltsa_clip_info(clip), STLTSA_INFO_CHANNELS, 0, &channels));
    printf("%lld frames, %lld channels\n", (long long)stltsa_clip_frames(clip),
           (long long)channels);
    for (stage = 0; stage < stages; ++stage)
        printf("  %-10s %8.4f s  %5.1f %%\n", stage_names[stage], times.seconds[stage],
               100 * times.seconds[stage] / total);
    printf("  %-10s %8.4f s\n", "total", total);
    stltsa_decomposition_free(units);
    stltsa_clip_free(clip);
    stltsa_options_free(options);
    return 0;
}
