/* SPDX-License-Identifier: BSD-3-Clause */
/* The intrinsic dimension through the C API. */
#include "support.h"

static const char* walker_path;

static stltsa_clip* opened(void) {
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    return clip;
}

static void dimension_of_the_walk(void** state) {
    (void)state;
    stltsa_clip* clip = opened();
    stltsa_dimension* result = NULL;
    const char* reason = NULL;
    must(stltsa_estimate_dimension_clip(clip, NULL, &result));
    assert_in_range(stltsa_dimension_local_pca(result, &reason), 1, 5);
    assert_string_equal(reason, "");
    const stltsa_info* info = stltsa_dimension_info(result);
    const int64_t count = stltsa_info_count(info, STLTSA_INFO_EIGENVALUE);
    assert_in_range(count, 4, 1000);
    double* values = new_matrix(count, 1);
    stltsa_out out = packed_out(values, count, 1);
    must(stltsa_dimension_eigenvalues(result, &out));
    assert_below(fabs(values[0]), 1e-10, "the zero eigenvalue");
    for (int64_t i = 1; i < count; ++i)
        assert_true(values[i] >= values[i - 1]);
    free(values);
    const int64_t directions = stltsa_info_count(info, STLTSA_INFO_LOCAL_VARIANCE);
    assert_in_range(directions, 3, 1000);
    double* shares = new_matrix(directions, 1);
    out = packed_out(shares, directions, 1);
    must(stltsa_dimension_local_variances(result, &out));
    assert_true(shares[0] > shares[1] && shares[1] > shares[2] && shares[0] < 1);
    out.rows = 2;
    assert_int_equal(stltsa_dimension_local_variances(result, &out), STLTSA_E_SHAPE);
    assert_int_equal(stltsa_dimension_eigenvalues(result, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_dimension_eigenvalues(NULL, &out), STLTSA_E_ARGUMENT);
    free(shares);
    stltsa_dimension_free(result);
    stltsa_clip_free(clip);
}

static void dimension_of_a_cut_clip_cannot_be_told(void** state) {
    (void)state;
    enum { rows = 200, cols = 5 };
    double* x = new_motion(rows, cols, 3);
    for (int i = rows / 2 * cols; i < rows * cols; ++i)
        x[i] += 1000;
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_options* options = new_options(12, 12, 2);
    stltsa_dimension* result = NULL;
    const char* reason = NULL;
    must(stltsa_estimate_dimension(&in, NULL, options, &result));
    assert_int_equal(stltsa_dimension_eigengap(result, &reason), 0);
    assert_non_null(strstr(reason, "2 parts"));
    stltsa_dimension_free(result);
    stltsa_dimension_free(NULL);
    stltsa_options_free(options);
    free(x);
}

static void dimension_of_a_helix_is_two(void** state) {
    (void)state;
    /* Half a turn within a neighborhood: bent in one plane, and small along the axis. */
    enum { rows = 300, cols = 3 };
    double* x = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i) {
        x[i * cols] = cos(0.25 * i);
        x[i * cols + 1] = sin(0.25 * i);
        x[i * cols + 2] = 0.001 * i;
    }
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_options* options = new_options(12, 12, 2);
    stltsa_dimension* result = NULL;
    must(stltsa_estimate_dimension(&in, NULL, options, &result));
    assert_int_equal(stltsa_dimension_local_pca(result, NULL), 2);
    stltsa_dimension_free(result);
    stltsa_options_free(options);
    free(x);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dimension_of_the_walk),
        cmocka_unit_test(dimension_of_a_cut_clip_cannot_be_told),
        cmocka_unit_test(dimension_of_a_helix_is_two),
    };
    if (argc < 2) {
        fprintf(stderr, "usage: unit_dimension WALKER.bvh\n");
        return 2;
    }
    walker_path = argv[1];
    return cmocka_run_group_tests(tests, NULL, NULL);
}
