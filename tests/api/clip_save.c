/* SPDX-License-Identifier: BSD-3-Clause */
/* Writing clips through the C API: files, and messages if that is impossible. */
#define _XOPEN_SOURCE 700 /* mkdtemp, symlink */
#include "support.h"

#include <sys/stat.h>
#include <unistd.h>

static const char pendulum[] =
    "HIERARCHY\nROOT hip\n{\n OFFSET 0 0 0\n"
    " CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    " End Site\n {\n  OFFSET 0 -3 0\n }\n}\n"
    "MOTION\nFrames: 2\nFrame Time: .0083333\n"
    "1 2 3 0 0 0\n"
    "1 2 3.3 90.123456789 1e-7 0\n";

static char folder[64];

static int make_folder(void** state) {
    (void)state;
    strcpy(folder, "/tmp/stltsa-save-XXXXXX");
    return mkdtemp(folder) == NULL;
}

static int remove_folder(void** state) {
    (void)state;
    return rmdir(folder); /* fails if a test, or the library, leaves a file */
}

static const char* in_folder(const char* name) {
    static char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static stltsa_clip* parsed(const char* text) {
    stltsa_clip* clip = NULL;
    must(stltsa_clip_parse(text, strlen(text), 0, NULL, NULL, &clip));
    return keep_clip(clip);
}

static void assert_save_fails(const stltsa_clip* clip, const char* path, stltsa_status status,
                              const char* words) {
    must_fail(stltsa_clip_save(clip, path, NULL), status, words);
}

TEST(what_is_saved_reads_back) {
    stltsa_clip* clip = parsed(pendulum);
    for (int i = 0; i < 3; ++i) {
        const char* path = in_folder((const char*[]){"a.bvh", "a.csv", "a.npy"}[i]);
        must(stltsa_clip_save(clip, path, NULL));
        stltsa_clip* again = NULL;
        must(stltsa_clip_open(path, NULL, &again));
        assert_int_equal(unlink(path), 0);
        assert_int_equal(stltsa_clip_frames(again), 2);
        assert_int_equal(int_of(again, STLTSA_INFO_CHANNELS), 6);
        assert_true(stltsa_clip_fps(again) == (i == 2 ? 0 : 120)); /* NPY has no frame rate */
        double *x = new_channels(clip), *y = new_channels(again);
        assert_same_bits(x, y, 12);
        stltsa_clip_free(again);
    }
}

static stltsa_status save(void* clip, const stltsa_options* options) {
    const char* path = in_folder("a.bvh");
    const stltsa_status status = stltsa_clip_save(clip, path, options);
    assert_int_equal(unlink(path), status == STLTSA_OK ? 0 : -1);
    return status;
}

/* Before the text is made, and after: no file is written. */
TEST(saving_can_be_cancelled) {
    stltsa_clip* clip = parsed(pendulum);
    assert_int_equal(cancelled_calls(save, clip), 2);
}

TEST(clips_of_the_wrong_kind_are_refused) {
    stltsa_clip* clip = parsed(pendulum);
    assert_save_fails(clip, in_folder("a.txt"), STLTSA_E_ARGUMENT, ".bvh, .amc, .csv, .npy");
    assert_save_fails(clip, in_folder("bvh"), STLTSA_E_ARGUMENT, "suffix");
    assert_save_fails(clip, in_folder("a.amc"), STLTSA_E_UNSUPPORTED, "AMC");
    assert_save_fails(clip, NULL, STLTSA_E_ARGUMENT, "path");
    assert_save_fails(clip, "", STLTSA_E_ARGUMENT, "the path is empty");
    assert_save_fails(NULL, in_folder("a.bvh"), STLTSA_E_ARGUMENT, "clip");

    stltsa_clip* numbers = parsed("1,2\n3,4\n");
    assert_save_fails(numbers, in_folder("a.bvh"), STLTSA_E_UNSUPPORTED, "skeleton");
    assert_save_fails(numbers, in_folder("a.amc"), STLTSA_E_UNSUPPORTED, "AMC");

    char text[sizeof pendulum];
    strcpy(text, pendulum);
    memset(strstr(text, ".0083333"), '0', 8);
    stltsa_clip* timeless = parsed(text);
    assert_save_fails(timeless, in_folder("a.bvh"), STLTSA_E_UNSUPPORTED, "fps");
}

TEST(places_that_cannot_be_written_are_said) {
    stltsa_clip* clip = parsed(pendulum);
    assert_save_fails(clip, "/nowhere/at all.bvh", STLTSA_E_IO, "/nowhere/at all.bvh");
    assert_int_equal(mkdir(in_folder("d.bvh"), 0777), 0);
    assert_save_fails(clip, in_folder("d.bvh"), STLTSA_E_IO, "d.bvh: cannot write");
    assert_int_equal(rmdir(in_folder("d.bvh")), 0);
    assert_int_equal(symlink("/dev/full", in_folder("full.bvh")), 0);
    assert_save_fails(clip, in_folder("full.bvh"), STLTSA_E_IO, "No space left");
    assert_int_equal(unlink(in_folder("full.bvh")), 0);
}

TEST(a_folder_without_permission_is_said) {
    if (geteuid() == 0) {
        print_message("SKIPPED: to root every folder is writable\n");
        skip();
    }
    stltsa_clip* clip = parsed(pendulum);
    assert_int_equal(chmod(folder, 0500), 0);
    assert_save_fails(clip, in_folder("a.bvh"), STLTSA_E_IO, "Permission denied");
    assert_int_equal(chmod(folder, 0700), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_saved_reads_back),
        cmocka_unit_test(saving_can_be_cancelled),
        cmocka_unit_test(clips_of_the_wrong_kind_are_refused),
        cmocka_unit_test(places_that_cannot_be_written_are_said),
        cmocka_unit_test(a_folder_without_permission_is_said),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
