/* SPDX-License-Identifier: BSD-3-Clause */
/* Units and cycles through the C API, on the synthetic walker, whose borders are known exactly. */
#include "support.h"

/* The walker's default settings, see tests/walker/README.md. */
static const double true_period = 1.1;
static const double true_ends[] = {1.0, 1.8928494573520722, 5.1928494573520725, 6.027};

TEST(five_units_in_order) {
    stltsa_clip* clip = opened();
    stltsa_decomposition* d = decomposed(clip, NULL);
    assert_int_equal(count_of(d, STLTSA_INFO_UNIT), 5);
    for (int i = 0; i < 5; ++i) {
        const stltsa_unit u = unit_at(d, i);
        assert_int_equal(u.kind, STLTSA_UNIT_PREPARING + i);
        if (i < 4)
            assert_below(fabs(u.end_s - true_ends[i]), 0.1, "border");
        assert_int_equal(u.begin, i == 0 ? 0 : unit_at(d, i - 1).end);
        assert_below(fabs(u.begin_s * stltsa_clip_fps(clip) - (double)u.begin), 0.51, "begin_s");
    }
    assert_int_equal(unit_at(d, 4).end, stltsa_clip_frames(clip));
    assert_string_equal(text_of(d, STLTSA_INFO_REASON), "");
}

TEST(three_cycles_back_to_back) {
    stltsa_clip* clip = opened();
    stltsa_decomposition* d = decomposed(clip, NULL);
    assert_int_equal(count_of(d, STLTSA_INFO_CYCLE), 3);
    for (int i = 0; i < 3; ++i) {
        const stltsa_part cycle = cycle_at(d, i);
        assert_below(fabs(cycle.end_s - cycle.begin_s - true_period), 1e-3, "cycle");
        if (i > 0)
            assert_int_equal(cycle.begin, cycle_at(d, i - 1).end);
    }
    assert_below(fabs(real_of(d, STLTSA_INFO_PERIOD) / true_period - 1), 1e-3, "period");
    assert_true(real_of(d, STLTSA_INFO_CYCLICITY) > 0.9);
    assert_in_range(int_of(d, STLTSA_INFO_REPRESENTATIVE), 0, 2);
    assert_in_range(int_of(d, STLTSA_INFO_BEST), 0, 2);
}

/* No two of the first ones, which a picture shows, are alike, though the body stands twice. */
TEST(postures_differ) {
    stltsa_clip* clip = opened();
    stltsa_decomposition* d = decomposed(clip, NULL);
    const stltsa_info* info = stltsa_decomposition_info(d);
    assert_in_range(stltsa_info_count(info, STLTSA_INFO_POSTURES), 13, 24);
    const int64_t frames = stltsa_clip_frames(clip), cols = 4 * count_of(clip, STLTSA_INFO_JOINT);
    double* angles = array_of(clip, STLTSA_INFO_ROTATIONS);
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < i; ++j) {
            const int64_t a = get_int(info, STLTSA_INFO_POSTURES, i),
                          b = get_int(info, STLTSA_INFO_POSTURES, j);
            assert_in_range(a, 0, frames - 1);
            double squares = 0;
            for (int64_t c = 0; c < cols; ++c)
                squares += pow(angles[a * cols + c] - angles[b * cols + c], 2);
            assert_true(squares > 0.02);
        }
}

/* The second coordinate is a quarter of a cycle behind: the two go round. */
TEST(the_first_coordinate_is_the_curve) {
    stltsa_clip* clip = opened();
    stltsa_decomposition* d = decomposed(clip, NULL);
    const int64_t count = int_of(d, STLTSA_INFO_ROWS);
    double *curve = array_of(d, STLTSA_INFO_CURVE), *coords = array_of(d, STLTSA_INFO_COORDS);
    double square = 0, both = 0, second = 0;
    for (int64_t i = 0; i < count; ++i) {
        assert_true(coords[2 * i] == curve[i]);
        square += curve[i] * curve[i];
        second += coords[2 * i + 1] * coords[2 * i + 1];
        both += curve[i] * coords[2 * i + 1];
    }
    assert_true(square > 0 && second > 0.2 * square);
    assert_below(fabs(both), 0.3 * sqrt(square * second), "correlation of the two");
}

