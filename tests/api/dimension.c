/* SPDX-License-Identifier: BSD-3-Clause */
/* The intrinsic dimension: facts of a model that was fitted with option intrinsic. */
#include "support.h"

static stltsa_options* intrinsic(int64_t k, int64_t w, int64_t d) {
    stltsa_options* options = new_options(k, w, d);
    must(stltsa_options_set_int(options, STLTSA_OPT_INTRINSIC, 1));
    return options;
}

TEST(dimension_of_the_walk) {
    stltsa_clip* clip = opened();
    stltsa_options* options = with_int(STLTSA_OPT_INTRINSIC, 1);
    stltsa_model* model = fitted_clip(clip, options);
    const stltsa_info* info = stltsa_model_info(model);
    assert_in_range(int_of(model, STLTSA_INFO_LOCAL_PCA), 1, 5);
    assert_string_equal(text_of(model, STLTSA_INFO_LOCAL_PCA_REASON), "");
    assert_true(real_of(model, STLTSA_INFO_VARIANCE) == 0.95);
    assert_true(real_of(model, STLTSA_INFO_EIGENGAP_THRESHOLD) > 0);
    const int64_t count = stltsa_info_count(info, STLTSA_INFO_EIGENVALUE);
    assert_in_range(count, 4, 1000);
    assert_below(fabs(get_real(info, STLTSA_INFO_EIGENVALUE, 0)), 1e-10, "the zero eigenvalue");
    for (int64_t i = 1; i < count; ++i)
        assert_true(get_real(info, STLTSA_INFO_EIGENVALUE, i) >=
                    get_real(info, STLTSA_INFO_EIGENVALUE, i - 1));
    assert_in_range(stltsa_info_count(info, STLTSA_INFO_LOCAL_VARIANCE), 3, 1000);
    for (int64_t i = 0; i < 2; ++i)
        assert_true(get_real(info, STLTSA_INFO_LOCAL_VARIANCE, i) >
                    get_real(info, STLTSA_INFO_LOCAL_VARIANCE, i + 1));
    assert_true(get_real(info, STLTSA_INFO_LOCAL_VARIANCE, 0) < 1);
}

/* It costs time, so it is not estimated unless it is asked for; the coordinates are the same. */
TEST(dimension_is_estimated_if_asked_for) {
    enum { rows = 200, cols = 5 };
    double* x = new_motion(rows, cols, 3);
    stltsa_options *options = intrinsic(12, 12, 2), *plain = new_options(12, 12, 2);
    stltsa_model *with_it = fitted_rows(x, rows, cols, options),
                 *without = fitted_rows(x, rows, cols, plain);
    assert_int_equal(count_of(with_it, STLTSA_INFO_LOCAL_PCA), 1);
    const int32_t keys[] = {STLTSA_INFO_LOCAL_PCA,        STLTSA_INFO_EIGENGAP,
                            STLTSA_INFO_LOCAL_PCA_REASON, STLTSA_INFO_EIGENGAP_REASON,
                            STLTSA_INFO_VARIANCE,         STLTSA_INFO_EIGENGAP_THRESHOLD,
                            STLTSA_INFO_EIGENVALUE,       STLTSA_INFO_LOCAL_VARIANCE};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; ++i)
        assert_int_equal(count_of(without, keys[i]), 0);
    double *a = array_of(with_it, STLTSA_INFO_COORDS), *b = array_of(without, STLTSA_INFO_COORDS);
    assert_same_bits(a, b, rows * 2);
}

TEST(dimension_of_a_cut_clip_cannot_be_told) {
    enum { rows = 200, cols = 5 };
    double* x = new_motion(rows, cols, 3);
    for (int i = rows / 2 * cols; i < rows * cols; ++i)
        x[i] += 1000;
    stltsa_options* options = intrinsic(12, 12, 2);
    stltsa_model* model = fitted_rows(x, rows, cols, options);
    assert_int_equal(int_of(model, STLTSA_INFO_EIGENGAP), 0);
    assert_non_null(strstr(text_of(model, STLTSA_INFO_EIGENGAP_REASON), "2 parts"));
}

TEST(dimension_of_a_helix_is_two) {
    /* Half a turn within a neighborhood: bent in one plane, and small along the axis. */
    enum { rows = 300, cols = 3 };
    double* x = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i) {
        x[i * cols] = cos(0.25 * i);
        x[i * cols + 1] = sin(0.25 * i);
        x[i * cols + 2] = 0.001 * i;
    }
    stltsa_options* options = intrinsic(12, 12, 2);
    stltsa_model* model = fitted_rows(x, rows, cols, options);
    assert_int_equal(int_of(model, STLTSA_INFO_LOCAL_PCA), 2);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dimension_of_the_walk),
        cmocka_unit_test(dimension_is_estimated_if_asked_for),
        cmocka_unit_test(dimension_of_a_cut_clip_cannot_be_told),
        cmocka_unit_test(dimension_of_a_helix_is_two),
    };
    return run_on_walker(tests, argc, argv);
}
