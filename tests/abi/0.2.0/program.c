/* SPDX-License-Identifier: BSD-3-Clause */
/* A program written for 0.2.0. It is compiled with the header of that version in the same folder,
 * and linked and run with the current library. It requires every function that is new in 0.2.0 (the
 * program of 0.1.0 requires the others) and reads the structs of comparisons.
 *
 *     program CLIP
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stltsa.h"

#include "../check.h"

/* clang-format off */
static const function functions[] = {
    (function)stltsa_clip_save_with,
    (function)stltsa_compare,
    (function)stltsa_compare_left_right,
    (function)stltsa_compare_with,
    (function)stltsa_comparison_channel,
    (function)stltsa_comparison_channel_axis,
    (function)stltsa_comparison_channel_count,
    (function)stltsa_comparison_curves,
    (function)stltsa_comparison_cycles,
    (function)stltsa_comparison_difference,
    (function)stltsa_comparison_free,
    (function)stltsa_comparison_json,
    (function)stltsa_comparison_left_out,
    (function)stltsa_comparison_left_out_count,
    (function)stltsa_comparison_part,
    (function)stltsa_comparison_part_count,
    (function)stltsa_comparison_part_name,
    (function)stltsa_comparison_report_save,
    (function)stltsa_comparison_warning,
    (function)stltsa_comparison_warning_count,
    (function)stltsa_events_find_with,
    (function)stltsa_report_save,
};
/* clang-format on */

enum { SAMPLES = 101 };

static int write_calls = 0;

static int32_t count_writes(void* count, int32_t stage, double fraction) {
    CHECK(fraction >= 0 && fraction <= 1);
    *(int*)count += stage == STLTSA_STAGE_WRITE;
    return 0;
}

/* Of a motion compared with itself, nothing differs. */
static void read_comparison(const stltsa_comparison* same) {
    stltsa_compared_cycles cycles = {0};
    stltsa_compared_part part = {0};
    const int64_t channels = stltsa_comparison_channel_count(same);
    double* difference = calloc((size_t)channels * SAMPLES, sizeof *difference);
    const stltsa_out out = {difference, SAMPLES, channels, 0, 0, STLTSA_F64, 0};
    char* json = NULL;

    cycles.size = sizeof cycles;
    part.size = sizeof part;
    MUST(stltsa_comparison_cycles(same, &cycles));
    CHECK(cycles.samples == SAMPLES && cycles.sides == 0);
    CHECK(cycles.first_count > 2 && cycles.second_count == cycles.first_count);
    CHECK(cycles.cycle_time.first > 0 && cycles.cycle_time.first < 10);
    CHECK(fabs(cycles.first_per_minute * cycles.cycle_time.first - 60) < 1e-9);
    CHECK(fabs(cycles.shift) < 1e-12 && cycles.likeness > 0.999999 && cycles.significant == 0);
    CHECK(stltsa_comparison_part_count(same) > 2);
    CHECK(channels >= stltsa_comparison_part_count(same));
    for (int64_t p = 0; p < stltsa_comparison_part_count(same); ++p) {
        MUST(stltsa_comparison_part(same, p, &part));
        CHECK(part.part == p && part.rms < 1e-12 && fabs(part.amplitude.difference) < 1e-12);
        CHECK(!(fabs(part.ratio - 1) > 1e-9) && !(part.ratio_low > part.ratio_high));
        CHECK(strcmp(stltsa_comparison_part_name(same, 0, p),
                     stltsa_comparison_part_name(same, 1, p)) == 0);
    }
    MUST(stltsa_comparison_difference(same, &out, NULL, NULL));
    for (int64_t i = 0; i < channels * SAMPLES; ++i)
        CHECK(fabs(difference[i]) < 1e-12);
    MUST(stltsa_comparison_curves(same, 0, &out, NULL));
    for (int64_t i = 0; i < channels * SAMPLES; ++i)
        CHECK(isfinite(difference[i]));
    MUST(stltsa_comparison_channel(same, 1, &part));
    CHECK(part.part == 0 && strcmp(stltsa_comparison_channel_axis(same, 1), "y") == 0);
    CHECK(stltsa_comparison_left_out_count(same, 0) == 0);
    CHECK(strcmp(stltsa_comparison_left_out(same, 1, 0), "") == 0);
    for (int64_t i = 0; i < stltsa_comparison_warning_count(same); ++i)
        CHECK(strlen(stltsa_comparison_warning(same, i)) > 0);
    MUST(stltsa_comparison_json(same, &json));
    MUST(stltsa_comparison_report_save(same, NULL, "built-for-0.2.0.html"));
    CHECK(remove("built-for-0.2.0.html") == 0);
    CHECK(strstr(json, "\"format\":\"stltsa-comparison/1\"") != NULL);

    stltsa_free(json);
    free(difference);
}

static void compare(const char* path) {
    stltsa_options* options = NULL;
    stltsa_clip* clip = NULL;
    stltsa_decomposition* decomposition = NULL;
    stltsa_phase* phase = NULL;
    stltsa_comparison* comparison = NULL;
    stltsa_events* events = NULL;
    stltsa_compared_cycles cycles = {0};
    double mark = 0;

    MUST(stltsa_options_new(&options));
    MUST(stltsa_options_set_progress(options, count_writes, &write_calls));
    MUST(stltsa_clip_open(path, options, &clip));
    MUST(stltsa_decompose(clip, options, &decomposition));
    MUST(stltsa_phase_find(decomposition, options, &phase));
    MUST(stltsa_compare_with(phase, -1, phase, -1, SAMPLES, options, &comparison));
    read_comparison(comparison);
    stltsa_comparison_free(comparison);
    MUST(stltsa_compare_left_right(clip, phase, -1, SAMPLES, options, &comparison));
    cycles.size = sizeof cycles;
    MUST(stltsa_comparison_cycles(comparison, &cycles));
    CHECK(cycles.sides == 1 && cycles.shift == 0.5);
    stltsa_comparison_free(comparison);
    CHECK(stltsa_compare(phase, -1, phase, -1, 4, &comparison) == STLTSA_E_ARGUMENT);
    CHECK(comparison == NULL);

    mark = (double)stltsa_clip_frames(clip) / 2;
    const stltsa_in marks = {&mark, 1, 1, 0, 0, STLTSA_F64, 0};
    MUST(stltsa_events_find_with(phase, &marks, NULL, options, &events));
    CHECK(stltsa_events_count(events) > 2);

    MUST(stltsa_clip_save_with(clip, "built-for-0.2.0.bvh", options));
    CHECK(remove("built-for-0.2.0.bvh") == 0);
    CHECK(write_calls > 0);
    MUST(stltsa_report_save(clip, decomposition, options, NULL, "built-for-0.2.0.html"));
    CHECK(remove("built-for-0.2.0.html") == 0);
    CHECK(stltsa_report_save(clip, decomposition, options, NULL, "") != STLTSA_OK);

    stltsa_events_free(events);
    stltsa_phase_free(phase);
    stltsa_decomposition_free(decomposition);
    stltsa_clip_free(clip);
    stltsa_options_free(options);
}

int main(int argc, char** argv) {
    if (argc != 2) {
        fprintf(stderr, "usage: %s CLIP\n", argv[0]);
        return 2;
    }
    for (size_t i = 0; i < sizeof functions / sizeof *functions; ++i)
        CHECK(functions[i] != NULL);
    CHECK(stltsa_version_number() >= STLTSA_VERSION_NUMBER);
    compare(argv[1]);
    printf("built for 0.2.0, run with %s: %d failures\n", stltsa_version(), failures);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