/* A clip that stands still has coordinates of the shape that it says. */
TEST(coordinates_of_a_clip_at_rest_are_zero) {
    enum { rows = 90, cols = 4 };
    double* x = new_matrix(rows, cols);
    stltsa_clip* clip = matrix_clip(x, rows, cols, 30);
    stltsa_decomposition* d = decomposed(clip, NULL);
    assert_int_equal(int_of(d, STLTSA_INFO_COORDINATE), 0);
    const int64_t count = 2 * int_of(d, STLTSA_INFO_ROWS);
    double* coords = array_of(d, STLTSA_INFO_COORDS);
    for (int64_t i = 0; i < count; ++i)
        assert_true(coords[i] == 0);
}

TEST(threads_change_no_bit) {
    stltsa_clip* clip = opened();
    double* curves[2];
    int64_t count = 0;
    for (int t = 0; t < 2; ++t) {
        stltsa_options* options = with_int(STLTSA_OPT_THREADS, t + 1);
        stltsa_decomposition* d = decomposed(clip, options);
        curves[t] = array_of(d, STLTSA_INFO_CURVE);
        count = int_of(d, STLTSA_INFO_ROWS);
    }
    assert_same_bits(curves[0], curves[1], count);
}

/* Rows of the walker's features, shifted and with their channels reversed. */
TEST(shift_and_order_of_channels_change_no_unit) {
    stltsa_clip* clip = opened();
    const int64_t rows = stltsa_clip_frames(clip);
    int64_t cols = 0;
    double* x = new_features(clip, NULL, &cols);
    double* y = new_matrix(rows, cols);
    for (int64_t i = 0; i < rows; ++i)
        for (int64_t c = 0; c < cols; ++c)
            y[i * cols + c] = x[i * cols + cols - 1 - c] + 64;
    stltsa_decomposition* d[2];
    const double* inputs[] = {x, y};
    for (int v = 0; v < 2; ++v) {
        stltsa_clip* bare = matrix_clip(inputs[v], rows, cols, stltsa_clip_fps(clip));
        d[v] = decomposed(bare, NULL);
    }
    assert_int_equal(count_of(d[0], STLTSA_INFO_UNIT), 5);
    assert_int_equal(count_of(d[1], STLTSA_INFO_UNIT), 5);
    for (int i = 0; i < 5; ++i) {
        assert_int_equal(unit_at(d[0], i).kind, unit_at(d[1], i).kind);
        assert_int_equal(unit_at(d[0], i).end, unit_at(d[1], i).end);
    }
}

TEST(noise_has_no_cycle_but_a_reason) {
    enum { rows = 300, cols = 6 };
    double* x = new_matrix(rows, cols);
    uint64_t seed = 5;
    for (int i = 0; i < rows * cols; ++i)
        x[i] = uniform(&seed);
    stltsa_clip* clip = matrix_clip(x, rows, cols, 30);
    stltsa_decomposition* d = decomposed(clip, NULL);
    assert_int_equal(count_of(d, STLTSA_INFO_CYCLE), 0);
    assert_true(strlen(text_of(d, STLTSA_INFO_REASON)) > 20);
    assert_int_equal(int_of(d, STLTSA_INFO_REPRESENTATIVE), -1);
    assert_true(real_of(d, STLTSA_INFO_PERIOD) == 0);
    assert_int_equal(unit_at(d, 0).begin, 0);
    assert_int_equal(unit_at(d, count_of(d, STLTSA_INFO_UNIT) - 1).end, rows);
    for (int64_t i = 0; i < count_of(d, STLTSA_INFO_UNIT); ++i)
        assert_int_not_equal(unit_at(d, i).kind, STLTSA_UNIT_CYCLIC);
}

/* Frames along a line: the eigenvalues hardly differ, so a small Krylov space never converges. */
TEST(one_blow_along_a_line) {
    enum { rows = 400 };
    double* x = new_matrix(rows, 2);
    for (int i = 0; i < rows; ++i) {
        const double t = 4.0 * i / (rows - 1);
        x[2 * i] = exp(-25 * (t - 2) * (t - 2));
        x[2 * i + 1] = 2 * x[2 * i] + 0.01 * t;
    }
    stltsa_clip* clip = matrix_clip(x, rows, 2, 100);
    stltsa_decomposition* d = decomposed(clip, NULL);
    assert_int_equal(count_of(d, STLTSA_INFO_CYCLE), 0);
}

