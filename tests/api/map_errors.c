/* SPDX-License-Identifier: BSD-3-Clause */
/* Mapping: bad input is found before any work and leaves the arrays unchanged; models with several
 * components, models without frames. */
#include "support.h"

enum { rows = 200, cols = 6, untouched = -77 };

struct fixture {
    double* x;
    stltsa_model* model; /* two coordinates */
    stltsa_options* options;
    double y[2 * rows], frames[rows * cols], distance[rows];
    int64_t nearest[rows];
};

static int set_up(void** state) {
    struct fixture* f = calloc(1, sizeof *f);
    f->x = new_motion(rows, cols, 41);
    f->options = new_options(20, 20, 2);
    const stltsa_in in = packed_in(f->x, rows, cols);
    must(stltsa_fit(&in, NULL, f->options, &f->model));
    for (int i = 0; i < rows * cols; ++i)
        f->frames[i] = f->y[i % (2 * rows)] = f->distance[i % rows] = untouched;
    for (int i = 0; i < rows; ++i)
        f->nearest[i] = untouched;
    *state = f;
    return 0;
}

static int tear_down(void** state) {
    struct fixture* f = *state;
    stltsa_model_free(f->model);
    free(f);
    return 0;
}

static void assert_untouched(const struct fixture* f) {
    for (int i = 0; i < rows * cols; ++i)
        assert_true(f->frames[i] == untouched && f->y[i % (2 * rows)] == untouched &&
                    f->distance[i % rows] == untouched && f->nearest[i % rows] == untouched);
}

static void assert_status(stltsa_status got, stltsa_status expected, const char* words) {
    if (got != expected)
        print_error("got %s: %s\n", stltsa_status_name(got), stltsa_last_error());
    assert_int_equal(got, expected);
    if (strstr(stltsa_last_error(), words) == NULL)
        print_error("no \"%s\" in: %s\n", words, stltsa_last_error());
    assert_non_null(strstr(stltsa_last_error(), words));
}

/* Maps the first `count` rows of `width` columns. */
static stltsa_status map(struct fixture* f, const double* x, int64_t count, int64_t width,
                         const int64_t* hints) {
    const stltsa_in in = packed_in(x, count, width);
    const stltsa_out out = packed_out(f->y, count, 2);
    const stltsa_out far = packed_out(f->distance, count, 1);
    const stltsa_in near = list_in(hints, count);
    const stltsa_out found = list_out(f->nearest, count);
    return stltsa_map(f->model, &in, hints == NULL ? NULL : &near, f->options, &out, &far, &found);
}

static stltsa_status unmap(struct fixture* f, const double* y, int64_t count, int64_t width,
                           const int64_t* hints) {
    const stltsa_in in = packed_in(y, count, width);
    const stltsa_out out = packed_out(f->frames, count, cols);
    const stltsa_out far = packed_out(f->distance, count, 1);
    const stltsa_in near = list_in(hints, count);
    const stltsa_out found = list_out(f->nearest, count);
    return stltsa_unmap(f->model, &in, hints == NULL ? NULL : &near, f->options, &out, &far,
                        &found);
}

static void null_is_named(void** state) {
    struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    const stltsa_in points = packed_in(f->x, rows, 2);
    const stltsa_out y = packed_out(f->y, rows, 2);
    const stltsa_out frames = packed_out(f->frames, rows, cols);
    stltsa_clip* poses = NULL;
    assert_status(stltsa_map(NULL, &in, NULL, NULL, &y, NULL, NULL), STLTSA_E_ARGUMENT, "model");
    assert_status(stltsa_map(f->model, NULL, NULL, NULL, &y, NULL, NULL), STLTSA_E_ARGUMENT,
                  "frames");
    assert_status(stltsa_map(f->model, &in, NULL, NULL, NULL, NULL, NULL), STLTSA_E_ARGUMENT,
                  "coords");
    assert_status(stltsa_unmap(NULL, &points, NULL, NULL, &frames, NULL, NULL), STLTSA_E_ARGUMENT,
                  "model");
    assert_status(stltsa_unmap(f->model, NULL, NULL, NULL, &frames, NULL, NULL), STLTSA_E_ARGUMENT,
                  "coords");
    assert_status(stltsa_unmap(f->model, &points, NULL, NULL, NULL, NULL, NULL), STLTSA_E_ARGUMENT,
                  "frames");
    assert_status(stltsa_map_clip(f->model, NULL, NULL, &y, NULL, NULL), STLTSA_E_ARGUMENT, "clip");
    assert_status(stltsa_unmap_clip(f->model, &points, NULL, NULL, NULL, NULL, NULL),
                  STLTSA_E_ARGUMENT, "poses");
    assert_status(stltsa_unmap_clip(NULL, &points, NULL, NULL, NULL, NULL, &poses),
                  STLTSA_E_ARGUMENT, "model");
    assert_untouched(f);
}

