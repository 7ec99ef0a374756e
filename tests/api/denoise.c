/* SPDX-License-Identifier: BSD-3-Clause */
/* Denoising through the public API: shapes, options, errors, models. */
#include "support.h"

enum { rows = 150, cols = 2 };

/* Two noisy swings, one cycle per 33 rows. */
static double* new_noisy(void) {
    double* y = new_matrix(rows, cols);
    uint64_t seed = 5;
    for (int64_t i = 0; i < rows; ++i)
        for (int64_t c = 0; c < cols; ++c)
            y[i * cols + c] = sin(2 * pi * (double)i / 33 + (double)c) + 0.3 * uniform(&seed);
    return y;
}

static stltsa_denoising* denoised(const double* y, const stltsa_options* options) {
    const stltsa_in in = packed_in(y, rows, cols);
    stltsa_denoising* denoising = NULL;
    must(stltsa_denoise(&in, NULL, options, &denoising));
    return keep_denoising(denoising);
}

TEST(cleaned_is_points_and_moves) {
    double* y = new_noisy();
    stltsa_denoising* d = denoised(y, NULL);
    assert_int_equal(int_of(d, STLTSA_INFO_ROWS), rows);
    assert_int_equal(count_of(d, STLTSA_INFO_COLUMN), cols);
    double* curve = array_of(d, STLTSA_INFO_CURVE);
    double* cleaned = array_of(d, STLTSA_INFO_CLEANED);
    double* moves = array_of(d, STLTSA_INFO_MOVES);
    for (int64_t c = 0; c < cols; ++c) {
        const stltsa_denoised_column column = column_at(d, c);
        assert_true(column.gamma == column.noise);
        assert_true(column.shift > column.gamma);
        assert_true(column.degrees_of_freedom > 2);
        int64_t moved = 0;
        for (int64_t i = c; i < rows * cols; i += cols) {
            assert_int_equal(moves[i] != 0, fabs(y[i] - curve[i]) > column.gamma);
            assert_below(fabs(y[i] + moves[i] - cleaned[i]), 1e-14, "y + moves - cleaned");
            moved += moves[i] != 0;
        }
        assert_int_equal(column.moved, moved);
    }
}

/* Twice the points and noise give twice the curve, to the bit. */
TEST(scale_and_repetition_change_no_bit) {
    double* y = new_noisy();
    stltsa_denoising* one = denoised(y, NULL);
    stltsa_denoising* again = denoised(y, NULL);
    double* curve = array_of(one, STLTSA_INFO_CURVE);
    double* same = array_of(again, STLTSA_INFO_CURVE);
    assert_same_bits(curve, same, rows * cols);
    for (int64_t i = 0; i < rows * cols; ++i) {
        y[i] *= 0x1p+300;
        curve[i] *= 0x1p+300;
    }
    stltsa_denoising* large = denoised(y, NULL);
    double* twice = array_of(large, STLTSA_INFO_CURVE);
    assert_same_bits(curve, twice, rows * cols);
}

TEST(options_are_used) {
    double* y = new_noisy();
    stltsa_options* options = with(STLTSA_OPT_GAMMA, 1e9);
    stltsa_denoising* d = denoised(y, options);
    assert_true(column_at(d, 0).gamma == 1e9);
    assert_int_equal(column_at(d, 0).moved, 0);
    double* cleaned = array_of(d, STLTSA_INFO_CLEANED);
    assert_same_bits(cleaned, y, rows * cols);

    /* Knots 2 s apart at 30 rows per second cannot follow a cycle of 1.1 s. */
    must(stltsa_options_set_real(options, STLTSA_OPT_FPS, 30));
    must(stltsa_options_set_real(options, STLTSA_OPT_KNOT_SPACING, 2));
    d = denoised(y, options);
    assert_true(column_at(d, 0).degrees_of_freedom < 6);

    must(stltsa_options_unset(options, STLTSA_OPT_KNOT_SPACING));
    d = denoised(y, options);
    assert_below(fabs(real_of(d, STLTSA_INFO_PERIOD) - 1.1), 0.05, "period");
}

TEST(spikes_are_refused_by_default) {
    double* y = new_noisy();
    double* spiked = copy_of(y, rows * cols);
    for (int64_t i = 20; i < rows; i += 30)
        spiked[i * cols] += 20;
    stltsa_options* plain = with_int(STLTSA_OPT_ROBUST, 0);
    double off[2];
    for (int robust = 0; robust < 2; ++robust) {
        stltsa_denoising* clean = denoised(y, plain);
        stltsa_denoising* d = denoised(spiked, robust ? NULL : plain);
        double* expected = array_of(clean, STLTSA_INFO_CURVE);
        double* curve = array_of(d, STLTSA_INFO_CURVE);
        off[robust] = largest_difference(expected, curve, rows * cols);
    }
    assert_true(off[0] > 1);
    assert_true(off[1] < 0.2);
}