/* Every stretch of the walk's cycles that begins and ends in the middle of a step. */
TEST(a_cut_is_no_standing) {
    stltsa_clip* walk = opened();
    int64_t cols = 0;
    double* x = new_features(walk, NULL, &cols);
    const double fps = stltsa_clip_fps(walk);
    const int64_t first = (int64_t)(true_ends[1] * fps), last = (int64_t)(true_ends[2] * fps);
    for (int64_t cut = 0; cut < (int64_t)(true_period * fps); cut += 4) {
        const stltsa_in in =
            packed_in(x + (first + cut) * cols, last - first - cut - cut / 2, cols);
        stltsa_clip* clip = NULL;
        must(stltsa_clip_from_matrix(&in, fps, &clip));
        stltsa_decomposition* d = decomposed(clip, NULL);
        for (int64_t i = 0; i < count_of(d, STLTSA_INFO_UNIT); ++i)
            assert_true(unit_at(d, i).kind != STLTSA_UNIT_PREPARING &&
                        unit_at(d, i).kind != STLTSA_UNIT_WIND_UP);
        stltsa_clip_free(clip);
    }
}

struct stop {
    int64_t calls, after;
};

static int32_t stop_after(void* user, int32_t stage, double fraction) {
    struct stop* stop = user;
    assert_in_range(stage, STLTSA_STAGE_READ, STLTSA_STAGE_UNITS);
    assert_true(fraction >= 0 && fraction <= 1);
    return ++stop->calls > stop->after;
}

TEST(cancelled_at_every_call) {
    stltsa_clip* clip = opened();
    stltsa_options* options = empty_options();
    stltsa_status status = STLTSA_E_CANCELLED;
    struct stop stop = {0, 0};
    must(stltsa_options_set_progress(options, stop_after, &stop));
    for (stop.after = 0; status == STLTSA_E_CANCELLED; stop.after += 1 + stop.after / 4) {
        stltsa_decomposition* d = (stltsa_decomposition*)(void*)&stop;
        stop.calls = 0;
        status = stltsa_decompose(clip, options, &d);
        assert_true((d == NULL) == (status != STLTSA_OK));
        stltsa_decomposition_free(d);
    }
    assert_int_equal(status, STLTSA_OK);
    assert_true(stop.after > 10);
}

struct way {
    int32_t stage;
    double fraction;
    int64_t calls;
};

static int32_t only_forward(void* user, int32_t stage, double fraction) {
    struct way* way = user;
    assert_true(stage > way->stage || (stage == way->stage && fraction >= way->fraction));
    assert_true(fraction >= 0 && fraction <= 1);
    *way = (struct way){stage, fraction, way->calls + 1};
    return 0;
}

/* With several embeddings and, recurrent, a search for neighbors after that for the period. */
TEST(progress_never_goes_back) {
    stltsa_clip* clip = opened();
    struct way decomposing = {0};
    stltsa_options* options = NULL;
    stltsa_decomposition* d = NULL;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_progress(options, only_forward, &decomposing));
    must(stltsa_decompose(clip, options, &d));
    assert_int_equal(decomposing.stage, STLTSA_STAGE_UNITS);
    assert_true(decomposing.fraction == 1 && decomposing.calls > 10);
    stltsa_decomposition_free(d);
    must(stltsa_options_set_int(options, STLTSA_OPT_INTRINSIC, 1));
    for (int32_t mode = STLTSA_MODE_TEMPORAL; mode <= STLTSA_MODE_RECURRENT; ++mode) {
        struct way way = {0};
        must(stltsa_options_set_int(options, STLTSA_OPT_MODE, mode));
        must(stltsa_options_set_progress(options, only_forward, &way));
        fitted_clip(clip, options);
        assert_int_equal(way.stage, STLTSA_STAGE_SPECTRUM);
        assert_true(way.fraction == 1 && way.calls > 10);
    }
    stltsa_options_free(options);
}

