/* SPDX-License-Identifier: BSD-3-Clause */
/* Features of real recordings that break a careless LTSA: held frames, cuts, stretches with fewer
 * directions than coordinates. */
#include "support.h"

enum { rows = 200, cols = 8, d = 2, k = 12, w = 12 };

struct fit {
    stltsa_model* model;
    double* coords;
    int64_t rows;
};

static struct fit fit_rows(const double* x, int64_t count) {
    struct fit f = {NULL, NULL, count};
    stltsa_options* options = new_options(k, w, d);
    f.model = fitted_rows(x, count, cols, options);
    f.coords = array_of(f.model, STLTSA_INFO_COORDS);
    return f;
}

/* Frame i of x, times[i] times. */
static double* new_held(const double* x, const int64_t* times, int64_t* total) {
    *total = 0;
    for (int i = 0; i < rows; ++i)
        *total += times[i];
    double* held = new_matrix(*total, cols);
    int64_t at = 0;
    for (int i = 0; i < rows; ++i)
        for (int64_t t = 0; t < times[i]; ++t)
            memcpy(held + cols * at++, x + i * cols, cols * sizeof *x);
    return held;
}

static void assert_holds_collapse(const int64_t* times) {
    double* x = new_motion(rows, cols, 61);
    int64_t total = 0;
    double* held = new_held(x, times, &total);
    const struct fit want = fit_rows(x, rows);
    const struct fit got = fit_rows(held, total);
    assert_int_equal(int_of(got.model, STLTSA_INFO_ROWS), total);
    assert_int_equal(int_of(got.model, STLTSA_INFO_REPEATED), total - rows);
    assert_int_equal(count_of(got.model, STLTSA_INFO_COMPONENT), 1);
    int64_t at = 0;
    for (int i = 0; i < rows; ++i)
        for (int64_t t = 0; t < times[i]; ++t)
            assert_same_bits(want.coords + i * d, got.coords + d * at++, d);
}

TEST(frames_held_three_times_collapse) {
    int64_t times[rows];
    for (int i = 0; i < rows; ++i)
        times[i] = 3;
    assert_holds_collapse(times);
}

/* Longer than any window: at the start, inside, at the end. */
TEST(holds_longer_than_the_window_collapse) {
    int64_t times[rows];
    for (int i = 0; i < rows; ++i)
        times[i] = i == 0 || i == 90 || i == rows - 1 ? 3 * w : 1;
    assert_holds_collapse(times);
}

/* The same pose twice, but not in succession, is two frames. */
TEST(a_pose_that_comes_back_is_not_a_repeat) {
    double* x = new_motion(rows, cols, 62);
    memcpy(x + 103 * cols, x + 100 * cols, cols * sizeof *x);
    const struct fit f = fit_rows(x, rows);
    assert_int_equal(int_of(f.model, STLTSA_INFO_REPEATED), 0);
    assert_int_equal(count_of(f.model, STLTSA_INFO_COMPONENT), 1);
    for (int i = 0; i < rows * d; ++i)
        assert_true(isfinite(f.coords[i]));
}

/* A jump that no neighborhood spans: each side is embedded separately. */
TEST(a_hard_cut_gives_two_components) {
    enum { cut = 80 };
    double* x = new_motion(rows, cols, 63);
    for (int i = cut; i < rows; ++i)
        x[i * cols] += 1000;
    const struct fit f = fit_rows(x, rows);
    assert_int_equal(count_of(f.model, STLTSA_INFO_COMPONENT), 2);
    assert_true(count_of(f.model, STLTSA_INFO_WARNING) >= 1);
    int64_t* labels = whole_of(f.model, STLTSA_INFO_COMPONENT_OF);
    for (int i = 0; i < rows; ++i)
        assert_int_equal(labels[i], i >= cut);
    const struct fit before = fit_rows(x, cut);
    const struct fit after = fit_rows(x + cut * cols, rows - cut);
    assert_below(largest_difference(f.coords, before.coords, cut * d), 1e-10, "before the cut");
    assert_below(largest_difference(f.coords + cut * d, after.coords, (rows - cut) * d), 1e-10,
                 "after the cut");

    double *values = array_of(f.model, STLTSA_INFO_EIGENVALUES),
           *alone = array_of(before.model, STLTSA_INFO_EIGENVALUES);
    for (int v = 1; v < d + 2; ++v)
        assert_below(fabs(values[v] / alone[v] - 1), 1e-9, "eigenvalue of the first component");
}

