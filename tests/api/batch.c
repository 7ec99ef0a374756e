/* SPDX-License-Identifier: BSD-3-Clause */
/* A batch in C: wrong arguments, a clip of the caller, cancelling. tests/command/test_batch.py has
 * what becomes of files and folders. */
#define _XOPEN_SOURCE 700 /* mkdtemp */
#include "support.h"

static const char* walker_path; /* set by main() */
static char folder[] = "/tmp/stltsa-batch-XXXXXX";

static void wrong_arguments_are_refused(void** state) {
    (void)state;
    const char* none[] = {NULL};
    const struct {
        const char* const* paths;
        int64_t count;
        const char* folder;
        const char* shard;
    } wrong[] = {{NULL, 1, folder, NULL},         {none, 1, folder, NULL},
                 {&walker_path, 0, folder, NULL}, {&walker_path, -1, folder, NULL},
                 {&walker_path, 1, NULL, NULL},   {&walker_path, 1, folder, ""},
                 {&walker_path, 1, folder, "0/1"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        stltsa_batch* batch = (stltsa_batch*)&none; /* must become NULL */
        assert_int_equal(stltsa_batch_new(wrong[i].paths, wrong[i].count, wrong[i].folder,
                                          wrong[i].shard, NULL, &batch),
                         STLTSA_E_ARGUMENT);
        assert_null(batch);
    }
    assert_int_equal(stltsa_batch_new(&walker_path, 1, folder, NULL, NULL, NULL),
                     STLTSA_E_ARGUMENT);
    stltsa_options* options = NULL;
    assert_int_equal(stltsa_options_new(&options), STLTSA_OK);
    assert_int_equal(stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, 5), STLTSA_OK);
    stltsa_batch* batch = NULL;
    assert_int_equal(stltsa_batch_new(&walker_path, 1, folder, NULL, options, &batch),
                     STLTSA_E_ARGUMENT); /* of fit */
    stltsa_options_free(options);
    char* row = NULL;
    assert_int_equal(stltsa_batch_run(NULL, 0, NULL, NULL, NULL, &row), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_batch_finish(NULL, NULL, 0, NULL), STLTSA_E_ARGUMENT);
    assert_null(stltsa_batch_path(NULL, 0));
    stltsa_batch_free(NULL);
}

static void a_cancelled_clip_has_no_row_and_no_result(void** state) {
    (void)state;
    stltsa_batch* batch = NULL;
    assert_int_equal(stltsa_batch_new(&walker_path, 1, folder, NULL, NULL, &batch), STLTSA_OK);
    assert_string_equal(stltsa_batch_path(batch, 0), walker_path);
    assert_null(stltsa_batch_path(batch, 1));
    assert_null(stltsa_batch_path(batch, -1));
    stltsa_options* options = NULL;
    int32_t calls_left = 0;
    assert_int_equal(stltsa_options_new(&options), STLTSA_OK);
    assert_int_equal(stltsa_options_set_progress(options, cancel_after, &calls_left), STLTSA_OK);
    char* row = (char*)&calls_left; /* must become NULL */
    assert_int_equal(stltsa_batch_run(batch, 0, NULL, options, NULL, &row), STLTSA_E_CANCELLED);
    assert_null(row);
    assert_int_equal(stltsa_batch_run(batch, 1, NULL, NULL, NULL, &row), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_batch_run(batch, 0, NULL, NULL, NULL, NULL), STLTSA_E_ARGUMENT);
    int32_t kept = 1;
    assert_int_equal(stltsa_batch_run(batch, 0, NULL, NULL, &kept, &row), STLTSA_OK);
    assert_int_equal(kept, 0); /* the cancelled run left nothing */
    stltsa_free(row);
    stltsa_options_free(options);
    stltsa_batch_free(batch);
}

/* What the library cannot open, the caller may have read. */
static void a_clip_of_the_caller(void** state) {
    (void)state;
    char path[sizeof folder + 10];
    snprintf(path, sizeof path, "%s/walk.npz", folder);
    FILE* file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fclose(file), 0);
    const char* paths[] = {path};
    stltsa_batch* batch = NULL;
    stltsa_clip* clip = NULL;
    assert_int_equal(stltsa_batch_new(paths, 1, folder, NULL, NULL, &batch), STLTSA_OK);
    int32_t kept = 1;
    char* row = NULL;
    assert_int_equal(stltsa_batch_run(batch, 0, NULL, NULL, &kept, &row), STLTSA_E_FORMAT);
    assert_non_null(strstr(row, ",STLTSA_E_FORMAT,"));
    assert_int_equal(kept, 0);
    stltsa_free(row);
    assert_int_equal(stltsa_clip_open(walker_path, NULL, &clip), STLTSA_OK);
    for (int again = 0; again < 2; ++again) {
        const stltsa_clip* given = again == 0 ? clip : NULL;
        assert_int_equal(stltsa_batch_run(batch, 0, given, NULL, &kept, &row), STLTSA_OK);
        assert_int_equal(kept, again);
        assert_non_null(strstr(row, "walk.npz,done,"));
        const char* rows[] = {row};
        const char* summary = NULL;
        assert_int_equal(stltsa_batch_finish(batch, rows, 1, &summary), STLTSA_OK);
        assert_non_null(strstr(summary, "/summary.csv"));
        assert_int_equal(stltsa_batch_finish(batch, NULL, 1, NULL), STLTSA_E_ARGUMENT);
        stltsa_free(row);
    }
    stltsa_clip_free(clip);
    stltsa_batch_free(batch);
}

int main(int argc, char** argv) {
    if (argc < 2 || mkdtemp(folder) == NULL)
        return 2;
    walker_path = argv[1];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wrong_arguments_are_refused),
        cmocka_unit_test(a_cancelled_clip_has_no_row_and_no_result),
        cmocka_unit_test(a_clip_of_the_caller),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    char line[64];
    snprintf(line, sizeof line, "rm -r %s", folder);
    return system(line) == 0 ? failed : 1;
}
