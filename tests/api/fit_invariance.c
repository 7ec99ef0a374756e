/* SPDX-License-Identifier: BSD-3-Clause */
/* Coordinates do not depend on the position of the frames in space and memory, on the number of
 * threads, or on other work of the process. */
#define _POSIX_C_SOURCE 200809L
#include <sys/wait.h>
#include <threads.h>
#include <time.h>
#include <unistd.h>

#include "fit_threads.h"

enum { rows = 600, cols = 12, d = 2 };

TEST(rotation_and_shift_change_nothing) {
    double* x = new_motion(rows, cols, 21);
    double* rotation = new_directions(cols, cols, 22);
    double* moved = new_product(x, rotation, rows, cols, cols);
    for (int i = 0; i < rows * cols; ++i)
        moved[i] += 3 * (i % cols);
    double* want = fit_coords(x, rows, cols, d);
    double* got = fit_coords(moved, rows, cols, d);
    assert_below(largest_difference(want, got, rows * d), 1e-9, "change by rotation and shift");
}

static stltsa_options* options_of_mode(int32_t mode) {
    stltsa_options* options = new_options(12, 12, d);
    must(stltsa_options_set_int(options, STLTSA_OPT_MODE, mode));
    return options;
}

/* Squares of such distances underflow. */
static void check_tiny_numbers(int32_t mode, const double* x) {
    double* want = fit_coords_with(options_of_mode(mode), x, rows, cols);
    for (int power = 528; power <= 960; power += 216) {
        double* tiny = copy_of(x, rows * cols);
        for (int i = 0; i < rows * cols; ++i)
            tiny[i] = ldexp(tiny[i], -power);
        double* got = fit_coords_with(options_of_mode(mode), tiny, rows, cols);
        assert_below(largest_difference(want, got, rows * d), 1e-9, "change by scale");
    }
}

TEST(tiny_numbers_are_as_good_as_others) {
    double* x = new_motion(rows, cols, 24);
    check_tiny_numbers(STLTSA_MODE_TEMPORAL, x);
    check_tiny_numbers(STLTSA_MODE_SPATIAL, x);
    check_tiny_numbers(STLTSA_MODE_RECURRENT, x);
}

TEST(scale_changes_nothing) {
    double* x = new_motion(rows, cols, 23);
    double* want = fit_coords(x, rows, cols, d);
    static const double scales[] = {0x1p10, -0.5, 1e6, 1e-9};
    for (int s = 0; s < 4; ++s) {
        double* scaled = copy_of(x, rows * cols);
        for (int i = 0; i < rows * cols; ++i)
            scaled[i] *= scales[s];
        double* got = fit_coords(scaled, rows, cols, d);
        assert_below(largest_difference(want, got, rows * d), 1e-9, "change by scale");
        if (s < 2) /* scaling by a power of two is exact */
            assert_same_bits(want, got, rows * d);
    }
}

TEST(shift_that_rounds_nothing_changes_no_bit) {
    double* x = new_motion(rows, cols, 24);
    for (int i = 0; i < rows * cols; ++i)
        x[i] = round(x[i] * 0x1p20) * 0x1p-20;
    double* want = fit_coords(x, rows, cols, d);
    for (int i = 0; i < rows * cols; ++i)
        x[i] += 1024;
    double* got = fit_coords(x, rows, cols, d);
    assert_same_bits(want, got, rows * d);
}

TEST(order_of_channels_does_not_matter) {
    double* x = new_motion(rows, cols, 25);
    double* shuffled = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i)
        for (int c = 0; c < cols; ++c)
            shuffled[i * cols + (5 * c + 3) % cols] = x[i * cols + c];
    double* want = fit_coords(x, rows, cols, d);
    double* got = fit_coords(shuffled, rows, cols, d);
    assert_below(largest_difference(want, got, rows * d), 1e-9, "change by order of channels");
}

/* Except at the boundary: reversed time gives the reversed curve. */
TEST(time_backwards_reverses_the_curve) {
    double* x = new_motion(rows, cols, 26);
    double* backwards = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i)
        memcpy(backwards + i * cols, x + (rows - 1 - i) * cols, cols * sizeof *x);
    double* want = fit_coords(x, rows, cols, d);
    double* got = fit_coords(backwards, rows, cols, d);
    for (int i = 0; i < rows; ++i)
        assert_below(largest_difference(want + i * d, got + (rows - 1 - i) * d, d), 1e-9,
                     "change by reversing time");
}

