/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * The longest time between two calls of the progress callback, the longest delay of cancelling.
 * Prints one line for each function: name, its seconds, the longest time between two calls in
 * seconds, and the stage and fraction of the later call (-1: the function's return).
 *
 *     poll_times FRAMES COLUMNS FPS [FILE.csv [all] | gaps]
 *
 * With FILE.csv, which is written, read and removed, also functions that would need more memory for
 * a million columns than most machines have; with "all", also those that take longest.
 * With "gaps", columns are coordinates of points, and each point is missing for a fifth of the
 * time.
 */
#define _POSIX_C_SOURCE 200809L
#include "motion.h"
#include "timing.h"

#include <string.h>

struct gap {
    double last, longest, fraction;
    int32_t stage;
};

static void note(struct gap* gap, int32_t stage, double fraction) {
    const double now = seconds_of(CLOCK_MONOTONIC);
    if (now - gap->last > gap->longest) {
        gap->longest = now - gap->last;
        gap->stage = stage;
        gap->fraction = fraction;
    }
    gap->last = now;
}

static int32_t called(void* user, int32_t stage, double fraction) {
    note(user, stage, fraction);
    return 0;
}

static struct gap gap;

static double start(void) {
    gap.longest = 0;
    return gap.last = seconds_of(CLOCK_MONOTONIC);
}

static void finish(const char* name, double begin, stltsa_status status) {
    note(&gap, -1, 1);
    if (status != STLTSA_OK)
        fprintf(stderr, "%s: %s\n", name, stltsa_last_error());
    printf("%-26s %7.2f %6.3f %2d %.2f\n", name, gap.last - begin, gap.longest, (int)gap.stage,
           gap.fraction);
    fflush(stdout);
}

/* How fast columns swing at a time of a clip of more than half an hour, see swinging(). */
static double pace(double at, double seconds) {
    if (2 * at > seconds)
        return fmod(at, 4) < 2;
    const int span = (int)(at / 8) % 4;
    return span == 3 ? 0 : 1 + 0.5 * (span % 2);
}

/* Columns that swing every two seconds or, in clips of up to eight seconds, four times; each has
 * its own phase and a little noise. In the first half of clips of more than half an hour, every
 * fourth span of eight seconds is a rest, and every second of the others swings one and a half
 * times as fast; in the second half, a rest follows each swing. */
static double* swinging(int64_t frames, int64_t columns, double fps) {
    const double seconds = (double)frames / fps;
    const double cycle = seconds > 8 ? 2 * fps : (double)frames / 4;
    double phase = 0;
    double* x = allocate((size_t)frames * (size_t)columns * sizeof *x);
    uint64_t state = 1;
    for (int64_t i = 0; i < frames; ++i) {
        phase += 6.283185307179586 / cycle * (seconds > 1800 ? pace((double)i / fps, seconds) : 1);
        const double c = cos(phase), s = sin(phase), c2 = cos(2 * phase);
        for (int64_t j = 0; j < columns; ++j)
            x[i * columns + j] = c * (double)(j % 7 + 1) + s * (double)(j % 5 + 1) +
                                 c2 * (double)(j % 3) + 0.01 * next_random(&state);
    }
    return x;
}

static void write_and_read(const stltsa_clip* clip, const char* path,
                           const stltsa_options* options) {
    stltsa_clip* again = NULL;
    double begin = start();
    finish("stltsa_clip_save", begin, stltsa_clip_save(clip, path, options));
    begin = start();
    finish("stltsa_clip_open", begin, stltsa_clip_open(path, options, &again));
    stltsa_clip_free(again);
    remove(path);
}

static void compare_and_find_events(const stltsa_phase* phase, const stltsa_phase* again,
                                    double mark, const stltsa_options* options) {
    stltsa_comparison* comparison = NULL;
    stltsa_events* events = NULL;
    const stltsa_in marks = {&mark, 1, 1, 0, 0, STLTSA_F64, 0};
    double begin = start();
    finish("stltsa_compare", begin, stltsa_compare(phase, 0, phase, 0, 101, options, &comparison));
    begin = start();
    finish("stltsa_events_find", begin, stltsa_events_find(phase, &marks, NULL, options, &events));
    stltsa_events_free(events);
    events = NULL;
    begin = start();
    finish("stltsa_events_find,other", begin,
           stltsa_events_find(phase, &marks, again, options, &events));
    stltsa_events_free(events);
    stltsa_comparison_free(comparison);
}

static void map_and_clean(const stltsa_model* model, const stltsa_in* in, stltsa_options* options) {
    int64_t dimension = 0;
    check(stltsa_info_int(stltsa_model_info(model), STLTSA_INFO_DIMENSION, 0, &dimension));
    double* at = allocate((size_t)(in->rows * dimension) * sizeof *at);
    double* back = allocate((size_t)(in->rows * in->cols) * sizeof *back);
    const stltsa_out coords = {at, in->rows, dimension, 0, 0, STLTSA_F64, 0};
    const stltsa_in points = {at, in->rows, dimension, 0, 0, STLTSA_F64, 0};
    const stltsa_out frames = {back, in->rows, in->cols, 0, 0, STLTSA_F64, 0};
    stltsa_denoising* denoising = NULL;
    stltsa_model* intrinsic = NULL;
    double begin = start();
    finish("stltsa_map", begin, stltsa_map(model, in, NULL, options, &coords, NULL, NULL));
    begin = start();
    finish("stltsa_unmap", begin, stltsa_unmap(model, &points, NULL, options, &frames, NULL, NULL));
    begin = start();
    finish("stltsa_denoise", begin, stltsa_denoise(in, NULL, options, &denoising));
    begin = start();
    check(stltsa_options_set_int(options, STLTSA_OPT_INTRINSIC, 1));
    finish("stltsa_fit,intrinsic", begin, stltsa_fit(in, NULL, options, &intrinsic));
    check(stltsa_options_unset(options, STLTSA_OPT_INTRINSIC));
    stltsa_model_free(intrinsic);
    stltsa_denoising_free(denoising);
    free(back);
    free(at);
}

/* Pairs of points, left and right of a body that swings them in turn. */
static stltsa_clip* two_sides(int64_t frames, int64_t pairs, double fps) {
    const double cycle = (double)frames / 4;
    const size_t count = 2 * (size_t)pairs;
    double* x = allocate((size_t)frames * 3 * count * sizeof *x);
    char(*texts)[32] = allocate(count * sizeof *texts);
    const char** names = allocate(count * sizeof *names);
    for (size_t p = 0; p < count; ++p) {
        snprintf(texts[p], sizeof *texts, "%s%zu", p % 2 == 0 ? "Left" : "Right", p / 2);
        names[p] = texts[p];
    }
    for (int64_t i = 0; i < frames; ++i)
        for (size_t p = 0; p < count; ++p) {
            double* at = x + 3 * ((size_t)i * count + p);
            const double side = p % 2 == 0 ? 1 : -1, place = (double)(p / 2) / (double)pairs;
            const double turn = 6.283185307179586 * (double)i / cycle;
            at[0] = side * (10 + place);
            at[1] = side * (20 + 10 * place) * sin(turn + place);
            at[2] = 100 + 50 * place + 5 * cos(turn + (side < 0 ? 3.141592653589793 : 0));
        }
    stltsa_clip* clip = NULL;
    const stltsa_points points = {.size = sizeof points,
                                  .space = 3,
                                  .positions = {x, frames, 3 * (int64_t)count, 0, 0, STLTSA_F64, 0},
                                  .names = names,
                                  .fps = fps};
    check(stltsa_clip_from_points(&points, NULL, &clip));
    free(names);
    free(texts);
    free(x);
    return clip;
}

static void compare_sides(int64_t frames, int64_t pairs, double fps,
                          const stltsa_options* options) {
    stltsa_clip* clip = two_sides(frames, pairs, fps);
    stltsa_decomposition* made = NULL;
    stltsa_phase* phase = NULL;
    stltsa_comparison* comparison = NULL;
    check(stltsa_decompose(clip, NULL, &made));
    check(stltsa_phase_find(made, NULL, &phase));
    const double begin = start();
    finish("stltsa_compare_left_right", begin,
           stltsa_compare_left_right(clip, phase, -1, 101, options, &comparison));
    stltsa_comparison_free(comparison);
    stltsa_phase_free(phase);
    stltsa_decomposition_free(made);
    stltsa_clip_free(clip);
}

static void fit_mode(const stltsa_clip* clip, const char* name, int32_t mode,
                     stltsa_options* options) {
    stltsa_model* model = NULL;
    check(stltsa_options_set_int(options, STLTSA_OPT_MODE, mode));
    const double begin = start();
    finish(name, begin, stltsa_fit_clips(&clip, 1, options, &model));
    stltsa_model_free(model);
}

static void report(const stltsa_clip* clip, const stltsa_decomposition* made, const char* path,
                   const stltsa_options* options) {
    const double begin = start();
    finish("stltsa_report_save", begin, stltsa_report_save(clip, made, options, NULL, path));
    remove(path);
}

/* Points of three columns, of which each is missing for a fifth of the time. */
static stltsa_clip* points_with_gaps(double* x, int64_t frames, int64_t columns, double fps) {
    const int64_t length = frames / 5;
    for (int64_t c = 0; c < columns; ++c)
        for (int64_t i = 0, begin = c / 3 * 7919 % (frames - length); i < length; ++i)
            x[(begin + i) * columns + c] = NAN;
    stltsa_points points = {.size = sizeof points, .space = 3, .fps = fps};
    const stltsa_in in = {x, frames, columns, 0, 0, STLTSA_F64, 0};
    points.positions = in;
    stltsa_clip* clip = NULL;
    check(stltsa_clip_from_points(&points, NULL, &clip));
    return clip;
}

int main(int argc, char** argv) {
    stltsa_clip* clip = NULL;
    stltsa_options* options = NULL;
    stltsa_decomposition* made = NULL;
    stltsa_phase* phase = NULL;
    stltsa_model* model = NULL;
    if (argc < 4 || argc > 6) {
        fprintf(stderr, "usage: poll_times FRAMES COLUMNS FPS [FILE.csv [all] | gaps]\n");
        return 2;
    }
    const int64_t frames = atoll(argv[1]), columns = atoll(argv[2]);
    double* x = swinging(frames, columns, atof(argv[3]));
    const stltsa_in in = {x, frames, columns, 0, 0, STLTSA_F64, 0};
    const int gaps = argc > 4 && strcmp(argv[4], "gaps") == 0;
    if (gaps)
        clip = points_with_gaps(x, frames, columns, atof(argv[3]));
    else
        check(stltsa_clip_from_matrix(&in, atof(argv[3]), &clip));
    check(stltsa_options_new(&options));
    check(stltsa_options_set_progress(options, called, &gap));

    double begin = start();
    const stltsa_status decomposed = stltsa_decompose(clip, options, &made);
    finish("stltsa_decompose", begin, decomposed);
    if (decomposed == STLTSA_OK) {
        begin = start();
        finish("stltsa_phase_find", begin, stltsa_phase_find(made, options, &phase));
    }
    begin = start();
    const stltsa_clip* const clips[] = {clip};
    finish("stltsa_fit_clips", begin, stltsa_fit_clips(clips, 1, options, &model));
    if (argc > 4 && !gaps) {
        stltsa_phase* again = NULL;
        check(stltsa_phase_find(made, NULL, &again));
        compare_and_find_events(phase, again, (double)frames / 2, options);
        stltsa_phase_free(again);
        write_and_read(clip, argv[4], options);
        if (columns >= 36)
            compare_sides(frames > 1000 ? 1000 : frames, columns / 18, atof(argv[3]), options);
    }
    if (argc > 5) {
        report(clip, made, argv[4], options);
        map_and_clean(model, &in, options);
        fit_mode(clip, "stltsa_fit_clips,spatial", STLTSA_MODE_SPATIAL, options);
        fit_mode(clip, "stltsa_fit_clips,recurrent", STLTSA_MODE_RECURRENT, options);
    }
    free(x);

    stltsa_model_free(model);
    stltsa_phase_free(phase);
    stltsa_decomposition_free(made);
    stltsa_options_free(options);
    stltsa_clip_free(clip);
    return 0;
}
