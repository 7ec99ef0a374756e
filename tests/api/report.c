/* SPDX-License-Identifier: BSD-3-Clause */
/* Reports through the C API. */
#define _XOPEN_SOURCE 700 /* mkdtemp */
#include <unistd.h>

#include "walking.h"

static char folder[64], path[128];

static int make_folder(void** state) {
    (void)state;
    strcpy(folder, "/tmp/stltsa-report-XXXXXX");
    if (mkdtemp(folder) == NULL)
        return 1;
    snprintf(path, sizeof path, "%s/walk.html", folder);
    return 0;
}

static int remove_folder(void** state) {
    (void)state;
    return rmdir(folder); /* fails if a test, or the library, leaves a file */
}

static char* file_text(void) {
    FILE* file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    const long size = ftell(file);
    assert_true(size > 0);
    rewind(file);
    char* text = malloc((size_t)size + 1);
    assert_non_null(text);
    assert_int_equal(fread(text, 1, (size_t)size, file), size);
    text[size] = '\0';
    fclose(file);
    assert_int_equal(unlink(path), 0);
    return keep(text, free);
}

static char* report(const stltsa_clip* clip, const char* command) {
    stltsa_decomposition* found = decomposed(clip, NULL);
    must(stltsa_report_save(clip, found, NULL, command, path));
    return file_text();
}

TEST(a_page_repeats_to_the_byte) {
    stltsa_clip* clip = opened();
    char *one = report(clip, NULL), *two = report(clip, NULL);
    assert_string_equal(one, two);
    assert_int_equal(strncmp(one, "<!doctype html>\n", 16), 0);
    assert_non_null(strstr(one, "\"format\":\"stltsa-report/1\""));
    assert_non_null(strstr(one, "\"format\":\"stltsa-decomposition/2\""));
}

/* The suffix alone decides, in any case; the figure names the clip. */
TEST(a_path_that_ends_in_svg_gets_a_figure) {
    stltsa_clip* clip = opened();
    char* page = report(clip, NULL);
    const char* const suffixes[] = {"svg", "SVG"};
    for (size_t i = 0; i < 2; ++i) {
        snprintf(path, sizeof path, "%s/walk.%s", folder, suffixes[i]);
        char *one = report(clip, NULL), *two = report(clip, "ignored");
        assert_string_equal(one, two);
        assert_int_equal(strncmp(one, "<?xml", 5), 0);
        assert_non_null(strstr(one, "<title>"));
        assert_non_null(strstr(one, "class=\"posture\""));
        assert_non_null(strstr(one, "3 cycles of 1.100 s, standard deviation 0.000 s"));
        assert_true(strlen(one) < strlen(page) / 2);
    }
    snprintf(path, sizeof path, "%s/walk.html", folder);
}

TEST(no_text_ends_the_data) {
    stltsa_clip* clip = opened();
    char* page = report(clip, "</script><script>alert(1)</script>");
    assert_null(strstr(page, "alert(1)</script>"));
    assert_non_null(strstr(page, "\\u003c/script>\\u003cscript>alert(1)"));
}

static int32_t count_writing(void* user, int32_t stage, double fraction) {
    (void)fraction;
    *(int*)user += stage == STLTSA_STAGE_WRITE;
    return 0;
}

struct page {
    stltsa_clip* clip;
    stltsa_decomposition* found;
};

/* If it is cancelled, no file is left. */
static stltsa_status save_page(void* user, const stltsa_options* options) {
    const struct page* of = user;
    const stltsa_status status = stltsa_report_save(of->clip, of->found, options, NULL, path);
    if (status == STLTSA_OK)
        file_text();
    assert_int_equal(access(path, F_OK), -1);
    return status;
}

TEST(saving_can_be_cancelled) {
    struct page of = {opened(), NULL};
    of.found = decomposed(of.clip, NULL);
    /* Among them: before the frames are chosen and packed, and the page is filled and written. */
    int writing = 0;
    stltsa_options* options = with_progress(count_writing, &writing);
    assert_in_range(cancelled_calls(save_page, &of), 3, 1000);
    must(save_page(&of, options));
    snprintf(path, sizeof path, "%s/walk.svg", folder);
    assert_in_range(cancelled_calls(save_page, &of), 1, 1000);
    snprintf(path, sizeof path, "%s/walk.html", folder);
    assert_in_range(writing, 4, 1000);
}

TEST(what_is_wrong_is_said) {
    stltsa_clip* clip = opened();
    stltsa_clip* other = NULL;
    stltsa_decomposition* found = NULL;
    must(stltsa_clip_stretch(clip, "0-100", NULL, &other));
    must(stltsa_decompose(clip, NULL, &found));
    assert_int_equal(stltsa_report_save(NULL, found, NULL, NULL, path), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_report_save(clip, NULL, NULL, NULL, path), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_report_save(clip, found, NULL, NULL, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_report_save(other, found, NULL, NULL, path), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_report_save(clip, found, NULL, NULL, "/no/such/folder/x.html"),
                     STLTSA_E_IO);
    assert_int_equal(stltsa_report_save(other, found, NULL, NULL, "/no/such/folder/x.svg"),
                     STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_report_save(clip, found, NULL, NULL, "/no/such/folder/x.svg"),
                     STLTSA_E_IO);
    assert_int_not_equal(access(path, F_OK), 0);
    stltsa_decomposition_free(found);
    stltsa_clip_free(other);
}

static stltsa_comparison* sides_of(const stltsa_clip* clip) {
    stltsa_phase* phase = phase_of(clip, NULL);
    stltsa_comparison* sides = NULL;
    must(stltsa_compare_left_right(clip, phase, -1, 51, NULL, &sides));
    return keep_comparison(sides);
}

static char* comparison_report(const stltsa_comparison* sides, const char* command) {
    must(stltsa_comparison_report_save(sides, NULL, command, path));
    return file_text();
}

static stltsa_status save_comparison(void* sides, const stltsa_options* options) {
    const stltsa_status status = stltsa_comparison_report_save(sides, options, NULL, path);
    if (status == STLTSA_OK)
        file_text();
    assert_int_equal(access(path, F_OK), -1);
    return status;
}

TEST(a_comparison_is_a_page) {
    stltsa_clip* clip = opened();
    stltsa_comparison* sides = sides_of(clip);
    char* one = comparison_report(sides, NULL);
    char* two = comparison_report(sides, NULL);
    assert_string_equal(one, two);
    assert_non_null(strstr(one, "\"format\":\"stltsa-comparison-report/1\""));
    char* page = comparison_report(sides, "</script>a");
    assert_null(strstr(page, "</script>a"));
    assert_in_range(cancelled_calls(save_comparison, sides), 1, 1000);
    assert_int_equal(stltsa_comparison_report_save(NULL, NULL, NULL, path), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_comparison_report_save(sides, NULL, NULL, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_comparison_report_save(sides, NULL, NULL, "/no/such/folder/x.html"),
                     STLTSA_E_IO);
}

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    walker_path = argv[1];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_page_repeats_to_the_byte),
        cmocka_unit_test(a_path_that_ends_in_svg_gets_a_figure),
        cmocka_unit_test(no_text_ends_the_data),
        cmocka_unit_test(saving_can_be_cancelled),
        cmocka_unit_test(what_is_wrong_is_said),
        cmocka_unit_test(a_comparison_is_a_page),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