static double* fit_with_threads(const double* x, int64_t threads) {
    stltsa_options* options = new_options(12, 12, d);
    if (threads > 0)
        must(stltsa_options_set_int(options, STLTSA_OPT_THREADS, threads));
    return fit_coords_with(options, x, rows, cols);
}

TEST(number_of_threads_changes_no_bit) {
    double* x = new_motion(rows, cols, 27);
    double* want = fit_with_threads(x, 1);
    for (int64_t threads = 0; threads <= 4; ++threads) {
        double* got = fit_with_threads(x, threads);
        assert_same_bits(want, got, rows * d);
    }
}

/* The kernel may list a thread for a moment after it was joined. */
static void assert_no_more_threads_than(int count) {
    const struct timespec moment = {0, 10000000};
    for (int looks = 0; looks < 200 && count_threads() > count; ++looks)
        nanosleep(&moment, NULL);
    assert_in_range(count_threads(), 1, count);
}

/* Includes threads of the libraries below: a forked process would wait for them. */
TEST(threads_end_with_the_call) {
    const int before = count_threads(); /* includes OpenBLAS's own, which it ends at a fork */
    double* x = new_motion(rows, cols, 28);
    const stltsa_in in = packed_in(x, rows, cols);
    for (int m = 0; m < 3; ++m) {
        must(fit_in_mode(&in, all_modes[m], 3, NULL, NULL));
        assert_no_more_threads_than(before);
        const pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0) {
            alarm(60);
            _exit(fit_in_mode(&in, all_modes[m], 3, NULL, NULL) == STLTSA_OK ? 0 : 1);
        }
        int ended = -1;
        assert_int_equal(waitpid(child, &ended, 0), child);
        assert_int_equal(ended, 0);
    }
}

static int fit_in_a_thread(void* argument) {
    double** xy = argument;
    xy[1] = fit_with_threads(xy[0], 1);
    return 0;
}

/* ARPACK keeps state between calls: simultaneous fits must not share it. */
TEST(fits_at_the_same_time_change_no_bit) {
    enum { count = 6 };
    double* x[count];
    double* want[count];
    for (int f = 0; f < count; ++f) {
        x[f] = new_motion(rows, cols, 30 + (uint64_t)f);
        want[f] = fit_with_threads(x[f], 1);
    }
    for (int round = 0; round < 5; ++round) {
        thrd_t threads[count];
        double* jobs[count][2];
        for (int f = 0; f < count; ++f) {
            jobs[f][0] = x[f];
            jobs[f][1] = NULL;
            assert_int_equal(thrd_create(&threads[f], fit_in_a_thread, jobs[f]), thrd_success);
        }
        for (int f = 0; f < count; ++f)
            thrd_join(threads[f], NULL);
        for (int f = 0; f < count; ++f) {
            assert_non_null(jobs[f][1]);
            assert_same_bits(want[f], jobs[f][1], rows * d);
        }
    }
}

static double* fit_array(const stltsa_in* in) {
    stltsa_options* options = new_options(12, 12, d);
    stltsa_model* model = NULL;
    must(stltsa_fit(in, NULL, options, &model));
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    stltsa_model_free(model);
    return coords;
}

/* Puts frame i, channel c at byte `origin + i * row + c * col` and fits that. */
static void assert_layout_changes_no_bit(const double* x, const double* want, int64_t size,
                                         int64_t origin, int64_t row, int64_t col) {
    unsigned char* memory = malloc((size_t)size);
    assert_non_null(memory);
    memset(memory, 0xff, (size_t)size); /* NaN everywhere outside the matrix */
    for (int i = 0; i < rows; ++i)
        for (int c = 0; c < cols; ++c)
            memcpy(memory + origin + i * row + c * col, x + i * cols + c, sizeof *x);
    const stltsa_in in = {memory + origin, rows, cols, row, col, STLTSA_F64, 0};
    double* got = fit_array(&in);
    assert_same_bits(want, got, rows * d);
    free(memory);
}