/* 60 frames on a straight line among frames that are not: their windows have one direction. */
TEST(windows_on_a_line_are_counted) {
    enum { begin = 70, end = 130 };
    double* x = new_motion(rows, cols, 64);
    for (int i = 0; i < rows; ++i)
        for (int c = 0; c < cols; ++c)
            x[i * cols + c] = round(x[i * cols + c] * 4096);
    for (int i = begin; i < end; ++i)
        for (int c = 0; c < cols; ++c)
            x[i * cols + c] = x[begin * cols + c] + 64.0 * (i - begin) * (c + 1);
    for (int c = 0; c < cols; ++c) { /* no jump at the end of the line */
        const double step = x[(end - 1) * cols + c] - x[end * cols + c] + 64.0 * (c + 1);
        for (int i = end; i < rows; ++i)
            x[i * cols + c] += step;
    }
    const struct fit f = fit_rows(x, rows);
    const int64_t deficient = component_at(f.model, 0).rank_deficient_windows;
    assert_in_range(deficient, end - begin - 2 * w, end - begin);
    assert_true(count_of(f.model, STLTSA_INFO_WARNING) >= 1);
    for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) {
            double product = 0;
            for (int i = 0; i < rows; ++i)
                product += f.coords[i * d + a] * f.coords[i * d + b];
            assert_below(fabs(product - (a == b)), 1e-12, "inner product of coordinates");
        }
}

static void assert_refused(const double* x, int64_t count, stltsa_status status) {
    stltsa_options* options = new_options(k, w, d);
    const stltsa_in in = packed_in(x, count, cols);
    stltsa_model* model = (stltsa_model*)&in;
    assert_int_equal(stltsa_fit(&in, NULL, options, &model), status);
    assert_null(model);
    assert_true(strlen(stltsa_last_error()) > 20);
}

TEST(a_line_has_no_second_coordinate) {
    double* x = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i)
        for (int c = 0; c < cols; ++c)
            x[i * cols + c] = i * (c + 1);
    assert_refused(x, rows, STLTSA_E_DEGENERATE);
}

TEST(a_statue_varies_in_no_direction) {
    double* x = new_matrix(rows, cols);
    assert_refused(x, rows, STLTSA_E_DEGENERATE);
    assert_refused(x, 1, STLTSA_E_TOO_FEW_FRAMES);
}

/* Directions next to one that is ten thousand times as large have fewer correct digits. */
TEST(features_of_uneven_size_are_to_be_scaled) {
    double* x = new_motion(rows, cols, 66);
    const struct fit even = fit_rows(x, rows);
    assert_int_equal(warnings_of(even.model, "scale them"), 0);
    assert_below(component_at(even.model, 0).error_estimate_rad, 1e-9, "estimate");
    for (int i = 0; i < rows; ++i)
        x[i * cols] *= 1e4;
    const struct fit uneven = fit_rows(x, rows);
    assert_int_equal(warnings_of(uneven.model, "scale them"), 1);
    assert_true(component_at(uneven.model, 0).error_estimate_rad > 1e-9);
}

/* k + 1 distinct frames are enough, k are not, with or without held frames. */
TEST(as_many_distinct_frames_as_it_takes) {
    double* x = new_motion(rows, cols, 65);
    const struct fit f = fit_rows(x, k + 1);
    for (int i = 0; i < (k + 1) * d; ++i)
        assert_true(isfinite(f.coords[i]));
    assert_refused(x, k, STLTSA_E_TOO_FEW_FRAMES);
    for (int i = k; i < rows; ++i)
        memcpy(x + i * cols, x + (k - 1) * cols, cols * sizeof *x);
    assert_refused(x, rows, STLTSA_E_TOO_FEW_FRAMES);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_held_three_times_collapse),
        cmocka_unit_test(holds_longer_than_the_window_collapse),
        cmocka_unit_test(a_pose_that_comes_back_is_not_a_repeat),
        cmocka_unit_test(a_hard_cut_gives_two_components),
        cmocka_unit_test(windows_on_a_line_are_counted),
        cmocka_unit_test(a_line_has_no_second_coordinate),
        cmocka_unit_test(a_statue_varies_in_no_direction),
        cmocka_unit_test(features_of_uneven_size_are_to_be_scaled),
        cmocka_unit_test(as_many_distinct_frames_as_it_takes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
