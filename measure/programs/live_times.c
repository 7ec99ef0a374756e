/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Measures a pushed frame of a stream in microseconds of processor time: a clip is played to a
 * model of itself, each time from its first frame to its last. Part of measure/live.
 *
 *     live_times CLIP FPS
 *
 * Of the fastest of ten passes, prints the mean of its frames and the longest, "..., mean 12.3",
 * for the frames of the clip, and for points of which every tenth is lost if the clip has points.
 */
#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <string.h>

#include "timing.h"

enum { passes = 10 };

static stltsa_model* taught_by(const stltsa_clip* clip) {
    stltsa_model* model = NULL;
    stltsa_decomposition* found = NULL;
    stltsa_phase* phase = NULL;
    check(stltsa_fit_clips(&clip, 1, NULL, &model));
    check(stltsa_decompose(clip, NULL, &found));
    check(stltsa_phase_find(found, NULL, &phase));
    check(stltsa_model_keep_cycle(model, phase, NULL));
    stltsa_phase_free(phase);
    stltsa_decomposition_free(found);
    return model;
}

/* Pushes frame i; `points`: NULL, or coordinates. */
static void push(stltsa_live* live, const stltsa_clip* clip, const double* points, int64_t columns,
                 int64_t i) {
    stltsa_live_frame now;
    const double seconds = (double)i / stltsa_clip_fps(clip);
    now.size = sizeof now;
    if (points == NULL) {
        check(stltsa_live_push_frame(live, seconds, clip, i, &now));
    } else {
        const stltsa_in in = {points + i * columns, columns / 3, 3, 0, 0, STLTSA_F64, 0};
        check(stltsa_live_push_points(live, seconds, &in, NULL, &now));
    }
}

static void measured(const char* name, const stltsa_model* model, const stltsa_clip* clip,
                     const double* points, int64_t columns) {
    const int64_t frames = stltsa_clip_frames(clip);
    double shortest = 0, longest = 0;
    int pass;
    for (pass = 0; pass < passes; ++pass) {
        stltsa_live* live = NULL;
        double most = 0, sum = 0;
        int64_t i;
        check(stltsa_live_new(model, &live));
        for (i = 0; i < frames; ++i) {
            const double begin = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
            double took;
            push(live, clip, points, columns, i);
            took = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - begin;
            sum += took;
            most = took > most ? took : most;
        }
        stltsa_live_free(live);
        if (pass == 0 || sum < shortest) {
            shortest = sum;
            longest = most;
        }
    }
    printf("%s, mean %.1f\n", name, 1e6 * shortest / (double)frames);
    printf("%s, longest %.1f\n", name, 1e6 * longest);
}

int main(int argc, char** argv) {
    stltsa_options* options = NULL;
    stltsa_clip* clip = NULL;
    stltsa_model* model;
    if (argc != 3) {
        fprintf(stderr, "usage: live_times CLIP FPS\n");
        return 2;
    }
    check(stltsa_options_new(&options));
    check(stltsa_options_set_real(options, STLTSA_OPT_FPS, atof(argv[2])));
    check(stltsa_clip_open(argv[1], options, &clip));
    model = taught_by(clip);
    measured("frames of the clip", model, clip, NULL, 0);
    if (stltsa_info_count(stltsa_clip_info(clip), STLTSA_INFO_JOINT) == 0) {
        const int64_t frames = stltsa_clip_frames(clip);
        int64_t columns = 0;
        check(stltsa_info_int(stltsa_clip_info(clip), STLTSA_INFO_CHANNELS, 0, &columns));
        double* points = malloc((size_t)(frames * columns) * sizeof *points);
        const stltsa_out out = {points, frames, columns, 0, 0, STLTSA_F64, 0};
        int64_t i;
        check(stltsa_options_set_int(options, STLTSA_OPT_FEATURES, STLTSA_FEATURES_RAW));
        check(stltsa_clip_features(clip, options, &out));
        for (i = 0; i < frames * columns; i += 30)
            points[i] = NAN;
        measured("a tenth of the points lost", model, clip, points, columns);
        free(points);
    }
    stltsa_options_free(options);
    stltsa_model_free(model);
    stltsa_clip_free(clip);
    return 0;
}