TEST(layout_in_memory_changes_no_bit) {
    double* x = new_motion(rows, cols, 40);
    double* want = fit_coords(x, rows, cols, d);
    const int64_t all = rows * cols * 8;
    assert_layout_changes_no_bit(x, want, all, 0, cols * 8, 8);
    assert_layout_changes_no_bit(x, want, rows * (cols + 3) * 8, 0, (cols + 3) * 8, 8);
    assert_layout_changes_no_bit(x, want, 2 * all, 0, cols * 16, 16);
    assert_layout_changes_no_bit(x, want, all, 0, 8, rows * 8);
    assert_layout_changes_no_bit(x, want, all, (rows - 1) * cols * 8, -cols * 8, 8);
    assert_layout_changes_no_bit(x, want, all, (cols - 1) * 8, cols * 8, -8);
    assert_layout_changes_no_bit(x, want, rows * (cols * 8 + 1) + 1, 1, cols * 8 + 1, 8);
}

TEST(float32_is_the_same_numbers) {
    double* x = new_motion(rows, cols, 41);
    double* exact = fit_coords(x, rows, cols, d);
    float* narrow = malloc(rows * cols * sizeof *narrow);
    assert_non_null(narrow);
    for (int i = 0; i < rows * cols; ++i) {
        narrow[i] = (float)x[i];
        x[i] = narrow[i];
    }
    double* want = fit_coords(x, rows, cols, d);
    const stltsa_in in = {narrow, rows, cols, 0, 0, STLTSA_F32, 0};
    double* got = fit_array(&in);
    assert_same_bits(want, got, rows * d);
    assert_below(largest_difference(exact, got, rows * d), 1e-4, "change by rounding to float32");
    assert_true(largest_difference(exact, got, rows * d) > 0);
    free(narrow);
}

/* Clips of 600, 250 and 300 frames in two orders: each has the same result as alone. */
TEST(order_of_clips_only_permutes) {
    enum { clips = 3, total = 1150 };
    static const int64_t length[clips] = {600, 250, 300};
    static const int order[2][clips] = {{0, 1, 2}, {2, 0, 1}};
    stltsa_options* options = new_options(12, 12, d);
    for (int o = 0; o < 2; ++o) {
        double* x = new_matrix(total, cols);
        int64_t lengths[clips];
        int64_t at = 0;
        for (int p = 0; p < clips; ++p) {
            lengths[p] = length[order[o][p]];
            double* clip = new_motion(lengths[p], cols, 50 + (uint64_t)order[o][p]);
            memcpy(x + at * cols, clip, (size_t)(lengths[p] * cols) * sizeof *x);
            at += lengths[p];
        }
        const stltsa_in in = packed_in(x, total, cols);
        stltsa_model* model = NULL;
        const stltsa_in list = list_in(lengths, clips);
        must(stltsa_fit(&in, &list, options, &model));
        assert_int_equal(count_of(model, STLTSA_INFO_COMPONENT), clips);
        double* together = array_of(model, STLTSA_INFO_COORDS);
        at = 0;
        for (int p = 0; p < clips; ++p) {
            double* alone = fit_coords(x + at * cols, lengths[p], cols, d);
            assert_below(largest_difference(alone, together + at * d, lengths[p] * d), 1e-10,
                         "clip among others against alone");
            at += lengths[p];
        }
        stltsa_model_free(model);
    }
}

/* Nor does it need memory for the gaps. */
TEST(window_beyond_the_clip_is_the_clip) {
    double* x = new_motion(rows, cols, 9);
    double* all = fit_coords_with(new_options(12, rows, 2), x, rows, cols);
    double* more = fit_coords_with(new_options(12, INT32_MAX, 2), x, rows, cols);
    assert_same_bits(all, more, rows * 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rotation_and_shift_change_nothing),
        cmocka_unit_test(scale_changes_nothing),
        cmocka_unit_test(tiny_numbers_are_as_good_as_others),
        cmocka_unit_test(shift_that_rounds_nothing_changes_no_bit),
        cmocka_unit_test(order_of_channels_does_not_matter),
        cmocka_unit_test(time_backwards_reverses_the_curve),
        cmocka_unit_test(number_of_threads_changes_no_bit),
        cmocka_unit_test(threads_end_with_the_call),
        cmocka_unit_test(fits_at_the_same_time_change_no_bit),
        cmocka_unit_test(layout_in_memory_changes_no_bit),
        cmocka_unit_test(float32_is_the_same_numbers),
        cmocka_unit_test(order_of_clips_only_permutes),
        cmocka_unit_test(window_beyond_the_clip_is_the_clip),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
