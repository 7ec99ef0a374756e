/* SPDX-License-Identifier: BSD-3-Clause */
/* Bad input is found before any work, described in the text, and leaves nothing half done. */
#include "support.h"

enum { rows = 100, cols = 6 };

struct fixture {
    double* x;
    stltsa_options* options;
};

static int set_up(void** state) {
    struct fixture* f = calloc(1, sizeof *f);
    f->x = new_motion(rows, cols, 71);
    f->options = new_options(12, 12, 2);
    *state = f;
    return 0;
}

static int tear_down(void** state) {
    struct fixture* f = *state;
    free(f);
    return 0;
}

/* The fit must fail with `status`, say `words` (NULL: whatever), and give no handle. */
static void assert_fails(const stltsa_in* in, const stltsa_in* lengths,
                         const stltsa_options* options, stltsa_status status, const char* words) {
    int some_memory = 0;
    stltsa_model* model = (stltsa_model*)(void*)&some_memory;
    const stltsa_status got = stltsa_fit(in, lengths, options, &model);
    if (got != status)
        print_error("got %s: %s\n", stltsa_status_name(got), stltsa_last_error());
    assert_int_equal(got, status);
    assert_null(model);
    assert_true(strlen(stltsa_last_error()) > 10);
    if (words != NULL && strstr(stltsa_last_error(), words) == NULL)
        print_error("no \"%s\" in: %s\n", words, stltsa_last_error());
    assert_true(words == NULL || strstr(stltsa_last_error(), words) != NULL);
}

static void nan_is_named_with_frame_and_channel(void** state) {
    const struct fixture* f = *state;
    const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int b = 0; b < 3; ++b) {
        double* x = copy_of(f->x, rows * cols);
        x[87 * cols + 4] = bad[b];
        x[95 * cols + 1] = bad[b];
        const stltsa_in in = packed_in(x, rows, cols);
        assert_fails(&in, NULL, f->options, STLTSA_E_NOT_FINITE, "87");
        assert_non_null(strstr(stltsa_last_error(), "4"));
    }
}

/* Regardless of the number of threads. */
static void the_first_nan_of_a_long_matrix_is_named(void** state) {
    enum { many = 300000 };
    const struct fixture* f = *state;
    double* x = calloc((size_t)many * cols, sizeof *x);
    assert_non_null(x);
    x[184319 * cols + 4] = NAN; /* the last of what one thread takes: the next comes upon */
    x[184320 * cols + 2] = NAN; /* its own before this one is found */
    x[299999 * cols] = NAN;
    const stltsa_in in = packed_in(x, many, cols);
    for (int threads = 1; threads <= 4; ++threads) {
        assert_int_equal(stltsa_options_set_int(f->options, STLTSA_OPT_THREADS, threads),
                         STLTSA_OK);
        assert_fails(&in, NULL, f->options, STLTSA_E_NOT_FINITE, "row 184319, column 4 is NaN");
    }
    free(x);
}

static void nan_in_float32_and_in_the_last_entry(void** state) {
    const struct fixture* f = *state;
    float x[rows * cols];
    for (int i = 0; i < rows * cols; ++i)
        x[i] = (float)f->x[i];
    x[rows * cols - 1] = NAN;
    const stltsa_in in = {x, rows, cols, 0, 0, STLTSA_F32, 0};
    assert_fails(&in, NULL, f->options, STLTSA_E_NOT_FINITE, "99");
}

static void numbers_too_large_to_square(void** state) {
    const struct fixture* f = *state;
    double* x = copy_of(f->x, rows * cols);
    for (int i = 0; i < rows * cols; ++i)
        x[i] *= 1e200;
    const stltsa_in in = packed_in(x, rows, cols);
    assert_fails(&in, NULL, f->options, STLTSA_E_NOT_FINITE, "distances are infinite");
}

