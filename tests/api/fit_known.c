/* SPDX-License-Identifier: BSD-3-Clause */
/* Embeddings with a known result: a flat sheet, a circle, a curved sheet. */
#include "support.h"

enum { frames = 400, channels = 20 };

/* A path over a plane: forward, while it swings to both sides. */
static double* new_path(void) {
    double* path = new_matrix(frames, 2);
    uint64_t seed = 3;
    for (int64_t i = 0; i < frames; ++i) {
        path[2 * i] = 0.05 * (double)i + 0.2 * uniform(&seed);
        path[2 * i + 1] = sin(0.3 * (double)i) + 0.2 * uniform(&seed);
    }
    return path;
}

/* A plane in 20 dimensions is its own tangent everywhere, so LTSA returns the path on it up to an
 * affine map, exact to rounding. */
TEST(flat_sheet_is_recovered) {
    double* path = new_path();
    double* plane = new_directions(2, channels, 5);
    double* x = new_product(path, plane, frames, 2, channels);
    double* coords = fit_coords(x, frames, channels, 2);
    assert_below(affine_misfit(coords, 2, path, frames, 2), 1e-9, "misfit of the flat sheet");
}

static double* new_circle(double turns) {
    double* circle = new_matrix(frames, 2);
    for (int64_t i = 0; i < frames; ++i) {
        const double angle = 2 * pi * turns * (double)i / frames;
        circle[2 * i] = cos(angle);
        circle[2 * i + 1] = sin(angle);
    }
    return circle;
}

/* A circle lies in a plane: two coordinates give the circle itself, over several turns. */
TEST(circle_in_two_dimensions_is_itself) {
    double* circle = new_circle(10);
    double* plane = new_directions(2, channels, 6);
    double* x = new_product(circle, plane, frames, 2, channels);
    double* coords = fit_coords(x, frames, channels, 2);
    assert_below(affine_misfit(coords, 2, circle, frames, 2), 1e-9, "misfit of the circle");
}

/* One coordinate measures length along the circle, and a warning says that it only follows time. */
TEST(circle_in_one_dimension_is_arc_length) {
    double* circle = new_circle(1);
    double* length = new_matrix(frames, 1);
    for (int64_t i = 0; i < frames; ++i)
        length[i] = (double)i;
    stltsa_options* options = new_options(12, 12, 1);
    stltsa_model* model = fitted_rows(circle, frames, 2, options);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    assert_below(affine_misfit(coords, 1, length, frames, 1), 1e-3, "misfit of the length");
    assert_below(1 - real_of(model, STLTSA_INFO_TIME_CORRELATION), 1e-12, "1 - correlation");
    assert_true(count_of(model, STLTSA_INFO_WARNING) >= 1);
}

/* A sheet rolled up as a cylinder, again with a path in time order: two coordinates unroll it,
 * although every window has a different plane. */
TEST(rolled_sheet_is_unrolled) {
    const double radius = 6;
    double* path = new_path();
    double* x = new_matrix(frames, 3);
    for (int64_t i = 0; i < frames; ++i) {
        x[3 * i] = radius * cos(path[2 * i] / radius);
        x[3 * i + 1] = path[2 * i + 1];
        x[3 * i + 2] = radius * sin(path[2 * i] / radius);
    }
    double* coords = fit_coords(x, frames, 3, 2);
    const double unrolled = affine_misfit(coords, 2, path, frames, 2);
    const double as_it_lies = affine_misfit(coords, 2, x, frames, 3);
    assert_below(unrolled, 0.05, "misfit of the unrolled sheet");
    assert_true(as_it_lies > 0.3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flat_sheet_is_recovered),
        cmocka_unit_test(circle_in_two_dimensions_is_itself),
        cmocka_unit_test(circle_in_one_dimension_is_arc_length),
        cmocka_unit_test(rolled_sheet_is_unrolled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
