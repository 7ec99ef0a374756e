/* SPDX-License-Identifier: BSD-3-Clause */
/* A model is the same after writing and reading; bytes that are not a model are refused. */
#include "support.h"

enum { rows = 90, cols = 7, d = 2 };

struct fixture {
    double* x;
    stltsa_model* model;
    unsigned char* bytes;
    size_t size;
};

static int set_up(void** state) {
    struct fixture* f = calloc(1, sizeof *f);
    f->x = new_motion(rows, cols, 5);
    stltsa_options* options = new_options(12, 14, d);
    must(stltsa_options_set_real(options, STLTSA_OPT_FPS, 30));
    const stltsa_in in = packed_in(f->x, rows, cols);
    const int64_t lengths[2] = {50, 40};
    const stltsa_in clips = list_in(lengths, 2);
    must(stltsa_fit(&in, &clips, options, &f->model));
    must(stltsa_model_serialize(f->model, &f->bytes, &f->size));
    *state = f;
    return 0;
}

static int tear_down(void** state) {
    struct fixture* f = *state;
    stltsa_free(f->bytes);
    stltsa_model_free(f->model);
    free(f);
    return 0;
}

static void assert_same_model(const stltsa_model* a, const stltsa_model* b) {
    char *text_a = json_of(a), *text_b = json_of(b);
    assert_string_equal(text_a, text_b);
    const size_t count = (size_t)(int_of(a, STLTSA_INFO_ROWS) * d);
    double* coords_a = array_of(a, STLTSA_INFO_COORDS);
    double* coords_b = array_of(b, STLTSA_INFO_COORDS);
    assert_memory_equal(coords_a, coords_b, count * sizeof *coords_a);
}

/* Maps the fitted frames, slightly moved, and back. */
static double* new_round_trip(const stltsa_model* model, const double* x) {
    double* moved = copy_of(x, rows * cols);
    for (int i = 0; i < rows * cols; ++i)
        moved[i] += 1e-3 * (double)(i % 5);
    double* result = new_matrix(rows, d + cols);
    const stltsa_in frames = packed_in(moved, rows, cols);
    stltsa_out coords = packed_out(result, rows, d);
    coords.row_stride = (d + cols) * (int64_t)sizeof(double);
    coords.col_stride = (int64_t)sizeof(double);
    must(stltsa_map(model, &frames, NULL, NULL, &coords, NULL, NULL));
    stltsa_options* options = with_int(STLTSA_OPT_COMPONENT, 1);
    const stltsa_in points = {result, rows, d, coords.row_stride, coords.col_stride, STLTSA_F64, 0};
    stltsa_out back = coords;
    back.data = result + d;
    back.cols = cols;
    must(stltsa_unmap(model, &points, NULL, options, &back, NULL, NULL));
    return result;
}

static void what_was_written_reads_back(void** state) {
    const struct fixture* f = *state;
    stltsa_model* again = NULL;
    must(stltsa_model_parse(f->bytes, f->size, &again));
    assert_same_model(f->model, again);
    assert_int_equal(count_of(again, STLTSA_INFO_COMPONENT), 2);
    unsigned char* bytes = NULL;
    size_t size = 0;
    must(stltsa_model_serialize(again, &bytes, &size));
    assert_int_equal(size, f->size);
    assert_memory_equal(bytes, f->bytes, size);
    stltsa_free(bytes);
    stltsa_model_free(again);
}

static void maps_as_before(void** state) {
    const struct fixture* f = *state;
    stltsa_model* again = NULL;
    must(stltsa_model_parse(f->bytes, f->size, &again));
    double* before = new_round_trip(f->model, f->x);
    double* after = new_round_trip(again, f->x);
    assert_memory_equal(before, after, (size_t)(rows * (d + cols)) * sizeof *before);
    assert_true(real_of(f->model, STLTSA_INFO_REACH) > 0);
    assert_true(real_of(f->model, STLTSA_INFO_REACH) == real_of(again, STLTSA_INFO_REACH));
    stltsa_model_free(again);
}

static void assert_file_holds(const stltsa_model* model, const unsigned char* expected,
                              size_t size) {
    const char* path = "unit-model-file.stltsa"; /* in the folder of the test run */
    must(stltsa_model_save(model, path, NULL));
    stltsa_model* again = NULL;
    must(stltsa_model_load(path, NULL, &again));
    assert_same_model(model, again);
    stltsa_model_free(again);
    FILE* file = fopen(path, "rb");
    unsigned char* bytes = malloc(size + 1);
    assert_int_equal(fread(bytes, 1, size + 1, file), size);
    assert_memory_equal(bytes, expected, size);
    free(bytes);
    fclose(file);
    remove(path);
}

static void files_hold_the_bytes(void** state) {
    const struct fixture* f = *state;
    assert_file_holds(f->model, f->bytes, f->size);
}