static void shapes_must_fit(void** state) {
    struct fixture* f = *state;
    assert_status(map(f, f->x, rows, cols - 1, NULL), STLTSA_E_SHAPE, "6 features");
    assert_status(unmap(f, f->x, rows, 3, NULL), STLTSA_E_SHAPE, "2 coordinates");
    const stltsa_in in = packed_in(f->x, rows, cols);
    const stltsa_out good = packed_out(f->y, rows, 2);
    const stltsa_out bad[] = {packed_out(f->y, rows, 1), packed_out(f->y, rows - 1, 2)};
    for (int b = 0; b < 2; ++b) {
        assert_status(stltsa_map(f->model, &in, NULL, NULL, &bad[b], NULL, NULL), STLTSA_E_SHAPE,
                      "coords");
        assert_status(stltsa_map(f->model, &in, NULL, NULL, &good, &bad[1], NULL), STLTSA_E_SHAPE,
                      "distance");
    }
    assert_untouched(f);
}

static void numbers_must_be_finite(void** state) {
    struct fixture* f = *state;
    f->x[17 * cols + 1] = NAN;
    assert_status(map(f, f->x, rows, cols, NULL), STLTSA_E_NOT_FINITE,
                  "frames: row 17, column 1 is NaN");
    double points[6] = {0, 0, 0, INFINITY, 0, 0};
    assert_status(unmap(f, points, 3, 2, NULL), STLTSA_E_NOT_FINITE,
                  "coords: row 1, column 1 is infinite");
    assert_untouched(f);
}

static void hints_are_rows(void** state) {
    struct fixture* f = *state;
    const int64_t bad[][2] = {{0, rows}, {0, -2}, {INT64_MAX, 0}, {INT64_MIN, 0}};
    for (int b = 0; b < 4; ++b) {
        assert_status(map(f, f->x, 2, cols, bad[b]), STLTSA_E_ARGUMENT, "hint");
        assert_status(unmap(f, f->x, 2, 2, bad[b]), STLTSA_E_ARGUMENT, "hint");
    }
    assert_untouched(f);
}

/* One entry for each row, of integers; nothing is written if one of the lists does not fit. */
static void hints_and_nearest_fit_the_rows(void** state) {
    struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    const stltsa_out out = packed_out(f->y, rows, 2);
    const int64_t hint[rows] = {0};
    const double numbers[rows] = {0};
    stltsa_in wide = list_in(hint, rows);
    wide.cols = 2;
    const stltsa_in hints[] = {list_in(hint, rows - 1), list_in(hint, 0), wide,
                               packed_in(numbers, rows, 1), list_in(NULL, rows)};
    for (int h = 0; h < 5; ++h)
        assert_status(stltsa_map(f->model, &in, &hints[h], NULL, &out, NULL, NULL),
                      h < 3 ? STLTSA_E_SHAPE : STLTSA_E_ARGUMENT, "hints");
    stltsa_out overlapping = list_out(f->nearest, rows);
    overlapping.row_stride = 4;
    overlapping.col_stride = 8;
    const stltsa_out nearest[] = {list_out(f->nearest, rows - 1), overlapping,
                                  packed_out(f->distance, rows, 1), list_out(NULL, rows)};
    for (int n = 0; n < 4; ++n)
        assert_status(stltsa_map(f->model, &in, NULL, NULL, &out, NULL, &nearest[n]),
                      n < 2 ? STLTSA_E_SHAPE : STLTSA_E_ARGUMENT, "nearest");
    const stltsa_out integers = list_out(f->nearest, rows);
    assert_status(stltsa_map(f->model, &in, NULL, NULL, &out, &integers, NULL), STLTSA_E_ARGUMENT,
                  "distance");
    assert_untouched(f);
}

