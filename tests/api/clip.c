/* SPDX-License-Identifier: BSD-3-Clause */
/* Clips through the C API: reading, and their contents. */
#include "../small_c3d.h"
#include "support.h"

/* A thigh and a shank of lengths 4 and 3 that hang from the hip. Frame 1 turns the thigh by 90
 * degrees about z, from -y to +x. */
static const char leg[] =
    "HIERARCHY\n"
    "ROOT hip\n{\n OFFSET 0 0 0\n"
    " CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    " JOINT knee\n {\n  OFFSET 0 -4 0\n"
    "  CHANNELS 3 Zrotation Xrotation Yrotation\n"
    "  End Site\n  {\n   OFFSET 0 -3 0\n  }\n }\n}\n"
    "MOTION\nFrames: 2\nFrame Time: 0.01\n"
    "1 2 3 0 0 0 0 0 0\n"
    "1 2 3 90 0 0 0 0 0\n";

static stltsa_clip* parsed(const char* text, int32_t format) {
    stltsa_clip* clip = NULL;
    must(stltsa_clip_parse(text, strlen(text), format, NULL, NULL, &clip));
    return keep_clip(clip);
}

TEST(a_c3d_has_events) {
    unsigned char bytes[small_c3d_size];
    make_small_c3d(bytes);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_parse(bytes, sizeof bytes, 0, NULL, NULL, &clip));
    assert_int_equal(int_of(clip, STLTSA_INFO_FORMAT), STLTSA_FORMAT_C3D);
    assert_int_equal(stltsa_clip_frames(clip), 32);
    assert_int_equal(count_of(clip, STLTSA_INFO_FILE_EVENT), 1);
    const stltsa_file_event event = file_event_at(clip, 0);
    assert_string_equal(event.label, "RHS");
    assert_string_equal(event.context, "");
    assert_true(event.frame == 12.5 && event.seconds == 0.125);
    stltsa_clip_free(clip);
}

TEST(a_bvh_says_what_it_is) {
    stltsa_clip* clip = parsed(leg, 0);
    assert_int_equal(int_of(clip, STLTSA_INFO_FORMAT), STLTSA_FORMAT_BVH);
    assert_int_equal(stltsa_clip_frames(clip), 2);
    assert_true(fabs(stltsa_clip_fps(clip) - 100) < 1e-9);
    assert_int_equal(int_of(clip, STLTSA_INFO_CHANNELS), 9);
    assert_int_equal(count_of(clip, STLTSA_INFO_JOINT), 3);
    const stltsa_joint hip = joint_at(clip, 0), end = joint_at(clip, 2);
    assert_string_equal(hip.name, "hip");
    assert_int_equal(hip.parent, -1);
    assert_int_equal(hip.is_end_site, 0);
    assert_string_equal(hip.channels, "tx ty tz rz rx ry");
    assert_int_equal(end.parent, 1);
    assert_int_equal(end.is_end_site, 1);
    assert_string_equal(end.channels, "");
    assert_true(end.offset[1] == -3);
}

TEST(positions_and_rotations) {
    stltsa_clip* clip = parsed(leg, STLTSA_FORMAT_BVH);
    double *p = array_of(clip, STLTSA_INFO_POSITIONS), *q = array_of(clip, STLTSA_INFO_ROTATIONS);
    const double want[2 * 9] = {1, 2, 3, 1, -2, 3, 1, -5, 3, 1, 2, 3, 5, 2, 3, 8, 2, 3};
    assert_below(largest_difference(p, want, 18), 1e-12, "position");
    const double half = sqrt(0.5);
    assert_below(fabs(q[0] - 1), 1e-12, "identity");
    assert_below(fabs(fabs(q[12]) - half) + fabs(q[12] - q[15]), 1e-12, "quarter turn about z");
}

TEST(features_leave_out_place_and_heading) {
    char moved[sizeof leg + 64];
    strcpy(moved, leg);
    /* The second frame: moved, and turned only about y. */
    strcpy(strstr(moved, "1 2 3 90"), "-7 2 40 0 0 77 0 0 0\n");
    stltsa_clip* clip = parsed(moved, 0);
    stltsa_options* options = with_int(STLTSA_OPT_UP_AXIS, 2);
    int64_t count = 0;
    double* x = new_features(clip, options, &count);
    assert_below(largest_difference(x, x + count, count), 1e-12, "feature of the same pose");
    must(stltsa_options_set_int(options, STLTSA_OPT_FEATURES, STLTSA_FEATURES_RAW));
    must(stltsa_clip_feature_count(clip, options, &count));
    assert_int_equal(count, 9);
}

