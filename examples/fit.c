/* SPDX-License-Identifier: BSD-3-Clause */
/* Fits your own numbers: a matrix with one row per frame instead of a clip file.
 *
 * The frames follow a circle, bent into six dimensions, three times; STLTSA recovers the two
 * coordinates of the circle. Also shows options, progress, cancelling and errors.
 *
 *     cc fit.c $(pkg-config --cflags --libs stltsa) -lm -o fit && ./fit
 */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

#include <stltsa.h>

enum { FRAMES = 300, FEATURES = 6, PERIOD = 100 };

static void make_frames(double frames[FRAMES][FEATURES]) {
    for (int t = 0; t < FRAMES; ++t) {
        const double angle = 2 * 3.14159265358979323846 * t / PERIOD;
        const double x = cos(angle), y = sin(angle);
        const double row[FEATURES] = {x, y, 0.3 * x * y, 0.2 * x * x, 0.5 * x + y, 0.1 * y * y};
        for (int c = 0; c < FEATURES; ++c)
            frames[t][c] = row[c];
    }
}

static volatile sig_atomic_t interrupted = 0;

static void on_interrupt(int signal_number) {
    (void)signal_number;
    interrupted = 1;
}

/* Called on this thread during the fit. A nonzero result cancels it with E_CANCELLED. */
static int32_t on_progress(void* user, int32_t stage, double fraction) {
    int* calls_left = user; /* negative: no limit */
    (void)stage;
    (void)fraction;
    if (*calls_left > 0)
        --*calls_left;
    return interrupted || *calls_left == 0;
}

static stltsa_status set_options(stltsa_options* options, int* calls_left) {
    stltsa_status status = stltsa_options_set_int(options, STLTSA_OPT_DIMENSION, 2);
    if (status == STLTSA_OK) /* 1.2 periods: with fewer, the first coordinate only follows time */
        status = stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, PERIOD * 6 / 5);
    if (status == STLTSA_OK)
        status = stltsa_options_set_progress(options, on_progress, calls_left);
    return status;
}

static stltsa_status print_coordinates(const stltsa_model* model) {
    static double coords[FRAMES][2];
    const stltsa_out out = {coords, FRAMES, 2, 0, 0, STLTSA_F64, 0}; /* strides 0: packed rows */
    const stltsa_info* info = stltsa_model_info(model);
    stltsa_component component;
    int64_t neighbors = 0;

    stltsa_status status = stltsa_info_array(info, STLTSA_INFO_COORDS, 0, &out);
    if (status == STLTSA_OK)
        status = stltsa_info_int(info, STLTSA_INFO_NEIGHBORS, 0, &neighbors);
    if (status == STLTSA_OK)
        status = stltsa_info_rows(info, STLTSA_INFO_COMPONENT, 0, 1, &component, sizeof component);
    if (status != STLTSA_OK)
        return status;

    printf("%d frames, %lld neighbors, residual %.1e\n", FRAMES, (long long)neighbors,
           component.residual);
    for (int t = 0; t < FRAMES; t += PERIOD / 4)
        printf("frame %3d  %8.5f  %8.5f\n", t, coords[t][0], coords[t][1]);
    for (int64_t i = 0; i < stltsa_info_count(info, STLTSA_INFO_WARNING); ++i) {
        stltsa_warning warning;
        if (stltsa_info_rows(info, STLTSA_INFO_WARNING, i, 1, &warning, sizeof warning) ==
            STLTSA_OK)
            printf("warning: %s\n", warning.text);
    }
    return STLTSA_OK;
}

int main(void) {
    static double frames[FRAMES][FEATURES];
    const stltsa_in in = {frames, FRAMES, FEATURES, 0, 0, STLTSA_F64, 0};
    stltsa_options* options = NULL;
    stltsa_model* model = NULL;
    int calls_left = -1;

    make_frames(frames);
    signal(SIGINT, on_interrupt); /* Ctrl-C cancels the fit; the library installs no handler */

    stltsa_status status = stltsa_options_new(&options);
    if (status == STLTSA_OK)
        status = set_options(options, &calls_left);
    if (status == STLTSA_OK)
        status = stltsa_fit(&in, NULL, options, &model); /* lengths NULL: one clip */
    if (status == STLTSA_OK)
        status = print_coordinates(model);
    if (status != STLTSA_OK)
        fprintf(stderr, "%s: %s\n", stltsa_status_name(status), stltsa_last_error());
    stltsa_model_free(model);

    /* The same fit, cancelled at the second report: no model, no leak. */
    calls_left = 2;
    if (status == STLTSA_OK && stltsa_fit(&in, NULL, options, &model) == STLTSA_E_CANCELLED &&
        model == NULL)
        printf("the second fit was cancelled, as asked\n");

    stltsa_options_free(options);
    return status == STLTSA_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