TEST(clips_are_apart) {
    double* y = new_noisy();
    for (int64_t i = 100 * cols; i < rows * cols; ++i)
        y[i] += 1000;
    const stltsa_in in = packed_in(y, rows, cols);
    const int64_t lengths[] = {100, 50};
    const stltsa_in clips = list_in(lengths, 2);
    stltsa_denoising* d = NULL;
    must(stltsa_denoise(&in, &clips, NULL, &d));
    double* curve = array_of(d, STLTSA_INFO_CURVE);
    assert_below(largest_difference(y, curve, rows * cols), 1, "distance from the curve");
    stltsa_denoising_free(d);
}

/* A model: its coordinates, with a piece for each component. */
TEST(models_are_cleaned_piece_by_piece) {
    const int64_t n = 120;
    double* x = new_motion(n, 5, 3);
    for (int64_t i = 70 * 5; i < n * 5; ++i)
        x[i] += 1e4;
    stltsa_options* options = new_options(6, 8, 1);
    stltsa_model* model = fitted_rows(x, n, 5, options);
    assert_int_equal(count_of(model, STLTSA_INFO_COMPONENT), 2);
    stltsa_denoising* d = NULL;
    must(stltsa_denoise_model(model, options, &d));
    for (int i = 0; i < 2; ++i)
        assert_int_equal(get_int(stltsa_denoising_info(d), STLTSA_INFO_LENGTH, i), i ? 50 : 70);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    double* cleaned = array_of(d, STLTSA_INFO_CLEANED);
    double* moves = array_of(d, STLTSA_INFO_MOVES);
    for (int64_t i = 0; i < n; ++i)
        assert_below(fabs(coords[i] + moves[i] - cleaned[i]), 1e-15, "coords + moves - cleaned");
    stltsa_denoising_free(d);
}

static int32_t cancel(void* user, int32_t stage, double fraction) {
    (void)user;
    return stage == STLTSA_STAGE_DENOISE && fraction > 0;
}

static int32_t count_starts(void* user, int32_t stage, double fraction) {
    *(int*)user += stage == STLTSA_STAGE_DENOISE && fraction == 0;
    return 0;
}

/* For the period, and for the first coordinate. */
TEST(the_search_for_the_period_calls_back) {
    double* y = new_noisy();
    int starts = 0;
    stltsa_options* options = with_progress(count_starts, &starts);
    denoised(y, options);
    assert_in_range(starts, 2, 100000);
}

static void refuses(stltsa_status status, const stltsa_in* in, const stltsa_in* lengths,
                    const stltsa_options* options) {
    stltsa_denoising* d = (stltsa_denoising*)in; /* anything but NULL */
    assert_int_equal(stltsa_denoise(in, lengths, options, &d), status);
    assert_null(d);
    assert_true(strlen(stltsa_last_error()) > 0);
}

TEST(errors) {
    double* y = new_noisy();
    stltsa_in in = packed_in(y, rows, cols);
    const int64_t short_clip[] = {rows - 7, 7};
    const int64_t too_few[] = {10, 10};
    const stltsa_in short_lengths = list_in(short_clip, 2);
    const stltsa_in few_lengths = list_in(too_few, 2);
    refuses(STLTSA_E_TOO_FEW_FRAMES, &in, &short_lengths, NULL);
    refuses(STLTSA_E_SHAPE, &in, &few_lengths, NULL);
    refuses(STLTSA_E_ARGUMENT, NULL, NULL, NULL);
    in.rows = 7;
    refuses(STLTSA_E_TOO_FEW_FRAMES, &in, NULL, NULL);
    in.rows = 0;
    refuses(STLTSA_E_SHAPE, &in, NULL, NULL);
    in.rows = rows;
    stltsa_options* options = empty_options();
    assert_int_equal(stltsa_options_set_real(options, STLTSA_OPT_GAMMA, -1), STLTSA_E_ARGUMENT);
    must(stltsa_options_set_progress(options, cancel, NULL));
    refuses(STLTSA_E_CANCELLED, &in, NULL, options);

    stltsa_denoising* d = denoised(y, NULL);
    stltsa_denoising* none = d;
    assert_int_equal(stltsa_denoise_model(NULL, NULL, &none), STLTSA_E_ARGUMENT);
    assert_null(none);
    stltsa_denoising_free(NULL);

    y[17] = NAN;
    refuses(STLTSA_E_NOT_FINITE, &in, NULL, NULL);
    assert_non_null(strstr(stltsa_last_error(), "coords: row"));
    assert_non_null(strstr(stltsa_last_error(), "8")); /* the row */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cleaned_is_points_and_moves),
        cmocka_unit_test(scale_and_repetition_change_no_bit),
        cmocka_unit_test(options_are_used),
        cmocka_unit_test(spikes_are_refused_by_default),
        cmocka_unit_test(clips_are_apart),
        cmocka_unit_test(models_are_cleaned_piece_by_piece),
        cmocka_unit_test(the_search_for_the_period_calls_back),
        cmocka_unit_test(errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