/* Files are written in pieces. */
TEST(long_files_hold_the_bytes) {
    enum { many = 5000 };
    double* x = new_motion(many, cols, 5);
    stltsa_options* options = new_options(12, 14, d);
    const stltsa_in in = packed_in(x, many, cols);
    stltsa_model* model = NULL;
    must(stltsa_fit(&in, NULL, options, &model));
    unsigned char* bytes = NULL;
    size_t size = 0;
    must(stltsa_model_serialize(model, &bytes, &size));
    assert_true(size > sizeof(double) * many * (cols + d));
    assert_file_holds(model, bytes, size);
    stltsa_free(bytes);
    stltsa_model_free(model);
}

static void assert_no_model(const unsigned char* bytes, size_t size) {
    stltsa_model* model = (stltsa_model*)&model;
    assert_int_equal(stltsa_model_parse(bytes, size, &model), STLTSA_E_FORMAT);
    assert_null(model);
    assert_true(strlen(stltsa_last_error()) > 10);
}

static void every_cut_is_noticed(void** state) {
    const struct fixture* f = *state;
    for (size_t size = 0; size < f->size; ++size) {
        /* A copy of the exact size, so that the sanitizers see any read beyond it. */
        unsigned char* cut = malloc(size + (size == 0));
        memcpy(cut, f->bytes, size);
        assert_no_model(cut, size);
        free(cut);
    }
    unsigned char* longer = calloc(f->size + 1, 1);
    memcpy(longer, f->bytes, f->size);
    assert_no_model(longer, f->size + 1);
    free(longer);
}

static void every_altered_byte_is_noticed(void** state) {
    const struct fixture* f = *state;
    unsigned char* altered = malloc(f->size);
    memcpy(altered, f->bytes, f->size);
    for (size_t at = 0; at < f->size; ++at) {
        altered[at] ^= 0x01;
        assert_no_model(altered, f->size);
        altered[at] ^= 0x81;
        assert_no_model(altered, f->size);
        altered[at] ^= 0x80;
    }
    assert_memory_equal(altered, f->bytes, f->size);
    free(altered);
}

static stltsa_status save_and_load(void* model, const stltsa_options* options) {
    const char* path = "cancelled.stltsa";
    stltsa_model* again = NULL;
    stltsa_status status = stltsa_model_save(model, path, options);
    if (status == STLTSA_OK) {
        status = stltsa_model_load(path, options, &again);
        assert_true((again == NULL) == (status != STLTSA_OK));
        assert_int_equal(remove(path), 0);
    }
    assert_int_equal(remove(path), -1);
    stltsa_model_free(again);
    return status;
}

static void files_can_be_cancelled(void** state) {
    const struct fixture* f = *state;
    assert_in_range(cancelled_calls(save_and_load, f->model), 2, 1000);
}

static void errors_say_what_is_wrong(void** state) {
    const struct fixture* f = *state;
    stltsa_model* model = NULL;
    unsigned char* bytes = NULL;
    size_t size = 0;
    assert_int_equal(stltsa_model_serialize(NULL, &bytes, &size), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_model_serialize(f->model, NULL, &size), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_model_serialize(f->model, &bytes, NULL), STLTSA_E_ARGUMENT);
    assert_null(bytes);
    assert_int_equal(stltsa_model_parse(NULL, 10, &model), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_model_parse(NULL, 0, &model), STLTSA_E_FORMAT);
    assert_int_equal(stltsa_model_parse(f->bytes, f->size, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_model_save(f->model, NULL, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_model_save(NULL, "x.stltsa", NULL), STLTSA_E_ARGUMENT);
    must_fail(stltsa_model_save(f->model, "", NULL), STLTSA_E_IO, "the path is empty");
    must_fail(stltsa_model_save(f->model, "no/such/folder/x.stltsa", NULL), STLTSA_E_IO,
              "no/such/folder/x.stltsa");
    assert_int_equal(stltsa_model_load(NULL, NULL, &model), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_model_load("no-such.stltsa", NULL, NULL), STLTSA_E_ARGUMENT);
    must_fail(stltsa_model_load("", NULL, &model), STLTSA_E_IO, "the path is empty");
    must_fail(stltsa_model_load("no-such.stltsa", NULL, &model), STLTSA_E_IO, "no-such.stltsa");
    unsigned char later[32];
    memcpy(later, f->bytes, sizeof later);
    later[8] = 6;
    must_fail(stltsa_model_parse(later, sizeof later, &model), STLTSA_E_FORMAT, "version 6");
    must_fail(stltsa_model_parse("HIERARCHY", 9, &model), STLTSA_E_FORMAT, "not a model");
    stltsa_free(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_written_reads_back),
        cmocka_unit_test(maps_as_before),
        cmocka_unit_test(files_hold_the_bytes),
        cmocka_unit_test(files_can_be_cancelled),
        cmocka_unit_test(every_cut_is_noticed),
        cmocka_unit_test(long_files_hold_the_bytes),
        cmocka_unit_test(every_altered_byte_is_noticed),
        cmocka_unit_test(errors_say_what_is_wrong),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