static int32_t stop_in_search(void* user, int32_t stage, double fraction) {
    (void)user;
    return stage == STLTSA_STAGE_NEIGHBORS && fraction < 0.5; /* the fit has the second half */
}

/* The longest loop before the fit. A decomposition has one stage for all. */
TEST(the_search_for_the_period_can_be_cancelled) {
    stltsa_clip* clip = opened();
    const stltsa_clip* const clips[] = {clip};
    stltsa_options* options = with_progress(stop_in_search, NULL);
    stltsa_model* model = NULL;
    assert_int_equal(stltsa_fit_clips(clips, 1, options, &model), STLTSA_E_CANCELLED);
}

TEST(wrong_arguments) {
    stltsa_clip* clip = opened();
    stltsa_decomposition* d = decomposed(clip, NULL);
    stltsa_decomposition* none = d;
    assert_int_equal(stltsa_decompose(NULL, NULL, &none), STLTSA_E_ARGUMENT);
    assert_null(none);
    assert_int_equal(stltsa_decompose(clip, NULL, NULL), STLTSA_E_ARGUMENT);
    stltsa_decomposition_free(NULL);
}

/* Options that leave nothing to decompose: the text says which. */
TEST(options_that_leave_nothing) {
    stltsa_clip* clip = opened();
    stltsa_decomposition* d = NULL;
    stltsa_options* options = with(STLTSA_OPT_PERIOD_MIN, 3);
    must(stltsa_options_set_real(options, STLTSA_OPT_PERIOD_MAX, 1));
    must_fail(stltsa_decompose(clip, options, &d), STLTSA_E_ARGUMENT, "period_min is 3 s");

    stltsa_clip* fast = NULL;
    must(stltsa_clip_open(walker_path, with(STLTSA_OPT_FPS, 100000), &fast));
    must_fail(stltsa_decompose(fast, NULL, &d), STLTSA_E_TOO_FEW_FRAMES,
              "at 100000 a second one in 844 is kept");
    stltsa_clip_free(fast);
}

/* At a low frame rate a rest may be shorter than a frame. */
TEST(no_unit_is_empty) {
    enum { rows = 60 };
    uint64_t random = 1;
    for (int round = 0; round < 50; ++round) {
        double x[rows] = {0};
        for (int i = 1; i < rows; ++i)
            x[i] = x[i - 1] + (uniform(&random) - 0.5);
        stltsa_clip* clip = matrix_clip(x, rows, 1, 3);
        stltsa_decomposition* d = decomposed(clip, NULL);
        const int64_t units = count_of(d, STLTSA_INFO_UNIT);
        for (int64_t i = 0; i < units; ++i) {
            const stltsa_unit u = unit_at(d, i);
            assert_true(u.begin < u.end && u.begin_s < u.end_s);
            assert_int_equal(u.begin, i == 0 ? 0 : unit_at(d, i - 1).end);
            if (i > 0) {
                assert_true(u.begin_s == unit_at(d, i - 1).end_s);
                assert_true(u.kind != unit_at(d, i - 1).kind ||
                            u.segment != unit_at(d, i - 1).segment);
            }
        }
        assert_int_equal(unit_at(d, units - 1).end, rows);
    }
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(five_units_in_order),
        cmocka_unit_test(three_cycles_back_to_back),
        cmocka_unit_test(postures_differ),
        cmocka_unit_test(the_first_coordinate_is_the_curve),
        cmocka_unit_test(coordinates_of_a_clip_at_rest_are_zero),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(shift_and_order_of_channels_change_no_unit),
        cmocka_unit_test(noise_has_no_cycle_but_a_reason),
        cmocka_unit_test(one_blow_along_a_line),
        cmocka_unit_test(a_cut_is_no_standing),
        cmocka_unit_test(cancelled_at_every_call),
        cmocka_unit_test(progress_never_goes_back),
        cmocka_unit_test(the_search_for_the_period_can_be_cancelled),
        cmocka_unit_test(wrong_arguments),
        cmocka_unit_test(options_that_leave_nothing),
        cmocka_unit_test(no_unit_is_empty),
    };
    return run_on_walker(tests, argc, argv);
}
