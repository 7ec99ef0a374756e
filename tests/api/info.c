/* SPDX-License-Identifier: BSD-3-Clause */
/* Facts by key: available ones, and refused calls. */
#include "support.h"

static const double frames[8][2] = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}, {5, 1}, {6, 0}, {7, 1}};

static int make_clip(void** state) {
    const stltsa_in in = {frames, 8, 2, 0, 0, STLTSA_F64, 0};
    return stltsa_clip_from_matrix(&in, 50, (stltsa_clip**)state);
}

static int free_clip(void** state) {
    stltsa_clip_free(*state);
    return 0;
}

static void a_fact_is_read_by_its_key_and_type(void** state) {
    const stltsa_info* info = stltsa_clip_info(*state);
    int64_t count = 0;
    double fps = 0;
    const char* path = NULL;
    assert_int_equal(stltsa_info_int(info, STLTSA_INFO_CLIP_FRAMES, 0, &count), STLTSA_OK);
    assert_int_equal(count, 8);
    assert_int_equal(stltsa_info_real(info, STLTSA_INFO_CLIP_FPS, 0, &fps), STLTSA_OK);
    assert_true(fps == 50);
    assert_int_equal(stltsa_info_text(info, STLTSA_INFO_PATH, 0, &path), STLTSA_OK);
    assert_string_equal(path, "");
}

static void counts_tell_what_there_is(void** state) {
    const stltsa_info* info = stltsa_clip_info(*state);
    assert_int_equal(stltsa_info_count(info, STLTSA_INFO_CLIP_FRAMES), 1);
    assert_int_equal(stltsa_info_count(info, STLTSA_INFO_NOTE), 0);
    assert_int_equal(stltsa_info_count(info, STLTSA_INFO_RESIDUAL), 0);
    assert_int_equal(stltsa_info_count(info, 12345), 0);
    assert_int_equal(stltsa_info_count(NULL, STLTSA_INFO_PATH), 0);
}

static void what_is_not_there_is_refused_with_a_text(void** state) {
    const stltsa_info* info = stltsa_clip_info(*state);
    int64_t value = 77;
    double real = 77;
    assert_int_equal(stltsa_info_int(info, STLTSA_INFO_CLIP_FRAMES, 1, &value), STLTSA_E_ARGUMENT);
    assert_string_equal(stltsa_last_error(),
                        "value 1 of info clip_frames does not exist: there are 1 here");
    assert_int_equal(stltsa_info_int(info, STLTSA_INFO_CLIP_FRAMES, -1, &value), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_real(info, STLTSA_INFO_RESIDUAL, 0, &real), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_real(info, STLTSA_INFO_CLIP_FRAMES, 0, &real), STLTSA_E_ARGUMENT);
    assert_string_equal(stltsa_last_error(), "info clip_frames is not a real number");
    assert_int_equal(stltsa_info_int(info, 12345, 0, &value), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_int(NULL, STLTSA_INFO_CLIP_FRAMES, 0, &value), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_int(info, STLTSA_INFO_CLIP_FRAMES, 0, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(value, 77);
    assert_true(real == 77);
}

static void handles_that_are_null_have_no_info(void** state) {
    (void)state;
    assert_null(stltsa_clip_info(NULL));
    assert_null(stltsa_model_info(NULL));
    assert_null(stltsa_dimension_info(NULL));
    assert_null(stltsa_decomposition_info(NULL));
    assert_null(stltsa_denoising_info(NULL));
    assert_null(stltsa_synthesis_info(NULL));
}

static void keys_are_described(void** state) {
    (void)state;
    stltsa_info_key row;
    int32_t last = 0;
    row.size = sizeof row;
    for (int64_t i = 0; i < stltsa_info_key_count(); ++i) {
        assert_int_equal(stltsa_info_describe(i, &row), STLTSA_OK);
        assert_true(row.key > last);
        last = row.key;
        if (row.key == STLTSA_INFO_NEIGHBORS) {
            assert_string_equal(row.name, "neighbors");
            assert_int_equal(row.type, STLTSA_TYPE_INT);
            assert_int_equal(row.is_list, 0);
            assert_int_equal(row.handles, STLTSA_HANDLE_MODEL | STLTSA_HANDLE_DIMENSION |
                                              STLTSA_HANDLE_DECOMPOSITION |
                                              STLTSA_HANDLE_DENOISING);
        }
    }
    assert_int_equal(stltsa_info_describe(-1, &row), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_describe(stltsa_info_key_count(), &row), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_info_describe(0, NULL), STLTSA_E_ARGUMENT);
    row.size = 0;
    assert_int_equal(stltsa_info_describe(0, &row), STLTSA_E_ARGUMENT);
}

static void a_shorter_key_is_not_written_past(void** state) {
    (void)state;
    stltsa_info_key row;
    row.size = offsetof(stltsa_info_key, text);
    row.text = "kept";
    assert_int_equal(stltsa_info_describe(0, &row), STLTSA_OK);
    assert_string_equal(row.text, "kept");
    assert_string_equal(row.name, "path");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_fact_is_read_by_its_key_and_type, make_clip, free_clip),
        cmocka_unit_test_setup_teardown(counts_tell_what_there_is, make_clip, free_clip),
        cmocka_unit_test_setup_teardown(what_is_not_there_is_refused_with_a_text, make_clip,
                                        free_clip),
        cmocka_unit_test(handles_that_are_null_have_no_info),
        cmocka_unit_test(keys_are_described),
        cmocka_unit_test(a_shorter_key_is_not_written_past),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