TEST(bare_numbers) {
    stltsa_clip* clip = parsed("a;b\n1;2\n3;4\n5;6.5\n", STLTSA_FORMAT_CSV);
    assert_int_equal(stltsa_clip_frames(clip), 3);
    assert_int_equal(int_of(clip, STLTSA_INFO_CHANNELS), 2);
    assert_int_equal(count_of(clip, STLTSA_INFO_JOINT), 0);
    assert_true(stltsa_clip_fps(clip) == 0);
    double x[6];
    const stltsa_out out = packed_out(x, 3, 2);
    must(stltsa_clip_features(clip, NULL, &out));
    assert_true(x[0] == 1 && x[5] == 6.5);
    assert_int_equal(count_of(clip, STLTSA_INFO_POSITIONS), 0);
    assert_int_equal(count_of(clip, STLTSA_INFO_ROTATIONS), 0);
    stltsa_decomposition* units = NULL;
    must_fail(stltsa_decompose(clip, NULL, &units), STLTSA_E_ARGUMENT, "fps");
    assert_null(units);
}

TEST(a_matrix_becomes_a_clip_of_its_own) {
    double x[] = {1, 2, 3, 4};
    const stltsa_in in = packed_in(x, 2, 2);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_matrix(&in, 50, &clip));
    x[0] = 99; /* copied, so no effect */
    double y[4];
    const stltsa_out out = packed_out(y, 2, 2);
    must(stltsa_clip_features(clip, NULL, &out));
    assert_true(y[0] == 1 && y[3] == 4);
    assert_true(stltsa_clip_fps(clip) == 50);
    stltsa_clip_free(clip);
    clip = (stltsa_clip*)(void*)x;
    assert_int_equal(stltsa_clip_from_matrix(&in, 0, &clip), STLTSA_E_ARGUMENT);
    assert_null(clip);
    assert_int_equal(stltsa_clip_from_matrix(&in, NAN, &clip), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_clip_from_matrix(&in, 5e-324, &clip), STLTSA_E_ARGUMENT);
    x[2] = NAN;
    assert_int_equal(stltsa_clip_from_matrix(&in, 50, &clip), STLTSA_E_NOT_FINITE);
    assert_int_equal(stltsa_clip_from_matrix(NULL, 50, &clip), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_clip_from_matrix(&in, 50, NULL), STLTSA_E_ARGUMENT);
}

static void assert_open_fails(const char* path, stltsa_status status, const char* words) {
    stltsa_clip* clip = (stltsa_clip*)(void*)leg;
    assert_int_equal(stltsa_clip_open(path, NULL, &clip), status);
    assert_null(clip);
    assert_non_null(strstr(stltsa_last_error(), words));
}

TEST(what_cannot_be_read_is_said) {
    assert_open_fails(NULL, STLTSA_E_ARGUMENT, "path");
    assert_open_fails("/nowhere/at all.bvh", STLTSA_E_IO, "/nowhere/at all.bvh");
    assert_open_fails("/", STLTSA_E_IO, "/");
    stltsa_clip* clip = NULL;
    char text[sizeof leg];
    strcpy(text, leg);
    memcpy(strstr(text, "-3 0"), "-3 x", 4); /* in line 11 */
    must_fail(stltsa_clip_parse(text, strlen(text), 0, NULL, NULL, &clip), STLTSA_E_FORMAT, "12");
    assert_int_equal(stltsa_clip_parse(leg, strlen(leg), 99, NULL, NULL, &clip), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_clip_parse(NULL, 4, 0, NULL, NULL, &clip), STLTSA_E_ARGUMENT);
    assert_true(stltsa_clip_parse(NULL, 0, 0, NULL, NULL, &clip) < 0);
    assert_null(clip);
}

TEST(null_handles_are_harmless) {
    stltsa_clip_free(NULL);
    stltsa_free(NULL);
    assert_int_equal(stltsa_clip_frames(NULL), 0);
    assert_true(stltsa_clip_fps(NULL) == 0);
}

TEST(json_escapes_what_a_file_may_hold) {
    const char csv[] = "\"a \\ b\",\xff\n1,2\n3,4\n";
    stltsa_clip* clip = parsed(csv, STLTSA_FORMAT_CSV);
    char* json = json_of(clip);
    assert_non_null(strstr(json, "\"names\":[\"a \\\\ b\",\"\xEF\xBF\xBD\"]"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_c3d_has_events),
        cmocka_unit_test(a_bvh_says_what_it_is),
        cmocka_unit_test(positions_and_rotations),
        cmocka_unit_test(features_leave_out_place_and_heading),
        cmocka_unit_test(bare_numbers),
        cmocka_unit_test(a_matrix_becomes_a_clip_of_its_own),
        cmocka_unit_test(what_cannot_be_read_is_said),
        cmocka_unit_test(null_handles_are_harmless),
        cmocka_unit_test(json_escapes_what_a_file_may_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
