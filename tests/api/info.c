/* SPDX-License-Identifier: BSD-3-Clause */
/* Facts, rows, arrays and JSON of every kind of handle, by key, and the table of keys. */
#include "support.h"

/* One handle of each kind, all of the same walk. */
static stltsa_clip* clip;
static stltsa_model* model;
static stltsa_decomposition* found;
static stltsa_phase* phase;
static stltsa_cycles* cycles;
static stltsa_events* events;
static stltsa_comparison* comparison;
static stltsa_live* live;
static stltsa_denoising* denoising;
static stltsa_synthesis* synthesis;

enum { kinds = 10 };
static struct handle {
    const stltsa_info* info;
    int32_t handle;
    const char* schema; /* of its JSON; NULL: it has none */
} handles[kinds];

static int make_handles(void** state) {
    (void)state;
    clip = opened();
    stltsa_options* options = with_int(STLTSA_OPT_INTRINSIC, 1);
    model = fitted_clip(clip, options);
    found = decomposed(clip, NULL);
    phase = phase_of(clip, NULL);
    double* features = array_of(clip, STLTSA_INFO_POSITIONS);
    const double mark = 250;
    const stltsa_in signals = packed_in(features, stltsa_clip_frames(clip), 2),
                    marks = packed_in(&mark, 1, 1);
    must(stltsa_cycles_resample(phase, 0, &signals, 11, NULL, &cycles));
    must(stltsa_events_find(phase, &marks, NULL, NULL, &events));
    must(stltsa_compare_left_right(clip, phase, -1, 21, NULL, &comparison));
    must(stltsa_model_keep_cycle(model, phase, NULL));
    must(stltsa_model_keep_mark(model, phase, 250, "strike"));
    must(stltsa_live_new(model, &live));
    must(stltsa_denoise_model(model, NULL, &denoising));
    must(stltsa_synthesize_loop(clip, found, NULL, &synthesis));
    const struct handle all[kinds] = {
        {info_of(clip), STLTSA_HANDLE_CLIP, "stltsa-clip/1"},
        {info_of(model), STLTSA_HANDLE_MODEL, "stltsa-model/1"},
        {info_of(found), STLTSA_HANDLE_DECOMPOSITION, "stltsa-decomposition/2"},
        {info_of(phase), STLTSA_HANDLE_PHASE, NULL},
        {info_of(cycles), STLTSA_HANDLE_CYCLES, NULL},
        {info_of(events), STLTSA_HANDLE_EVENTS, NULL},
        {info_of(comparison), STLTSA_HANDLE_COMPARISON, "stltsa-comparison/1"},
        {info_of(live), STLTSA_HANDLE_LIVE, NULL},
        {info_of(denoising), STLTSA_HANDLE_DENOISING, "stltsa-denoising/1"},
        {info_of(synthesis), STLTSA_HANDLE_SYNTHESIS, "stltsa-synthesis/1"},
    };
    memcpy(handles, all, sizeof all);
    keep_cycles(cycles);
    keep_events(events);
    keep_comparison(comparison);
    keep_live(live);
    keep_denoising(denoising);
    keep_synthesis(synthesis);
    return 0;
}

/* ---- Facts ---- */

TEST(a_fact_is_read_by_its_key_and_type) {
    assert_int_equal(int_of(clip, STLTSA_INFO_CLIP_FRAMES), stltsa_clip_frames(clip));
    assert_true(real_of(clip, STLTSA_INFO_CLIP_FPS) == stltsa_clip_fps(clip));
    assert_string_equal(text_of(clip, STLTSA_INFO_PATH), walker_path);
    assert_int_equal(count_of(clip, STLTSA_INFO_CLIP_FRAMES), 1);
    assert_int_equal(count_of(clip, STLTSA_INFO_PHASE), 0);
    assert_int_equal(count_of(clip, 12345), 0);
    assert_int_equal(stltsa_info_count(NULL, STLTSA_INFO_PATH), 0);
}

