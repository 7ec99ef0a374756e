/* SPDX-License-Identifier: BSD-3-Clause */
/* Options, status names and the library's version. */
#include "support.h"

static stltsa_option_info describe(int64_t index) {
    stltsa_option_info info;
    memset(&info, 0, sizeof info);
    info.size = sizeof info;
    must(stltsa_option_describe(index, &info));
    return info;
}

TEST(every_option_is_described_and_holds_its_default) {
    enum { most = STLTSA_OPT_INTRINSIC };
    int seen[most + 1] = {0};
    for (int64_t i = 0; i < most - 1; ++i) { /* no option has the value 31 */
        const stltsa_option_info info = describe(i);
        assert_true(info.calls > 0 && info.calls < 2 * STLTSA_CALL_SYNTHESIZE);
        assert_in_range(info.key, 1, most);
        assert_int_equal(seen[info.key]++, 0);
        assert_true(strlen(info.name) > 1);
        assert_true(strlen(info.text) > 15 && info.text[strlen(info.text) - 1] == '.');
        assert_int_equal(stltsa_options_is_set(NULL, info.key), 0);
        assert_int_equal(info.automatic, strstr(info.text, "auto: ") != NULL);
        int64_t whole = 77;
        double real = 77;
        const char* text = "as before";
        const stltsa_status status =
            info.type == STLTSA_TYPE_INT    ? stltsa_options_get_int(NULL, info.key, &whole)
            : info.type == STLTSA_TYPE_REAL ? stltsa_options_get_real(NULL, info.key, &real)
                                            : stltsa_options_get_text(NULL, info.key, &text);
        assert_int_equal(status, info.automatic ? STLTSA_E_ARGUMENT : STLTSA_OK);
        if (info.automatic) {
            assert_true(isnan(info.standard));
            assert_true(whole == 77 && real == 77);
            assert_string_equal(text, "as before");
        } else {
            assert_true((info.type == STLTSA_TYPE_INT ? (double)whole : real) == info.standard);
            assert_true(info.minimum <= info.standard && info.standard <= info.maximum);
        }
    }
    stltsa_option_info past = {.size = sizeof past};
    assert_int_equal(stltsa_option_describe(most - 1, &past), STLTSA_E_ARGUMENT);
}

TEST(values_come_back_and_texts_are_copied) {
    stltsa_options* options = NULL;
    char path[] = "skeleton.asf";
    const char* text = NULL;
    int64_t whole = 0;
    double real = 0;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_int(options, STLTSA_OPT_WINDOW, 77));
    must(stltsa_options_set_real(options, STLTSA_OPT_SMOOTHING, 0.25));
    must(stltsa_options_set_text(options, STLTSA_OPT_SKELETON, path));
    path[0] = 'X';
    must(stltsa_options_get_int(options, STLTSA_OPT_WINDOW, &whole));
    must(stltsa_options_get_real(options, STLTSA_OPT_SMOOTHING, &real));
    must(stltsa_options_get_text(options, STLTSA_OPT_SKELETON, &text));
    assert_int_equal(whole, 77);
    assert_true(real == 0.25);
    assert_string_equal(text, "skeleton.asf");
    stltsa_options_free(options);
}

TEST(ranges_types_and_keys_are_checked) {
    stltsa_options* options = NULL;
    int64_t value = 5;
    must(stltsa_options_new(&options));
    for (int64_t i = 0; i < STLTSA_OPT_INTRINSIC - 1; ++i) {
        const stltsa_option_info info = describe(i);
        if (info.type == STLTSA_TYPE_TEXT)
            continue;
        const double wrong[] = {info.minimum - 1, info.maximum + 1, NAN};
        const int count = info.type == STLTSA_TYPE_REAL ? 3 : 2;
        for (int w = 0; w < count; ++w) {
            const stltsa_status status =
                info.type == STLTSA_TYPE_REAL
                    ? stltsa_options_set_real(options, info.key, wrong[w])
                    : stltsa_options_set_int(options, info.key, (int64_t)wrong[w]);
            assert_int_equal(status, STLTSA_E_ARGUMENT);
            assert_non_null(strstr(stltsa_last_error(), info.name));
        }
    }
    assert_int_equal(stltsa_options_set_int(options, 0, 1), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_int(options, 10000, 1), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_int(options, STLTSA_OPT_SMOOTHING, 1), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_real(options, STLTSA_OPT_WINDOW, 1), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_text(options, STLTSA_OPT_WINDOW, "1"), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_text(options, STLTSA_OPT_SKELETON, NULL),
                     STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_text(options, STLTSA_OPT_SKELETON, ""), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_set_int(NULL, STLTSA_OPT_WINDOW, 1), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_get_int(options, STLTSA_OPT_WINDOW, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_get_int(options, 10000, &value), STLTSA_E_ARGUMENT);
    assert_int_equal(value, 5);
    assert_int_equal(stltsa_options_new(NULL), STLTSA_E_ARGUMENT);
    stltsa_options_free(options);
    stltsa_options_free(NULL);
}

TEST(unset_options_are_as_before) {
    stltsa_options* options = NULL;
    int64_t whole = 0;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_int(options, STLTSA_OPT_LINKS, 9));
    must(stltsa_options_set_int(options, STLTSA_OPT_WINDOW, 77));
    must(stltsa_options_set_text(options, STLTSA_OPT_SKELETON, "a.asf"));
    const int32_t keys[] = {STLTSA_OPT_LINKS, STLTSA_OPT_WINDOW, STLTSA_OPT_SKELETON};
    for (int k = 0; k < 3; ++k)
        for (int set = 1; set >= 0; --set) {
            assert_int_equal(stltsa_options_is_set(options, keys[k]), set);
            must(stltsa_options_unset(options, keys[k]));
        }
    must(stltsa_options_get_int(options, STLTSA_OPT_LINKS, &whole));
    assert_int_equal(whole, 4);
    must_fail(stltsa_options_get_int(options, STLTSA_OPT_WINDOW, &whole), STLTSA_E_ARGUMENT,
              "window is not set");
    assert_int_equal(stltsa_options_unset(options, 10000), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_unset(NULL, STLTSA_OPT_LINKS), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_options_is_set(options, 10000), 0);
    stltsa_options_free(options);
}