static void strides_that_reach_beyond_memory(void** state) {
    const struct fixture* f = *state;
    stltsa_in in = packed_in(f->x, rows, cols);
    in.row_stride = INT64_MAX;
    in.col_stride = sizeof(double);
    assert_fails(&in, NULL, f->options, STLTSA_E_SHAPE, "do not fit into memory");
}

static void assert_parameters_fail(const double* x, int64_t k, int64_t w, int64_t d) {
    stltsa_options* options = new_options(k, w, d);
    const stltsa_in in = packed_in(x, rows, cols);
    assert_fails(&in, NULL, options, STLTSA_E_ARGUMENT, NULL);
}

/* d + 2 <= k <= w + 1, both ends included. */
static void neighbors_fit_window_and_dimension(void** state) {
    const struct fixture* f = *state;
    assert_parameters_fail(f->x, 12, 10, 2);
    assert_parameters_fail(f->x, 12, 1, 2);
    assert_parameters_fail(f->x, 3, 12, 2);
    assert_parameters_fail(f->x, 4, 12, 3);
    const stltsa_in in = packed_in(f->x, rows, cols);
    const int64_t good[][3] = {{12, 11, 2}, {4, 3, 2}, {4, 12, 2}};
    for (int g = 0; g < 3; ++g) {
        stltsa_options* options = new_options(good[g][0], good[g][1], good[g][2]);
        stltsa_model* model = NULL;
        must(stltsa_fit(&in, NULL, options, &model));
        stltsa_model_free(model);
    }
}

static void too_few_frames(void** state) {
    const struct fixture* f = *state;
    for (int64_t n = 1; n <= 12; ++n) {
        const stltsa_in in = packed_in(f->x, n, cols);
        assert_fails(&in, NULL, f->options, STLTSA_E_TOO_FEW_FRAMES, NULL);
    }
    const stltsa_in in = packed_in(f->x, rows, cols);
    const int64_t lengths[] = {60, 10, 30};
    const stltsa_in clips = list_in(lengths, 3);
    assert_fails(&in, &clips, f->options, STLTSA_E_TOO_FEW_FRAMES, NULL);
}

static void lengths_must_sum_to_the_rows(void** state) {
    const struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    const int64_t less[] = {50, 49};
    const int64_t more[] = {50, 51};
    const int64_t negative[] = {150, -50};
    const int64_t wrapped[] = {INT64_MAX, INT64_MAX, rows + 2};
    const struct {
        stltsa_in lengths;
        const char* words;
    } bad[] = {
        {list_in(less, 2), "99"},
        {list_in(more, 2), "51"},
        {list_in(negative, 2), NULL},
        {list_in(wrapped, 3), NULL},
        {list_in(less, 0), "0 rows"},
        {list_in(less, -1), "-1 rows"},
        {list_in(less, rows + 1), "101 rows"},
    };
    for (size_t b = 0; b < sizeof bad / sizeof *bad; ++b)
        assert_fails(&in, &bad[b].lengths, f->options, STLTSA_E_SHAPE, bad[b].words);
}

static void lengths_are_a_column_of_integers(void** state) {
    const struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    const int64_t lengths[] = {50, 50};
    const double numbers[] = {50, 50};
    const stltsa_in reals = packed_in(numbers, 2, 1);
    assert_fails(&in, &reals, f->options, STLTSA_E_ARGUMENT, "STLTSA_I64");
    stltsa_in wide = list_in(lengths, 1);
    wide.cols = 2;
    assert_fails(&in, &wide, f->options, STLTSA_E_SHAPE, "one column");
    const stltsa_in nothing = list_in(NULL, 2);
    assert_fails(&in, &nothing, f->options, STLTSA_E_ARGUMENT, "lengths: data is NULL");
    stltsa_in reserved = list_in(lengths, 2);
    reserved.reserved = 1;
    assert_fails(&in, &reserved, f->options, STLTSA_E_ARGUMENT, "reserved");
}

