/* SPDX-License-Identifier: BSD-3-Clause */
/* Properties of every fit: the form of the coordinates, and consistent facts of the model. */
#include "support.h"

enum { rows = 500, cols = 9, d = 3 };

struct fixture {
    double* x;
    double* coords;
    stltsa_model* model;
};

static int set_up(void** state) {
    struct fixture* f = calloc(1, sizeof *f);
    f->x = new_motion(rows, cols, 11);
    stltsa_options* options = new_options(12, 14, d);
    f->model = fitted_rows(f->x, rows, cols, options);
    f->coords = array_of(f->model, STLTSA_INFO_COORDS);
    *state = f;
    return 0;
}

static int tear_down(void** state) {
    struct fixture* f = *state;
    free(f);
    return 0;
}

static void columns_are_centered_and_orthonormal(void** state) {
    const struct fixture* f = *state;
    for (int a = 0; a < d; ++a) {
        double sum = 0;
        for (int i = 0; i < rows; ++i)
            sum += f->coords[i * d + a];
        assert_below(fabs(sum), 1e-12, "sum of a coordinate");
        for (int b = 0; b <= a; ++b) {
            double product = 0;
            for (int i = 0; i < rows; ++i)
                product += f->coords[i * d + a] * f->coords[i * d + b];
            assert_below(fabs(product - (a == b)), 1e-12, "inner product of coordinates");
        }
    }
}

static void assert_largest_are_positive(const double* coords, int64_t count) {
    for (int a = 0; a < d; ++a) {
        double largest = 0;
        for (int64_t i = 0; i < count; ++i)
            if (fabs(coords[i * d + a]) > fabs(largest))
                largest = coords[i * d + a];
        assert_true(largest > 0);
    }
}

/* Anywhere in a long clip, too, whose frames are searched in several blocks. */
static void entry_of_largest_size_is_positive(void** state) {
    const struct fixture* f = *state;
    assert_largest_are_positive(f->coords, rows);
    enum { many = 5000 };
    for (uint64_t seed = 40; seed < 46; ++seed) {
        double* x = new_motion(many, cols, seed);
        double* coords = fit_coords(x, many, cols, d);
        assert_largest_are_positive(coords, many);
    }
}

static void eigenvalues_ascend_from_zero(void** state) {
    const struct fixture* f = *state;
    double* values = array_of(f->model, STLTSA_INFO_EIGENVALUES);
    assert_true(values[0] == 0);
    for (int v = 1; v < d + 2; ++v)
        assert_true(values[v] > 0 && values[v] >= values[v - 1]);
    assert_below(fabs(component_at(f->model, 0).gap - values[d + 1] / values[d]), 1e-12,
                 "gap against eigenvalues");
}

static void model_says_what_it_did(void** state) {
    const struct fixture* f = *state;
    assert_int_equal(int_of(f->model, STLTSA_INFO_ROWS), rows);
    assert_int_equal(int_of(f->model, STLTSA_INFO_FEATURE_COUNT), cols);
    assert_int_equal(int_of(f->model, STLTSA_INFO_DIMENSION), d);
    assert_int_equal(int_of(f->model, STLTSA_INFO_NEIGHBORS), 12);
    assert_int_equal(int_of(f->model, STLTSA_INFO_WINDOW), 14);
    assert_int_equal(int_of(f->model, STLTSA_INFO_MODE), STLTSA_MODE_TEMPORAL);
    assert_int_equal(int_of(f->model, STLTSA_INFO_INCLUDE_SELF), 1);
    assert_int_equal(count_of(f->model, STLTSA_INFO_COMPONENT), 1);
    assert_int_equal(int_of(f->model, STLTSA_INFO_REPEATED), 0);
    assert_int_equal(component_at(f->model, 0).rank_deficient_windows, 0);
    assert_int_equal(int_of(f->model, STLTSA_INFO_FIRST_FRAME), 0);
    assert_int_equal(int_of(f->model, STLTSA_INFO_FRAME_STEP), 1);
    assert_in_range(component_at(f->model, 0).solves, 1, 200);
    assert_true(real_of(f->model, STLTSA_INFO_FPS) == 0);
    assert_below(component_at(f->model, 0).residual, 1e-12, "residual");
    assert_below(component_at(f->model, 0).error_estimate_rad, 1e-7, "error estimate");
    assert_true(component_at(f->model, 0).error_estimate_rad > 0);
}

static void outputs_take_any_stride_and_type(void** state) {
    const struct fixture* f = *state;
    const stltsa_info* info = stltsa_model_info(f->model);
    double transposed[d * rows];
    const stltsa_out t = {transposed, rows, d, sizeof(double), rows * (int64_t)sizeof(double),
                          STLTSA_F64, 0};
    must(stltsa_info_array(info, STLTSA_INFO_COORDS, 0, &t));
    float narrow[2 * rows * d];
    for (int i = 0; i < 2 * rows * d; ++i)
        narrow[i] = 7;
    const stltsa_out gaps = {narrow,     rows, d, 2 * d * (int64_t)sizeof(float), 2 * sizeof(float),
                             STLTSA_F32, 0};
    must(stltsa_info_array(info, STLTSA_INFO_COORDS, 0, &gaps));
    for (int i = 0; i < rows; ++i)
        for (int a = 0; a < d; ++a) {
            assert_true(transposed[a * rows + i] == f->coords[i * d + a]);
            assert_true(narrow[2 * (i * d + a)] == (float)f->coords[i * d + a]);
            assert_true(narrow[2 * (i * d + a) + 1] == 7);
        }
}

static void every_frame_has_its_component(void** state) {
    const struct fixture* f = *state;
    int64_t* labels = whole_of(f->model, STLTSA_INFO_COMPONENT_OF);
    for (int i = 0; i < rows; ++i)
        assert_int_equal(labels[i], 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_are_centered_and_orthonormal),
        cmocka_unit_test(entry_of_largest_size_is_positive),
        cmocka_unit_test(eigenvalues_ascend_from_zero),
        cmocka_unit_test(model_says_what_it_did),
        cmocka_unit_test(outputs_take_any_stride_and_type),
        cmocka_unit_test(every_frame_has_its_component),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