static void lists_take_negative_strides(void** state) {
    struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    const stltsa_out out = packed_out(f->y, rows, 2);
    int64_t hint[rows];
    for (int i = 0; i < rows; ++i)
        hint[rows - 1 - i] = i;
    must(stltsa_options_set_int(f->options, STLTSA_OPT_HINT_WINDOW, 1));
    const stltsa_in hints = {hint + rows - 1, rows, 1, -8, 8, STLTSA_I64, 0};
    const stltsa_out nearest = {f->nearest + rows - 1, rows, 1, -8, 8, STLTSA_I64, 0};
    must(stltsa_map(f->model, &in, &hints, f->options, &out, NULL, &nearest));
    for (int i = 0; i < rows; ++i)
        assert_int_equal(f->nearest[rows - 1 - i], i);
}

static void no_rows_are_no_error(void** state) {
    struct fixture* f = *state;
    must(map(f, f->x, 0, cols, NULL));
    must(unmap(f, f->x, 0, 2, NULL));
    assert_untouched(f);
}

/* Numbers too large for finite distances are refused; smaller ones have finite distances. */
static void huge_numbers(void** state) {
    struct fixture* f = *state;
    double x[cols] = {0}, y[2] = {0};
    x[2] = 1e300;
    y[1] = -1e101;
    assert_status(map(f, x, 1, cols, NULL), STLTSA_E_NOT_FINITE, "frames: row 0, column 2");
    assert_status(unmap(f, y, 1, 2, NULL), STLTSA_E_NOT_FINITE, "coords: row 0, column 1");
    assert_untouched(f);
    x[2] = y[1] = 1e100;
    must(map(f, x, 1, cols, NULL));
    assert_true(isfinite(f->distance[0]) && isfinite(f->y[0]) && isfinite(f->y[1]));
    assert_true(f->distance[0] > 1e90);
    must(unmap(f, y, 1, 2, NULL));
    assert_true(isfinite(f->distance[0]) && f->distance[0] > 1e90);
}

/* Overlapping rows have room for only one. */
static void outputs_must_not_overlap(void** state) {
    struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    const int64_t strides[][2] = {{0, 8}, {16, 0}, {7, 1600}, {16, -7}};
    for (int s = 0; s < 4; ++s) {
        stltsa_out out = packed_out(f->y, rows, 2);
        out.row_stride = strides[s][0];
        out.col_stride = strides[s][1];
        assert_status(stltsa_map(f->model, &in, NULL, NULL, &out, NULL, NULL), STLTSA_E_SHAPE,
                      "overlap");
    }
    assert_untouched(f);
    stltsa_out one = packed_out(f->y, 1, 2); /* the stride of a single row is ignored */
    one.col_stride = 8;
    const stltsa_in first = packed_in(f->x, 1, cols);
    must(stltsa_map(f->model, &first, NULL, NULL, &one, NULL, NULL));
}

static void model_without_frames_cannot_map(void** state) {
    struct fixture* f = *state;
    stltsa_model_free(f->model);
    must(stltsa_options_set_int(f->options, STLTSA_OPT_KEEP_FRAMES, 0));
    const stltsa_in in = packed_in(f->x, rows, cols);
    must(stltsa_fit(&in, NULL, f->options, &f->model));
    assert_true(real_of(f->model, STLTSA_INFO_REACH) == 0);
    assert_status(map(f, f->x, rows, cols, NULL), STLTSA_E_UNSUPPORTED, "keep_frames");
    assert_status(unmap(f, f->x, rows, 2, NULL), STLTSA_E_UNSUPPORTED, "keep_frames");
    assert_untouched(f);
}