/* From the last to the first, with gaps: 40 and 60 as 60 and 40. */
static void lengths_take_any_stride(void** state) {
    const struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    const int64_t lengths[] = {40, -1, 60};
    const stltsa_in backwards = {lengths + 2, 2,          1, -2 * (int64_t)sizeof *lengths,
                                 8,           STLTSA_I64, 0};
    stltsa_model* model = NULL;
    must(stltsa_fit(&in, &backwards, f->options, &model));
    int64_t* labels = whole_of(model, STLTSA_INFO_COMPONENT_OF);
    for (int i = 0; i < rows; ++i)
        assert_int_equal(labels[i], i >= 60);
    stltsa_model_free(model);
}

static void null_is_refused(void** state) {
    const struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    const stltsa_in no_data = packed_in(NULL, rows, cols);
    assert_fails(NULL, NULL, f->options, STLTSA_E_ARGUMENT, NULL);
    assert_fails(&no_data, NULL, f->options, STLTSA_E_ARGUMENT, NULL);
    assert_int_equal(stltsa_fit(&in, NULL, f->options, NULL), STLTSA_E_ARGUMENT);
    stltsa_model_free(NULL);
    stltsa_options_free(NULL);
    stltsa_clip_free(NULL);
    stltsa_decomposition_free(NULL);
    stltsa_free(NULL);
}

static void shapes_that_are_none(void** state) {
    const struct fixture* f = *state;
    const int64_t bad[][2] = {{0, cols}, {rows, 0}, {-1, cols}, {rows, -1}};
    for (int b = 0; b < 4; ++b) {
        const stltsa_in in = packed_in(f->x, bad[b][0], bad[b][1]);
        stltsa_model* model = NULL;
        assert_true(stltsa_fit(&in, NULL, f->options, &model) < 0);
        assert_null(model);
    }
    stltsa_in in = packed_in(f->x, rows, cols);
    in.dtype = STLTSA_I64; /* of integers are only lists */
    assert_fails(&in, NULL, f->options, STLTSA_E_ARGUMENT, NULL);
}

/* Refused because of the sizes alone: these arrays must not be read. */
static void sizes_that_overflow(void** state) {
    const struct fixture* f = *state;
    const int64_t huge[][2] = {
        {INT64_MAX, 2}, {INT64_MAX / 4, 8}, {INT64_C(1) << 32, INT64_C(1) << 32}, {3, INT64_MAX}};
    for (int h = 0; h < 4; ++h) {
        const stltsa_in in = packed_in(f->x, huge[h][0], huge[h][1]);
        assert_fails(&in, NULL, f->options, STLTSA_E_NO_MEMORY, NULL);
    }
}

TEST(options_out_of_range) {
    stltsa_options* options = empty_options();
    assert_int_equal(stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, 0), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_int(options, STLTSA_OPT_DIMENSION, -1), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_int(options, STLTSA_OPT_MODE, 9), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_int(options, STLTSA_OPT_FPS, 30), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_real(options, STLTSA_OPT_FPS, NAN), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_int(options, 9999, 1), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_int(NULL, STLTSA_OPT_NEIGHBORS, 12), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_is_set(options, STLTSA_OPT_NEIGHBORS), 0);
}

struct countdown {
    int calls_left;
    int stages_seen[STLTSA_STAGE_UNITS + 1];
};

static int32_t count_down(void* user, int32_t stage, double fraction) {
    struct countdown* c = user;
    assert_in_range(stage, STLTSA_STAGE_READ, STLTSA_STAGE_UNITS);
    assert_true(fraction >= 0 && fraction <= 1);
    ++c->stages_seen[stage];
    return c->calls_left-- == 0;
}