TEST(a_shorter_description_is_not_written_past) {
    union {
        stltsa_option_info info;
        unsigned char bytes[sizeof(stltsa_option_info)];
    } u;
    memset(u.bytes, 0xAB, sizeof u.bytes);
    u.info.size = offsetof(stltsa_option_info, minimum);
    must(stltsa_option_describe(0, &u.info));
    assert_string_equal(u.info.name, "neighbors");
    for (size_t i = offsetof(stltsa_option_info, minimum); i < sizeof u.bytes; ++i)
        assert_int_equal(u.bytes[i], 0xAB);
    u.info.size = 4;
    assert_int_equal(stltsa_option_describe(0, &u.info), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_option_describe(-1, &u.info), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_option_describe(0, NULL), STLTSA_E_ARGUMENT);
}

TEST(names) {
    assert_string_equal(stltsa_status_name(STLTSA_OK), "STLTSA_OK");
    assert_string_equal(stltsa_status_name(STLTSA_E_SHAPE), "STLTSA_E_SHAPE");
    assert_string_equal(stltsa_status_name(STLTSA_E_INTERNAL), "STLTSA_E_INTERNAL");
    assert_string_equal(stltsa_status_name(-1000), "STLTSA_E_UNKNOWN");
    assert_string_equal(stltsa_status_name(1), "STLTSA_E_UNKNOWN");
    assert_string_equal(stltsa_status_name(INT32_MIN), "STLTSA_E_UNKNOWN");
    assert_string_equal(stltsa_unit_name(STLTSA_UNIT_WIND_UP), "wind-up");
    assert_string_equal(stltsa_unit_name(0), "unknown");
    char version[32];
    snprintf(version, sizeof version, "%d.%d.%d", STLTSA_VERSION_MAJOR, STLTSA_VERSION_MINOR,
             STLTSA_VERSION_PATCH);
    assert_string_equal(stltsa_version(), version);
}

TEST(a_build_says_what_it_has) {
    assert_in_range(stltsa_has(STLTSA_HAS_CHOLMOD), 0, 1);
    assert_in_range(stltsa_has(STLTSA_HAS_OPENBLAS), 0, 1);
    assert_int_equal(stltsa_has(0), 0);
    assert_int_equal(stltsa_has(12345), 0);
}

TEST(a_long_text_ends_before_a_character) {
    char path[2002];
    stltsa_clip* clip = NULL;
    for (size_t ascii = 0; ascii < 2; ++ascii) {
        memset(path, 'a', ascii);
        for (size_t i = ascii; i + 1 < sizeof path; i += 2)
            memcpy(path + i, "\xC3\xA9", 2); /* an e with an acute accent */
        path[ascii + 2000] = '\0';
        assert_int_not_equal(stltsa_clip_open(path, NULL, &clip), STLTSA_OK);
        const size_t length = strlen(stltsa_last_error());
        assert_in_range(length, 1022, 1023);
        assert_int_equal((length - ascii) % 2, 0);
    }
}

/* Parameters of an embedding belong to fit, and the text says so. */
TEST(options_of_a_fit_are_refused_by_decompose) {
    double x[60] = {0};
    const stltsa_in in = packed_in(x, 30, 2);
    const int32_t keys[] = {STLTSA_OPT_NEIGHBORS, STLTSA_OPT_WINDOW, STLTSA_OPT_DIMENSION,
                            STLTSA_OPT_MODE};
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_matrix(&in, 30, &clip));
    for (size_t i = 0; i < sizeof keys / sizeof *keys; ++i) {
        stltsa_options* options = NULL;
        stltsa_decomposition* none = NULL;
        must(stltsa_options_new(&options));
        must(stltsa_options_set_int(options, keys[i], 2));
        must_fail(stltsa_decompose(clip, options, &none), STLTSA_E_ARGUMENT, "belongs to fit");
        stltsa_options_free(options);
    }
    stltsa_clip_free(clip);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_option_is_described_and_holds_its_default),
        cmocka_unit_test(values_come_back_and_texts_are_copied),
        cmocka_unit_test(ranges_types_and_keys_are_checked),
        cmocka_unit_test(unset_options_are_as_before),
        cmocka_unit_test(a_shorter_description_is_not_written_past),
        cmocka_unit_test(names),
        cmocka_unit_test(a_build_says_what_it_has),
        cmocka_unit_test(a_long_text_ends_before_a_character),
        cmocka_unit_test(options_of_a_fit_are_refused_by_decompose),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