static void components_do_not_mix(void** state) {
    struct fixture* f = *state;
    stltsa_model_free(f->model);
    const stltsa_in in = packed_in(f->x, rows, cols);
    const int64_t lengths[] = {80, 120};
    const stltsa_in clips = list_in(lengths, 2);
    must(stltsa_fit(&in, &clips, f->options, &f->model));
    assert_int_equal(count_of(f->model, STLTSA_INFO_COMPONENT), 2);
    double* coords = array_of(f->model, STLTSA_INFO_COORDS);
    assert_status(unmap(f, coords, 1, 2, NULL), STLTSA_E_DISCONNECTED, "component");
    must(stltsa_options_set_int(f->options, STLTSA_OPT_COMPONENT, 2));
    assert_status(unmap(f, coords, 1, 2, NULL), STLTSA_E_ARGUMENT, "component");
    assert_untouched(f);

    must(map(f, f->x, rows, cols, NULL)); /* mapping ignores this option */
    assert_same_bits(f->y, coords, 2 * rows);
    for (int component = 0; component < 2; ++component) {
        must(stltsa_options_set_int(f->options, STLTSA_OPT_COMPONENT, component));
        must(unmap(f, coords, rows, 2, NULL));
        for (int64_t i = 0; i < rows; ++i)
            assert_true((f->nearest[i] >= 80) == (component == 1));
        const int64_t begin = component == 0 ? 0 : 80;
        assert_same_bits(f->frames + begin * cols, f->x + begin * cols, lengths[component] * cols);
    }
    const int64_t hint = 10;
    assert_status(unmap(f, coords, 1, 2, &hint), STLTSA_E_ARGUMENT, "hint");
    /* Two frames that are the last of one and the first of the other: each blend stays on its side,
     * so that the map of what lies between is one or the other's, never a mean. */
    double between[cols];
    for (int64_t c = 0; c < cols; ++c)
        between[c] = 0.5 * (f->x[79 * cols + c] + f->x[80 * cols + c]);
    must(map(f, between, 1, cols, NULL));
    const double* beside = coords + 2 * (f->nearest[0] < 80 ? 79 : 80);
    assert_below(largest_difference(f->y, beside, 2), 0.05, "distance from the row beside");
}

static int32_t stop_in_map(void* calls, int32_t stage, double fraction) {
    assert_int_equal(stage, STLTSA_STAGE_MAP);
    assert_true(fraction >= 0 && fraction <= 1);
    return ++*(int*)calls >= 2;
}

static void progress_cancels(void** state) {
    struct fixture* f = *state;
    for (int64_t threads = 1; threads <= 2; ++threads) {
        int calls = 0;
        must(stltsa_options_set_int(f->options, STLTSA_OPT_THREADS, threads));
        must(stltsa_options_set_progress(f->options, stop_in_map, &calls));
        const stltsa_status status = map(f, f->x, rows, cols, NULL);
        if (threads == 1) {
            assert_status(status, STLTSA_E_CANCELLED, "cancelled");
            assert_int_equal(calls, 2);
            assert_untouched(f);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(null_is_named, set_up, tear_down),
        cmocka_unit_test_setup_teardown(shapes_must_fit, set_up, tear_down),
        cmocka_unit_test_setup_teardown(numbers_must_be_finite, set_up, tear_down),
        cmocka_unit_test_setup_teardown(hints_are_rows, set_up, tear_down),
        cmocka_unit_test_setup_teardown(hints_and_nearest_fit_the_rows, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lists_take_negative_strides, set_up, tear_down),
        cmocka_unit_test_setup_teardown(no_rows_are_no_error, set_up, tear_down),
        cmocka_unit_test_setup_teardown(huge_numbers, set_up, tear_down),
        cmocka_unit_test_setup_teardown(outputs_must_not_overlap, set_up, tear_down),
        cmocka_unit_test_setup_teardown(model_without_frames_cannot_map, set_up, tear_down),
        cmocka_unit_test_setup_teardown(components_do_not_mix, set_up, tear_down),
        cmocka_unit_test_setup_teardown(progress_cancels, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
