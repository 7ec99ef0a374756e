/* SPDX-License-Identifier: BSD-3-Clause */
/* Replays a clip as a stream: keeps the mean cycle of the clip in a model, pushes frame after
 * frame, and prints phase, rate and cycles as they pass. A second argument replays the clip that
 * many times and prints the time of one frame.
 *
 *     cc live.c $(pkg-config --cflags --libs stltsa) -o live
 *     ./live walk.bvh [REPEATS]
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <stltsa.h>

/* A model of the clip that keeps its mean cycle, and the middle of the second cycle as a mark. */
static stltsa_status learn(const stltsa_clip* clip, stltsa_model** model) {
    stltsa_decomposition* found = NULL;
    stltsa_phase* phase = NULL;
    stltsa_part cycle;
    stltsa_status status = stltsa_decompose(clip, NULL, &found);
    if (status == STLTSA_OK)
        status = stltsa_phase_find(found, NULL, &phase);
    if (status == STLTSA_OK)
        status = stltsa_fit_clips(&clip, 1, NULL, model);
    if (status == STLTSA_OK)
        status = stltsa_model_keep_cycle(*model, phase, NULL);
    if (status == STLTSA_OK) {
        const stltsa_info* info = stltsa_decomposition_info(found);
        const int64_t second = stltsa_info_count(info, STLTSA_INFO_CYCLE) > 1 ? 1 : 0;
        status = stltsa_info_rows(info, STLTSA_INFO_CYCLE, second, 1, &cycle, sizeof cycle);
    }
    if (status == STLTSA_OK)
        status =
            stltsa_model_keep_mark(*model, phase, (double)(cycle.begin + cycle.end) / 2, "middle");
    stltsa_phase_free(phase);
    stltsa_decomposition_free(found);
    return status;
}

/* Prints every tenth frame, and those at which a mark passes. */
static void show(const stltsa_live* live, int64_t frame, const stltsa_live_frame* now) {
    const stltsa_info* info = stltsa_live_info(live);
    const char* name = NULL;
    for (int64_t mark = 0; mark < stltsa_info_count(info, STLTSA_INFO_MARK); ++mark)
        if (now->passed >> mark & 1 &&
            stltsa_info_text(info, STLTSA_INFO_MARK, mark, &name) == STLTSA_OK)
            printf("frame %4lld: %s\n", (long long)frame, name);
    if (frame % 10 == 0)
        printf("frame %4lld: %-6s phase %.3f, %.2f Hz, %.1f cycles\n", (long long)frame,
               stltsa_segment_name(now->kind), now->phase, now->rate_hz, now->cycles);
}

/* A sensor would push its points or its pose: stltsa_live_push_points, stltsa_live_push_pose. */
static stltsa_status replay(const stltsa_model* model, const stltsa_clip* clip, long repeats) {
    const int64_t frames = stltsa_clip_frames(clip);
    const double fps = stltsa_clip_fps(clip);
    stltsa_live* live = NULL;
    stltsa_status status = stltsa_live_new(model, &live);
    const clock_t started = clock();
    for (long turn = 0; turn < (repeats > 0 ? repeats : 1); ++turn)
        for (int64_t i = 0; i < frames && status == STLTSA_OK; ++i) {
            stltsa_live_frame now = {.size = sizeof now};
            status = stltsa_live_push_frame(live, (double)i / fps, clip, i, &now);
            if (repeats == 0 && status == STLTSA_OK)
                show(live, i, &now);
        }
    if (repeats > 0 && status == STLTSA_OK)
        printf("%.1f microseconds a frame\n",
               1e6 * (double)(clock() - started) / CLOCKS_PER_SEC / (double)(repeats * frames));
    stltsa_live_free(live);
    return status;
}

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        fprintf(stderr, "usage: live CLIP [REPEATS]\n");
        return 2;
    }
    stltsa_clip* clip = NULL;
    stltsa_model* model = NULL;
    stltsa_status status = stltsa_clip_open(argv[1], NULL, &clip);
    if (status == STLTSA_OK)
        status = learn(clip, &model);
    if (status == STLTSA_OK)
        status = replay(model, clip, argc == 3 ? strtol(argv[2], NULL, 10) : 0);
    if (status != STLTSA_OK)
        fprintf(stderr, "error: %s\n", stltsa_last_error());
    stltsa_model_free(model);
    stltsa_clip_free(clip);
    return status == STLTSA_OK ? 0 : 1;
}