TEST(what_is_not_there_is_refused_with_a_text) {
    const stltsa_info* info = stltsa_clip_info(clip);
    int64_t value = 77;
    double real = 77;
    const char* text = "as before";
    must_fail(stltsa_info_int(info, STLTSA_INFO_CLIP_FRAMES, 1, &value), STLTSA_E_ARGUMENT,
              "value 1 of info clip_frames does not exist: there are 1 here");
    assert_int_equal(stltsa_info_int(info, STLTSA_INFO_CLIP_FRAMES, -1, &value), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_real(info, STLTSA_INFO_LIKENESS, 0, &real), STLTSA_E_ARGUMENT);
    must_fail(stltsa_info_real(info, STLTSA_INFO_CLIP_FRAMES, 0, &real), STLTSA_E_ARGUMENT,
              "info clip_frames is not a real number");
    assert_int_equal(stltsa_info_text(info, STLTSA_INFO_CLIP_FRAMES, 0, &text), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_int(info, 12345, 0, &value), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_int(NULL, STLTSA_INFO_CLIP_FRAMES, 0, &value), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_int(info, STLTSA_INFO_CLIP_FRAMES, 0, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(value, 77);
    assert_true(real == 77);
    assert_string_equal(text, "as before");
}

TEST(handles_that_are_null_have_no_info) {
    assert_null(stltsa_clip_info(NULL));
    assert_null(stltsa_model_info(NULL));
    assert_null(stltsa_phase_info(NULL));
    assert_null(stltsa_decomposition_info(NULL));
    assert_null(stltsa_denoising_info(NULL));
    assert_null(stltsa_synthesis_info(NULL));
    assert_null(stltsa_cycles_info(NULL));
    assert_null(stltsa_events_info(NULL));
    assert_null(stltsa_comparison_info(NULL));
    assert_null(stltsa_live_info(NULL));
}

/* ---- The table of keys ---- */

TEST(keys_are_described) {
    enum { last = STLTSA_INFO_MARK };
    int seen[last + 1] = {0};
    stltsa_info_key row = {.size = sizeof row};
    int64_t count = 0;
    for (; stltsa_info_describe(count, &row) == STLTSA_OK; ++count) {
        assert_in_range(row.key, 1, last);
        assert_int_equal(seen[row.key]++, 0);
        assert_in_range(row.type, STLTSA_TYPE_INT, STLTSA_TYPE_ARRAY);
        assert_true(strlen(row.name) > 1);
        assert_true(strlen(row.text) > 3 && row.text[strlen(row.text) - 1] == '.');
        assert_true(row.handles > 0 && row.handles < 2 * STLTSA_HANDLE_LIVE);
        if (row.type == STLTSA_TYPE_ROWS)
            assert_int_equal(row.is_list, 1);
        if (row.key == STLTSA_INFO_NEIGHBORS) {
            assert_string_equal(row.name, "neighbors");
            assert_int_equal(row.type, STLTSA_TYPE_INT);
            assert_int_equal(row.is_list, 0);
            assert_int_equal(row.handles, STLTSA_HANDLE_MODEL | STLTSA_HANDLE_DECOMPOSITION |
                                              STLTSA_HANDLE_DENOISING);
        }
    }
    assert_in_range(count, 100, last);
    assert_int_equal(stltsa_info_describe(count, &row), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_describe(-1, &row), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_describe(0, NULL), STLTSA_E_ARGUMENT);
    row.size = 0;
    assert_int_equal(stltsa_info_describe(0, &row), STLTSA_E_ARGUMENT);
    /* A caller that knows less of the struct. */
    row.size = offsetof(stltsa_info_key, text);
    row.text = "kept";
    must(stltsa_info_describe(0, &row));
    assert_string_equal(row.text, "kept");
    assert_string_equal(row.name, "path");
}

/* How a key was read: a bit for each type. */
static int readable_types(const stltsa_info* info, int32_t key) {
    int64_t whole = 0, rows = 0, cols = 0;
    double real = 0;
    const char* text = NULL;
    char first[8];
    int types = 0;
    types |= (stltsa_info_int(info, key, 0, &whole) == STLTSA_OK) << STLTSA_TYPE_INT;
    types |= (stltsa_info_real(info, key, 0, &real) == STLTSA_OK) << STLTSA_TYPE_REAL;
    types |= (stltsa_info_text(info, key, 0, &text) == STLTSA_OK) << STLTSA_TYPE_TEXT;
    types |= (stltsa_info_rows(info, key, 0, 1, first, sizeof first) == STLTSA_OK)
             << STLTSA_TYPE_ROWS;
    types |= (stltsa_info_shape(info, key, &rows, &cols) == STLTSA_OK) << STLTSA_TYPE_ARRAY;
    return types;
}

/* Each key has the type that the table says, on those handles that it says, and no other. */
TEST(every_handle_has_what_the_table_says) {
    stltsa_info_key row = {.size = sizeof row};
    for (int64_t i = 0; stltsa_info_describe(i, &row) == STLTSA_OK; ++i) {
        int32_t having = 0;
        for (int h = 0; h < kinds; ++h) {
            const stltsa_info* info = handles[h].info;
            const int64_t count = stltsa_info_count(info, row.key);
            const int types = readable_types(info, row.key);
            if (types != (count > 0 ? 1 << row.type : 0))
                fail_msg("%s of handle %d: %d", row.name, handles[h].handle, types);
            if (!row.is_list && count > 1)
                fail_msg("%s of handle %d: %d values", row.name, handles[h].handle, (int)count);
            if (count > 0 && row.type == STLTSA_TYPE_ARRAY)
                get_array(info, row.key, count - 1);
            having |= count > 0 ? handles[h].handle : 0;
        }
        if ((having | row.handles) != row.handles)
            fail_msg("%s is of handles %d, not %d", row.name, having, row.handles);
    }
}

/* ---- Rows ---- */

/* Callers that know less of a struct, or more than this library. */
TEST(rows_have_the_size_of_the_caller) {
    const stltsa_info* info = stltsa_decomposition_info(found);
    const int64_t count = stltsa_info_count(info, STLTSA_INFO_SEGMENT);
    assert_in_range(count, 3, 9);
    stltsa_segment all[9];
    struct {
        int64_t kind, label;
    } fewer[9];
    struct {
        stltsa_segment known;
        int64_t later;
    } more[9];
    memset(fewer, 0xab, sizeof fewer);
    memset(more, 0xab, sizeof more);
    must(stltsa_info_rows(info, STLTSA_INFO_SEGMENT, 0, count, all, sizeof *all));
    must(stltsa_info_rows(info, STLTSA_INFO_SEGMENT, 0, count, fewer, sizeof *fewer));
    must(stltsa_info_rows(info, STLTSA_INFO_SEGMENT, 0, count, more, sizeof *more));
    for (int64_t i = 0; i < count; ++i) {
        assert_true(fewer[i].kind == all[i].kind && fewer[i].label == all[i].label);
        assert_memory_equal(&more[i].known, &all[i], sizeof *all);
        assert_int_equal(more[i].later, 0);
    }
    unsigned char* past = (unsigned char*)&fewer[count];
    for (size_t i = 0; i < sizeof fewer - (size_t)count * sizeof *fewer; ++i)
        assert_int_equal(past[i], 0xab);
}

TEST(rows_are_read_by_range) {
    const stltsa_info* info = stltsa_decomposition_info(found);
    const int32_t key = STLTSA_INFO_UNIT;
    const int64_t count = stltsa_info_count(info, key);
    assert_int_equal(count, 5);
    stltsa_unit all[5], some[2];
    must(stltsa_info_rows(info, key, 0, 5, all, sizeof *all));
    must(stltsa_info_rows(info, key, 3, 2, some, sizeof *some));
    assert_memory_equal(some, all + 3, sizeof some);
    must(stltsa_info_rows(info, key, 5, 0, NULL, sizeof *some));
    const int64_t ranges[][2] = {{-1, 1}, {0, -1}, {0, 6},         {5, 1},
                                 {6, 0},  {4, 2},  {1, INT64_MAX}, {INT64_MAX, INT64_MAX}};
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; ++i)
        must_fail(stltsa_info_rows(info, key, ranges[i][0], ranges[i][1], some, sizeof *some),
                  STLTSA_E_ARGUMENT, "there are 5 here");
    must_fail(stltsa_info_rows(info, key, 0, 1, NULL, sizeof *some), STLTSA_E_ARGUMENT, "rows");
    must_fail(stltsa_info_rows(info, key, 0, 1, some, 0), STLTSA_E_ARGUMENT, "row_size is 0");
    must_fail(stltsa_info_rows(NULL, key, 0, 1, some, sizeof *some), STLTSA_E_ARGUMENT, "info");
    must_fail(stltsa_info_rows(info, STLTSA_INFO_CURVE, 0, 1, some, sizeof *some),
              STLTSA_E_ARGUMENT, "info curve is not a list of rows");
    must_fail(stltsa_info_rows(info, STLTSA_INFO_SEAM, 0, 1, some, sizeof *some), STLTSA_E_ARGUMENT,
              "there is no seam here");
    must_fail(stltsa_info_rows(info, 12345, 0, 1, some, sizeof *some), STLTSA_E_ARGUMENT,
              "no info key 12345");
    assert_memory_equal(some, all + 3, sizeof some);
}

TEST(an_empty_list_has_no_rows) {
    const stltsa_info* info = stltsa_decomposition_info(found);
    stltsa_part part;
    assert_int_equal(stltsa_info_count(info, STLTSA_INFO_REPETITION), 0);
    must(stltsa_info_rows(info, STLTSA_INFO_REPETITION, 0, 0, NULL, sizeof part));
    assert_int_equal(stltsa_info_rows(info, STLTSA_INFO_REPETITION, 0, 1, &part, sizeof part),
                     STLTSA_E_ARGUMENT);
}

/* ---- Arrays ---- */

TEST(arrays_have_the_type_of_the_caller) {
    const stltsa_info *of_model = stltsa_model_info(model), *of_phase = stltsa_phase_info(phase);
    int64_t rows = 0, cols = 0;
    must(stltsa_info_shape(of_model, STLTSA_INFO_COORDS, &rows, &cols));
    assert_int_equal(rows, int_of(model, STLTSA_INFO_ROWS));
    assert_int_equal(cols, int_of(model, STLTSA_INFO_DIMENSION));
    double* wide = array_of(model, STLTSA_INFO_COORDS);
    float* narrow = calloc((size_t)(rows * cols), sizeof *narrow);
    const stltsa_out single = {narrow, rows, cols, 0, 0, STLTSA_F32, 0};
    must(stltsa_info_array(of_model, STLTSA_INFO_COORDS, 0, &single));
    for (int64_t i = 0; i < rows * cols; ++i)
        assert_true(narrow[i] == (float)wide[i]);

    /* Whole numbers are written as real ones, but not real ones as whole. */
    double* real = array_of(phase, STLTSA_INFO_PHASE_CYCLE);
    int64_t* whole = whole_of(phase, STLTSA_INFO_PHASE_CYCLE);
    const int64_t frames = stltsa_clip_frames(clip);
    for (int64_t i = 0; i < frames; ++i)
        assert_true(real[i] == (double)whole[i]);
    const stltsa_out list = list_out(whole, frames);
    whole[0] = 77;
    assert_int_equal(stltsa_info_array(of_phase, STLTSA_INFO_PHASE, 0, &list), STLTSA_E_ARGUMENT);
    assert_int_equal(whole[0], 77);
    free(narrow);
}

TEST(several_arrays_are_read_by_index) {
    const stltsa_info* info = stltsa_comparison_info(comparison);
    int64_t rows = 0, cols = 0;
    must(stltsa_info_shape(info, STLTSA_INFO_MEAN, &rows, &cols));
    assert_int_equal(rows, 21);
    assert_int_equal(cols, count_of(comparison, STLTSA_INFO_PART_CHANNEL));
    assert_int_equal(count_of(comparison, STLTSA_INFO_MEAN), 2);
    double *first = get_array(info, STLTSA_INFO_MEAN, 0),
           *second = get_array(info, STLTSA_INFO_MEAN, 1),
           *difference = get_array(info, STLTSA_INFO_DIFFERENCE, 0);
    for (int64_t i = 0; i < rows * cols; ++i)
        assert_true(difference[i] == second[i] - first[i]);
    const stltsa_out out = packed_out(first, rows, cols);
    must_fail(stltsa_info_array(info, STLTSA_INFO_MEAN, 2, &out), STLTSA_E_ARGUMENT,
              "array 2 of mean does not exist: there are 2 here");
    assert_int_equal(stltsa_info_array(info, STLTSA_INFO_MEAN, -1, &out), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_array(info, STLTSA_INFO_DIFFERENCE, 1, &out), STLTSA_E_ARGUMENT);
}

/* On every handle that has arrays: nothing is written. */
TEST(arrays_of_the_wrong_shape_are_refused) {
    stltsa_info_key key = {.size = sizeof key};
    for (int64_t i = 0; stltsa_info_describe(i, &key) == STLTSA_OK; ++i)
        for (int h = 0; h < kinds; ++h) {
            const stltsa_info* info = handles[h].info;
            int64_t rows = 0, cols = 0;
            if (key.type != STLTSA_TYPE_ARRAY || stltsa_info_count(info, key.key) == 0)
                continue;
            must(stltsa_info_shape(info, key.key, &rows, &cols));
            double* values = new_matrix(rows + 1, cols + 1);
            values[0] = 77;
            const stltsa_out wrong[] = {
                packed_out(values, rows + 1, cols), packed_out(values, rows, cols + 1),
                packed_out(values, rows - 1, cols), packed_out(NULL, rows, cols)};
            for (int w = 0; w < 4; ++w)
                assert_int_equal(stltsa_info_array(info, key.key, 0, &wrong[w]),
                                 w < 3 ? STLTSA_E_SHAPE : STLTSA_E_ARGUMENT);
            stltsa_out bad = packed_out(values, rows, cols);
            bad.reserved = 1;
            assert_int_equal(stltsa_info_array(info, key.key, 0, &bad), STLTSA_E_ARGUMENT);
            bad.reserved = 0;
            bad.dtype = 9;
            assert_int_equal(stltsa_info_array(info, key.key, 0, &bad), STLTSA_E_ARGUMENT);
            assert_int_equal(stltsa_info_array(info, key.key, 0, NULL), STLTSA_E_ARGUMENT);
            assert_true(values[0] == 77);
        }
}

TEST(what_is_no_array_is_refused) {
    const stltsa_info* info = stltsa_model_info(model);
    int64_t rows = 7, cols = 7;
    double one = 77;
    const stltsa_out out = packed_out(&one, 1, 1);
    const struct {
        int32_t key;
        const char* words;
    } cases[] = {{STLTSA_INFO_ROWS, "info rows is not an array"},
                 {STLTSA_INFO_COMPONENT, "info component is not an array"},
                 {STLTSA_INFO_CURVE, "there is no curve here"},
                 {12345, "no info key 12345"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        must_fail(stltsa_info_array(info, cases[i].key, 0, &out), STLTSA_E_ARGUMENT,
                  cases[i].words);
        must_fail(stltsa_info_shape(info, cases[i].key, &rows, &cols), STLTSA_E_ARGUMENT,
                  cases[i].words);
    }
    const int32_t key = STLTSA_INFO_COORDS;
    assert_int_equal(stltsa_info_array(NULL, key, 0, &out), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_shape(NULL, key, &rows, &cols), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_shape(info, key, NULL, &cols), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_shape(info, key, &rows, NULL), STLTSA_E_ARGUMENT);
    assert_true(one == 77 && rows == 7 && cols == 7);
}

/* ---- JSON ---- */

TEST(json_has_the_schema_of_its_handle) {
    for (int h = 0; h < kinds; ++h) {
        char* json = (char*)&handles;
        if (handles[h].schema == NULL) {
            assert_int_equal(stltsa_info_json(handles[h].info, &json), STLTSA_E_UNSUPPORTED);
            assert_null(json);
            continue;
        }
        char begin[64];
        snprintf(begin, sizeof begin, "{\"format\":\"%s\"", handles[h].schema);
        must(stltsa_info_json(handles[h].info, &json));
        assert_int_equal(strncmp(json, begin, strlen(begin)), 0);
        assert_int_equal(json[strlen(json) - 1], '}');
        stltsa_free(json);
        assert_int_equal(stltsa_info_json(handles[h].info, NULL), STLTSA_E_ARGUMENT);
    }
    char* json = NULL;
    assert_int_equal(stltsa_info_json(NULL, &json), STLTSA_E_ARGUMENT);
}

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    walker_path = argv[1];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fact_is_read_by_its_key_and_type),
        cmocka_unit_test(what_is_not_there_is_refused_with_a_text),
        cmocka_unit_test(handles_that_are_null_have_no_info),
        cmocka_unit_test(keys_are_described),
        cmocka_unit_test(every_handle_has_what_the_table_says),
        cmocka_unit_test(rows_have_the_size_of_the_caller),
        cmocka_unit_test(rows_are_read_by_range),
        cmocka_unit_test(an_empty_list_has_no_rows),
        cmocka_unit_test(arrays_have_the_type_of_the_caller),
        cmocka_unit_test(several_arrays_are_read_by_index),
        cmocka_unit_test(arrays_of_the_wrong_shape_are_refused),
        cmocka_unit_test(what_is_no_array_is_refused),
        cmocka_unit_test(json_has_the_schema_of_its_handle),
    };
    return cmocka_run_group_tests(tests, make_handles, NULL);
}