/* Cancelled at the first call, the second, ... until a fit finishes: each time without a leak. */
static void cancelled_at_every_call(void** state) {
    const struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    stltsa_options* options = new_options(12, 12, 2);
    struct countdown c;
    int cancelled = 0;
    for (;; ++cancelled) {
        memset(&c, 0, sizeof c);
        c.calls_left = cancelled;
        must(stltsa_options_set_progress(options, count_down, &c));
        stltsa_model* model = NULL;
        const stltsa_status status = stltsa_fit(&in, NULL, options, &model);
        if (status == STLTSA_OK) {
            stltsa_model_free(model);
            break;
        }
        assert_int_equal(status, STLTSA_E_CANCELLED);
        assert_null(model);
        assert_true(cancelled < 10000);
    }
    assert_true(c.stages_seen[STLTSA_STAGE_TANGENTS] > 0);
    assert_true(c.stages_seen[STLTSA_STAGE_ALIGNMENT] > 0);
    assert_true(c.stages_seen[STLTSA_STAGE_SPECTRUM] > 0);
    assert_true(cancelled >= 4);
}

struct writer {
    double* x;
    int64_t count;
    int calls_left;
};

/* Simulates another thread: every number becomes NaN at one call. */
static int32_t write_nan(void* user, int32_t stage, double fraction) {
    struct writer* w = user;
    (void)stage;
    (void)fraction;
    if (w->calls_left-- == 0)
        for (int64_t i = 0; i < w->count; ++i)
            w->x[i] = NAN;
    return 0;
}

/* Frames become NaN at the first call of a fit, the second, ... until a fit has fewer calls. Each
 * time the fit notices, or no longer reads them. */
static void assert_survives_nan(int32_t mode, int64_t k) {
    enum { many = 1300 };
    double* x = new_motion(many, cols, 72);
    double* changing = new_matrix(many, cols);
    const stltsa_in in = packed_in(changing, many, cols);
    stltsa_options* options = new_options(k, k, 2);
    must(stltsa_options_set_int(options, STLTSA_OPT_MODE, mode));
    must(stltsa_options_set_int(options, STLTSA_OPT_THREADS, 1)); /* the same order of reads */
    struct writer w = {changing, many * cols, 0};
    int noticed = 0;
    for (int call = 0; w.calls_left <= 0; ++call) {
        memcpy(changing, x, (size_t)(many * cols) * sizeof *x);
        w.calls_left = call;
        must(stltsa_options_set_progress(options, write_nan, &w));
        stltsa_model* model = NULL;
        const stltsa_status status = stltsa_fit(&in, NULL, options, &model);
        assert_true(status == STLTSA_OK || status == STLTSA_E_NOT_FINITE);
        noticed += status == STLTSA_E_NOT_FINITE;
        stltsa_model_free(model);
    }
    assert_true(noticed > 0);
}

TEST(frames_that_become_nan_are_noticed) {
    assert_survives_nan(STLTSA_MODE_TEMPORAL, 6);
    assert_survives_nan(STLTSA_MODE_TEMPORAL, 12);
    assert_survives_nan(STLTSA_MODE_SPATIAL, 6);
    assert_survives_nan(STLTSA_MODE_SPATIAL, 12);
    assert_survives_nan(STLTSA_MODE_RECURRENT, 12);
}

/* Refused at once: such a fit would take far longer than this test may. */
TEST(more_dimensions_than_features_are_refused) {
    enum { many = 4000, narrow = 3 };
    double* x = new_motion(many, narrow, 73);
    const stltsa_in in = packed_in(x, many, narrow);
    stltsa_options* options = new_options(1002, 1002, 1000);
    assert_fails(&in, NULL, options, STLTSA_E_DEGENERATE, "features");
}

struct nested {
    stltsa_in in;
    const stltsa_options* options; /* of the fit within */
    stltsa_status status;
    int is_tried;
    char text[256];
};

static int32_t fit_within_spectrum(void* user, int32_t stage, double fraction) {
    struct nested* n = user;
    stltsa_model* model = NULL;
    (void)fraction;
    if (stage != STLTSA_STAGE_SPECTRUM || n->is_tried)
        return 0;
    n->is_tried = 1;
    n->status = stltsa_fit(&n->in, NULL, n->options, &model);
    snprintf(n->text, sizeof n->text, "%s", stltsa_last_error());
    stltsa_model_free(model);
    return 0;
}

