/* SPDX-License-Identifier: BSD-3-Clause */
/* The modes with neighbors that are not temporal: spatial (classical LTSA) and recurrent. */
#include "support.h"

static stltsa_options* new_mode_options(int64_t k, int64_t d, int64_t mode) {
    stltsa_options* options = new_options(k, k, d);
    must(stltsa_options_set_int(options, STLTSA_OPT_MODE, mode));
    return options;
}

static stltsa_model* fit_mode(const double* x, int64_t rows, int64_t cols,
                              const stltsa_options* options) {
    stltsa_model* model = fitted_rows(x, rows, cols, options);
    return model;
}

/* Points on a rolled sheet in random order; `sheet` receives their place on it. */
static double* new_swiss_roll(int64_t rows, double* sheet) {
    double* x = new_matrix(rows, 3);
    uint64_t seed = 81;
    for (int64_t i = 0; i < rows; ++i) {
        const double t = 1.5 * pi * (1 + 2 * uniform(&seed));
        const double height = 21 * uniform(&seed);
        x[3 * i] = t * cos(t);
        x[3 * i + 1] = height;
        x[3 * i + 2] = t * sin(t);
        sheet[2 * i] = (t * sqrt(1 + t * t) + asinh(t)) / 2; /* length along the spiral */
        sheet[2 * i + 1] = height;
    }
    return x;
}

TEST(swiss_roll_is_unrolled) {
    enum { rows = 1500 };
    double* sheet = new_matrix(rows, 2);
    double* x = new_swiss_roll(rows, sheet);
    stltsa_options* options = new_mode_options(12, 2, STLTSA_MODE_SPATIAL);
    stltsa_model* model = fit_mode(x, rows, 3, options);
    assert_int_equal(count_of(model, STLTSA_INFO_COMPONENT), 1);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    assert_below(affine_misfit(coords, 2, sheet, rows, 2), 0.05, "misfit of the unrolled sheet");
}

/* Without time in the neighborhoods, the order of the frames does not matter. */
TEST(order_of_frames_only_permutes) {
    enum { rows = 600, cols = 3, d = 2 };
    double* sheet = new_matrix(rows, 2);
    double* x = new_swiss_roll(rows, sheet);
    double* shuffled = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i)
        memcpy(shuffled + (i * 7 + 5) % rows * cols, x + i * cols, cols * sizeof *x);
    stltsa_options* options = new_mode_options(14, d, STLTSA_MODE_SPATIAL);
    stltsa_model* a = fit_mode(x, rows, cols, options);
    stltsa_model* b = fit_mode(shuffled, rows, cols, options);
    double* want = array_of(a, STLTSA_INFO_COORDS);
    double* got = array_of(b, STLTSA_INFO_COORDS);
    for (int i = 0; i < rows; ++i)
        assert_below(largest_difference(want + i * d, got + (i * 7 + 5) % rows * d, d), 1e-9,
                     "change by order of frames");
}

TEST(number_of_threads_changes_no_bit) {
    enum { rows = 500, cols = 6, d = 2 };
    double* x = new_motion(rows, cols, 83);
    for (int64_t mode = STLTSA_MODE_SPATIAL; mode <= STLTSA_MODE_RECURRENT; ++mode) {
        stltsa_options* options = new_mode_options(12, d, mode);
        must(stltsa_options_set_int(options, STLTSA_OPT_THREADS, 1));
        stltsa_model* a = fit_mode(x, rows, cols, options);
        must(stltsa_options_set_int(options, STLTSA_OPT_THREADS, 2));
        stltsa_model* b = fit_mode(x, rows, cols, options);
        double* want = array_of(a, STLTSA_INFO_COORDS);
        double* got = array_of(b, STLTSA_INFO_COORDS);
        assert_same_bits(want, got, rows * d);
    }
}

/* Five turns of a circle with a slow drift: links connect the turns, so that they coincide. */
TEST(links_close_the_loop) {
    enum { rows = 500, period = 100, cols = 3, d = 2 };
    double* x = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i) {
        x[i * cols] = cos(2 * pi * i / period);
        x[i * cols + 1] = sin(2 * pi * i / period);
        x[i * cols + 2] = 1e-3 * i / period + 0.1 * sin(4 * pi * i / period);
    }
    stltsa_options* options = new_mode_options(12, d, STLTSA_MODE_RECURRENT);
    stltsa_model* model = fit_mode(x, rows, cols, options);
    assert_int_equal(count_of(model, STLTSA_INFO_COMPONENT), 1);
    assert_in_range(int_of(model, STLTSA_INFO_LINKS), 1, 12);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    double largest = 0;
    for (int i = 0; i < rows * d; ++i)
        largest = fmax(largest, fabs(coords[i]));
    for (int i = 0; i + period < rows; ++i)
        assert_below(largest_difference(coords + i * d, coords + (i + period) * d, d),
                     0.05 * largest, "distance from one turn to the next");
}

/* The same motion as two clips: two components in time, one with links. */
TEST(links_join_clips) {
    enum { rows = 400, half = 200, cols = 6, d = 2 };
    double* x = new_motion(rows, cols, 84);
    for (int i = 0; i < half * cols; ++i)
        x[half * cols + i] = x[i] + 1e-3 * sin(i);
    const stltsa_in in = packed_in(x, rows, cols);
    const int64_t lengths[] = {half, half};
    const stltsa_in clips = list_in(lengths, 2);
    for (int linked = 0; linked < 2; ++linked) {
        stltsa_options* options =
            new_mode_options(12, d, linked ? STLTSA_MODE_RECURRENT : STLTSA_MODE_TEMPORAL);
        stltsa_model* model = NULL;
        must(stltsa_fit(&in, &clips, options, &model));
        assert_int_equal(count_of(model, STLTSA_INFO_COMPONENT), linked ? 1 : 2);
        stltsa_model_free(model);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(swiss_roll_is_unrolled),
        cmocka_unit_test(order_of_frames_only_permutes),
        cmocka_unit_test(number_of_threads_changes_no_bit),
        cmocka_unit_test(links_close_the_loop),
        cmocka_unit_test(links_join_clips),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