/* ARPACK runs one problem at a time. A fit that would wait for the fit that called it is refused;
 * both work afterwards. */
static void a_fit_within_a_spectrum_is_refused(void** state) {
    const struct fixture* f = *state;
    struct nested n = {.in = packed_in(f->x, rows, cols), .options = f->options};
    stltsa_options* options = new_options(12, 12, 2);
    must(stltsa_options_set_progress(options, fit_within_spectrum, &n));
    stltsa_model* model = NULL;
    must(stltsa_fit(&n.in, NULL, options, &model));
    stltsa_model_free(model);
    assert_int_equal(n.status, STLTSA_E_ARGUMENT);
    assert_non_null(strstr(n.text, "progress callback"));
    must(stltsa_fit(&n.in, NULL, f->options, &model));
    stltsa_model_free(model);
}

/* Unlike temporal neighbors, neighbors among all frames are a separate stage, which can be
   cancelled. */
static void neighbors_of_all_frames_are_a_stage(void** state) {
    const struct fixture* f = *state;
    const stltsa_in in = packed_in(f->x, rows, cols);
    stltsa_options* options = new_options(12, 12, 2);
    must(stltsa_options_set_int(options, STLTSA_OPT_MODE, STLTSA_MODE_SPATIAL));
    struct countdown c = {.calls_left = -1};
    must(stltsa_options_set_progress(options, count_down, &c));
    stltsa_model* model = NULL;
    must(stltsa_fit(&in, NULL, options, &model));
    stltsa_model_free(model);
    assert_true(c.stages_seen[STLTSA_STAGE_NEIGHBORS] > 0);
    assert_true(c.stages_seen[STLTSA_STAGE_TANGENTS] > 0);
    c.calls_left = 0;
    assert_fails(&in, NULL, options, STLTSA_E_CANCELLED, NULL);
}

/* After a failure the same handles give the same result as before. */
static void handles_survive_a_failure(void** state) {
    const struct fixture* f = *state;
    double* want = fit_coords(f->x, rows, cols, 2);
    const stltsa_in short_clip = packed_in(f->x, 5, cols);
    assert_fails(&short_clip, NULL, f->options, STLTSA_E_TOO_FEW_FRAMES, NULL);
    stltsa_model* model = fitted_rows(f->x, rows, cols, f->options);
    double* got = array_of(model, STLTSA_INFO_COORDS);
    assert_same_bits(want, got, rows * 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nan_is_named_with_frame_and_channel),
        cmocka_unit_test(the_first_nan_of_a_long_matrix_is_named),
        cmocka_unit_test(nan_in_float32_and_in_the_last_entry),
        cmocka_unit_test(numbers_too_large_to_square),
        cmocka_unit_test(strides_that_reach_beyond_memory),
        cmocka_unit_test(neighbors_fit_window_and_dimension),
        cmocka_unit_test(too_few_frames),
        cmocka_unit_test(lengths_must_sum_to_the_rows),
        cmocka_unit_test(lengths_are_a_column_of_integers),
        cmocka_unit_test(lengths_take_any_stride),
        cmocka_unit_test(null_is_refused),
        cmocka_unit_test(shapes_that_are_none),
        cmocka_unit_test(sizes_that_overflow),
        cmocka_unit_test(options_out_of_range),
        cmocka_unit_test(cancelled_at_every_call),
        cmocka_unit_test(frames_that_become_nan_are_noticed),
        cmocka_unit_test(more_dimensions_than_features_are_refused),
        cmocka_unit_test(a_fit_within_a_spectrum_is_refused),
        cmocka_unit_test(neighbors_of_all_frames_are_a_stage),
        cmocka_unit_test(handles_survive_a_failure),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
