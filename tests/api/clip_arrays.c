/* SPDX-License-Identifier: BSD-3-Clause */
/* Clips from arrays, and stretches of clips. The argument is the BVH file of a walker. */
#include "support.h"

enum { most_joints = 64 };

static void get_joints(const stltsa_clip* clip, stltsa_joint* joints) {
    const int64_t count = count_of(clip, STLTSA_INFO_JOINT);
    assert_true(count <= most_joints);
    must(stltsa_info_rows(stltsa_clip_info(clip), STLTSA_INFO_JOINT, 0, count, joints,
                          sizeof *joints));
}

static char* answer_of(const stltsa_clip* clip) {
    stltsa_decomposition* units = decomposed(clip, NULL);
    char* json = json_of(units);
    return json;
}

/* What follows the facts of the clip, which has no path if it is made of arrays. */
static const char* answer_in(const char* json) {
    const char* at = strstr(json, "\"segments\"");
    assert_non_null(at);
    return at;
}

TEST(channels_of_a_skeleton_keep_every_bit) {
    stltsa_clip *clip = opened(), *made = NULL;
    stltsa_joint joints[most_joints];
    get_joints(clip, joints);
    const int64_t frames = stltsa_clip_frames(clip), cols = int_of(clip, STLTSA_INFO_CHANNELS);
    double* values = new_channels(clip);
    const stltsa_in in = packed_in(values, frames, cols);
    must(stltsa_clip_from_skeleton(joints, sizeof *joints, count_of(clip, STLTSA_INFO_JOINT),
                                   STLTSA_ROTATIONS_CHANNELS, &in, NULL, stltsa_clip_fps(clip),
                                   &made));
    assert_int_equal(int_of(made, STLTSA_INFO_FORMAT), STLTSA_FORMAT_SKELETON);
    double* back = new_channels(made);
    assert_memory_equal(back, values, (size_t)(frames * cols) * sizeof *values);
    char *first = answer_of(clip), *second = answer_of(made);
    assert_string_equal(answer_in(first), answer_in(second));
    stltsa_clip_free(made);
}

TEST(quaternions_of_a_skeleton_give_its_positions) {
    stltsa_clip *clip = opened(), *made = NULL;
    stltsa_joint joints[most_joints];
    get_joints(clip, joints);
    const int64_t count = count_of(clip, STLTSA_INFO_JOINT), frames = stltsa_clip_frames(clip);
    double* quaternions = array_of(clip, STLTSA_INFO_ROTATIONS);
    double* positions = array_of(clip, STLTSA_INFO_POSITIONS);
    const stltsa_in root = {positions, frames, 3, 3 * count * 8, 8, STLTSA_F64, 0};
    double* matrices = new_matrix(frames, 9 * count);
    for (int64_t i = 0; i < frames * count; ++i) {
        const double *q = quaternions + 4 * i, w = q[0], x = q[1], y = q[2], z = q[3];
        const double m[9] = {
            1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
            2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
            2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
        memcpy(matrices + 9 * i, m, sizeof m);
    }
    for (int form = STLTSA_ROTATIONS_QUATERNION; form <= STLTSA_ROTATIONS_MATRIX; ++form) {
        const int matrix = form == STLTSA_ROTATIONS_MATRIX;
        const stltsa_in in =
            packed_in(matrix ? matrices : quaternions, frames, (matrix ? 9 : 4) * count);
        for (int64_t j = 0; matrix && j < count; ++j)
            joints[j].channels = NULL; /* the usual ones */
        must(stltsa_clip_from_skeleton(joints, sizeof *joints, count, form, &in, &root,
                                       stltsa_clip_fps(clip), &made));
        double* back = array_of(made, STLTSA_INFO_POSITIONS);
        assert_below(largest_difference(back, positions, frames * count * 3), 1e-10, "positions");
        stltsa_clip_free(made);
    }
}

static void refuses_joints(stltsa_joint* joints, int64_t count, int32_t form, const stltsa_in* in,
                           const stltsa_in* root, stltsa_status status, const char* hint) {
    stltsa_clip* clip = NULL;
    must_fail(stltsa_clip_from_skeleton(joints, sizeof *joints, count, form, in, root, 30, &clip),
              status, hint);
    assert_null(clip);
}

/* Half turns, whose matrices have no w to divide by. */
TEST(half_turns_of_matrices_are_exact) {
    const stltsa_joint joint = {"hip", -1, {0, 0, 0}, NULL, 0};
    const double matrices[4 * 9] = {1,  0, 0, 0, 1, 0, 0, 0, 1,  1,  0, 0, 0, -1, 0, 0, 0, -1,
                                    -1, 0, 0, 0, 1, 0, 0, 0, -1, -1, 0, 0, 0, -1, 0, 0, 0, 1};
    const double expected[4 * 4] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const stltsa_in in = packed_in(matrices, 4, 9);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_skeleton(&joint, sizeof joint, 1, STLTSA_ROTATIONS_MATRIX, &in, NULL, 30,
                                   &clip));
    double* rotations = array_of(clip, STLTSA_INFO_ROTATIONS);
    for (int i = 0; i < 4; ++i) {
        double product = 0; /* q and -q are one rotation */
        for (int c = 0; c < 4; ++c)
            product += rotations[4 * i + c] * expected[4 * i + c];
        assert_below(fabs(fabs(product) - 1), 1e-14, "half turn");
    }
    stltsa_clip_free(clip);
}

TEST(skeletons_that_are_none) {
    stltsa_joint joints[] = {
        {"hip", -1, {0, 0, 0}, NULL, 0},
        {"knee", 0, {0, -1, 0}, "rz rx ry", 0},
        {"foot", 1, {0, -1, 0}, NULL, 1},
    };
    double q[2 * 12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    const stltsa_in in = packed_in(q, 2, 12), narrow = packed_in(q, 2, 11);
    const int32_t form = STLTSA_ROTATIONS_QUATERNION;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_skeleton(joints, sizeof *joints, 3, form, &in, NULL, 30, &clip));
    assert_int_equal(int_of(clip, STLTSA_INFO_CHANNELS), 9);
    stltsa_clip_free(clip);
    refuses_joints(joints, 3, form, &narrow, NULL, STLTSA_E_SHAPE, "12 columns for 3 joints");
    refuses_joints(joints, 3, 9, &in, NULL, STLTSA_E_ARGUMENT, "STLTSA_ROTATIONS_*");
    refuses_joints(joints, 0, form, &in, NULL, STLTSA_E_ARGUMENT, "0 joints");
    refuses_joints(NULL, 3, form, &in, NULL, STLTSA_E_ARGUMENT, "joints is NULL");
    refuses_joints(joints, 3, form, NULL, NULL, STLTSA_E_ARGUMENT, "rotations is NULL");
    refuses_joints(joints, 3, form, &in, &narrow, STLTSA_E_SHAPE, "root positions have 2 rows");
    q[5] = 0.7;
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_ARGUMENT, "'knee') is no rotation");
    q[5] = NAN;
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_NOT_FINITE, "frame 0, column 5");
    q[5] = 0;
    joints[1].parent = 1;
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_ARGUMENT, "before their children");
    joints[1].parent = -1;
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_ARGUMENT, "joint 1 ('knee') has parent -1");
    joints[1].parent = 0;
    for (int i = 0; i < 3; ++i) {
        static const char* const texts[] = {"rz rw", "tx tx", "tx rz +ty"};
        static const char* const hints[] = {"no channel 'rw'", "each position once",
                                            "all positions of a joint"};
        joints[1].channels = texts[i];
        refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_ARGUMENT, hints[i]);
    }
    joints[1].channels = "";
    char name[300] = "";
    joints[1].name = name;
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_ARGUMENT, "joint 1 has no name");
    memset(name, 'n', sizeof name - 1);
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_ARGUMENT, "joint 1 has 299 bytes");
    joints[1].name = "knee";
    joints[1].offset[2] = INFINITY;
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_NOT_FINITE, "offset of joint 1 ('knee')");
    joints[1].offset[2] = 0;
    const stltsa_in seven = packed_in(q, 2, 7), three = packed_in(q, 2, 3);
    joints[0].channels = "tx ty tz rx ry rz";
    joints[1].channels = "rz";
    refuses_joints(joints, 3, STLTSA_ROTATIONS_CHANNELS, &seven, &three, STLTSA_E_ARGUMENT,
                   "root positions are among the channels");
    joints[0].channels = joints[1].channels = "";
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_ARGUMENT, "the skeleton cannot move");
    joints[0].channels = "rz";
    const stltsa_in root = packed_in(q, 2, 3);
    refuses_joints(joints, 3, form, &in, &root, STLTSA_E_ARGUMENT, "no channels tx ty tz");
    joints[2].name = NULL;
    refuses_joints(joints, 3, form, &in, NULL, STLTSA_E_ARGUMENT, "joint 2 has no name");
    must_fail(stltsa_clip_from_skeleton(joints, 4, 3, form, &in, NULL, 30, &clip),
              STLTSA_E_ARGUMENT, "sizeof(stltsa_joint)");
    assert_null(clip);
}

TEST(points_of_a_walker_have_its_cycles) {
    stltsa_clip *clip = opened(), *made = NULL;
    const int64_t cols = 3 * count_of(clip, STLTSA_INFO_JOINT), frames = stltsa_clip_frames(clip);
    double* positions = array_of(clip, STLTSA_INFO_POSITIONS);
    double* times = new_matrix(frames, 1);
    for (int64_t i = 0; i < frames; ++i)
        times[i] = 5 + (double)i / stltsa_clip_fps(clip);
    stltsa_points points = {.size = sizeof points, .space = 3};
    points.positions = packed_in(positions, frames, cols);
    points.times = packed_in(times, frames, 1);
    must(stltsa_clip_from_points(&points, NULL, &made));
    assert_true(fabs(stltsa_clip_fps(made) - stltsa_clip_fps(clip)) < 1e-9);
    stltsa_decomposition *of_body = NULL, *of_points = NULL;
    must(stltsa_decompose(clip, NULL, &of_body));
    must(stltsa_decompose(made, NULL, &of_points));
    const int64_t cycles = count_of(of_body, STLTSA_INFO_CYCLE);
    assert_true(cycles > 2);
    assert_int_equal(count_of(of_points, STLTSA_INFO_CYCLE), cycles);
    for (int64_t c = 0; c < cycles; ++c) {
        assert_below(fabs(cycle_at(of_body, c).begin_s - cycle_at(of_points, c).begin_s), 0.05,
                     "border");
    }
    stltsa_decomposition_free(of_points);
    stltsa_decomposition_free(of_body);
    stltsa_clip_free(made);
}

static void refuses_points(const stltsa_points* points, stltsa_status status, const char* hint) {
    stltsa_clip* clip = NULL;
    must_fail(stltsa_clip_from_points(points, NULL, &clip), status, hint);
    assert_null(clip);
}

TEST(points_have_names_confidence_and_gaps) {
    double xy[3 * 4] = {1, 2, 3, 4, NAN, 77, 70, 80, 9, 10, 11, 12};
    double sure[3 * 2] = {1, 0.9, 1, 0.2, 0.7, 1}, times[3] = {0, 0.1, 0.2};
    const char* const names[] = {"nose", "tail"};
    stltsa_points points = {.size = sizeof points, .space = 2, .names = names, .fps = 10};
    points.positions = packed_in(xy, 3, 4);
    points.confidence = packed_in(sure, 3, 2);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_points(&points, NULL, &clip));
    assert_string_equal(get_text(stltsa_clip_info(clip), STLTSA_INFO_CHANNEL, 3), "tail_y");
    double* raw = new_channels(clip); /* gaps are filled */
    const double filled[3 * 4] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    assert_below(largest_difference(raw, filled, 12), 1e-12, "filled");
    stltsa_clip_free(clip);
    points.space = 4;
    refuses_points(&points, STLTSA_E_ARGUMENT, "2 or 3 coordinates");
    points.space = 3;
    refuses_points(&points, STLTSA_E_SHAPE, "3 columns for each point");
    points.space = 2;
    points.confidence = packed_in(sure, 2, 2);
    refuses_points(&points, STLTSA_E_SHAPE, "confidence has 2 rows");
    points.confidence.data = NULL;
    points.times = packed_in(times, 2, 1);
    refuses_points(&points, STLTSA_E_SHAPE, "times have 2 rows and 1 columns");
    points.times = packed_in(times, 3, 1);
    points.fps = 20;
    refuses_points(&points, STLTSA_E_ARGUMENT, "fps is 20, but the times are 10 a second");
    points.times.data = NULL;
    points.fps = 0;
    refuses_points(&points, STLTSA_E_ARGUMENT, "there are no times");
    points.times = packed_in(times, 3, 1);
    times[2] = 0.1;
    refuses_points(&points, STLTSA_E_ARGUMENT, "times do not increase from frame 1");
    times[1] = 1e150;
    times[2] = 2e150;
    refuses_points(&points, STLTSA_E_ARGUMENT, "the times are 1e-150 frames a second");
    times[1] = 0.1;
    times[2] = 0.2;
    xy[0] = INFINITY;
    refuses_points(&points, STLTSA_E_NOT_FINITE, "a missing point is NaN");
    points.size = 3;
    refuses_points(&points, STLTSA_E_ARGUMENT, "sizeof(stltsa_points)");
    refuses_points(NULL, STLTSA_E_ARGUMENT, "points is NULL");
}

TEST(stretches_are_clips) {
    stltsa_clip *clip = opened(), *part = NULL, *same = NULL;
    char path[4096];
    snprintf(path, sizeof path, "%s:%s", walker_path, "120-240");
    must(stltsa_clip_open_stretch(path, NULL, &part));
    must(stltsa_clip_stretch(clip, "1s-2s", NULL, &same)); /* at 120 frames a second */
    const int64_t cols = int_of(clip, STLTSA_INFO_CHANNELS);
    double *all = new_channels(clip), *a = new_channels(part), *b = new_channels(same);
    assert_int_equal(stltsa_clip_frames(part), 120);
    assert_memory_equal(a, all + 120 * cols, 120 * (size_t)cols * sizeof *a);
    assert_memory_equal(a, b, 120 * (size_t)cols * sizeof *a);
    stltsa_clip_free(same);
    stltsa_clip_free(part);
    stltsa_interval found = {0, 0, 0, 0};
    int64_t count = 0;
    stltsa_decomposition* units = decomposed(clip, NULL);
    for (int64_t u = 0; u < count_of(units, STLTSA_INFO_UNIT); ++u) {
        const stltsa_unit unit = unit_at(units, u);
        must(stltsa_clip_find(clip, stltsa_unit_name(unit.kind), NULL, 1, &found, &count));
        assert_true(count == 1 && found.begin == unit.begin && found.end == unit.end);
    }
    must(stltsa_clip_find(clip, "A", NULL, 1, &found, &count));
    const stltsa_segment segment = segment_at(units, 1);
    assert_true(count == 1 && found.begin == segment.begin && found.end == segment.end);
    must(stltsa_clip_find(clip, "segment2", NULL, 0, NULL, &count));
    assert_int_equal(count, 1);
    assert_int_equal(stltsa_clip_find(clip, "cycle99", NULL, 1, &found, &count),
                     STLTSA_E_NO_SUCH_PART);
    assert_int_equal(count, 0);
    assert_int_equal(stltsa_clip_find(clip, "repetition1", NULL, 1, &found, &count),
                     STLTSA_E_NO_SUCH_PART);
    assert_int_equal(stltsa_clip_find(clip, "QQ", NULL, 1, &found, &count), STLTSA_E_NO_SUCH_PART);
    assert_int_equal(stltsa_clip_stretch(clip, "2-1", NULL, &part), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_clip_stretch(clip, "cyclic3", NULL, &part), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_clip_stretch(clip, NULL, NULL, &part), STLTSA_E_ARGUMENT);
    assert_null(part);
}

/* The walker's cycles, several times, each from where the one before ends. */
static double* new_long_walk(const stltsa_clip* clip, int64_t times, int64_t* frames) {
    const int64_t cols = 3 * count_of(clip, STLTSA_INFO_JOINT);
    double* source = array_of(clip, STLTSA_INFO_POSITIONS);
    stltsa_interval cycles;
    int64_t count = 0;
    must(stltsa_clip_find(clip, "cyclic", NULL, 1, &cycles, &count));
    const int64_t length = cycles.end - cycles.begin;
    double* walk = new_matrix(times * length, cols);
    for (int64_t i = 0; i < times * length; ++i)
        for (int64_t c = 0; c < cols; ++c) {
            const double way =
                source[cycles.end * cols + c % 3] - source[cycles.begin * cols + c % 3];
            walk[i * cols + c] =
                source[(cycles.begin + i % length) * cols + c] + (double)(i / length) * way;
        }
    *frames = times * length;
    return walk;
}

/* A walk of which one second was not recorded: nothing continues over it. */
TEST(nothing_continues_over_a_hole) {
    stltsa_clip *clip = opened(), *made = NULL;
    int64_t frames = 0;
    const int64_t cols = 3 * count_of(clip, STLTSA_INFO_JOINT);
    double* positions = new_long_walk(clip, 4, &frames);
    const int64_t begin = frames / 2, end = begin + (int64_t)stltsa_clip_fps(clip);
    for (int64_t i = begin * cols; i < end * cols; ++i)
        positions[i] = NAN;
    stltsa_points points = {.size = sizeof points, .space = 3, .fps = stltsa_clip_fps(clip)};
    points.positions = packed_in(positions, frames, cols);
    must(stltsa_clip_from_points(&points, NULL, &made));
    stltsa_decomposition* units = decomposed(made, NULL);
    int64_t at = 0;
    for (int64_t u = 0; u < count_of(units, STLTSA_INFO_UNIT); ++u) {
        const stltsa_unit unit = unit_at(units, u);
        assert_int_equal(unit.begin, at);
        if (unit.begin < end && unit.end > begin) {
            assert_int_equal(unit.begin, begin);
            assert_int_equal(unit.end, end);
            assert_string_equal(segment_at(units, unit.segment).reason, "nothing recorded");
        }
        at = unit.end;
    }
    assert_int_equal(at, frames);
    assert_true(count_of(units, STLTSA_INFO_CYCLE) > 6); /* of 11 */
    for (int64_t c = 0; c < count_of(units, STLTSA_INFO_CYCLE); ++c) {
        const stltsa_part cycle = cycle_at(units, c);
        assert_true(cycle.end <= begin || cycle.begin >= end);
    }
    stltsa_clip_free(made);
}

TEST(a_clip_of_arrays_says_where_it_is_from) {
    const double rows[] = {0, 1, 2, 3, 4, 5};
    const stltsa_in in = packed_in(rows, 3, 2);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_matrix(&in, 30, &clip));
    must(stltsa_clip_set_path(clip, "walk.c3d"));
    assert_string_equal(text_of(clip, STLTSA_INFO_PATH), "walk.c3d");
    must(stltsa_clip_set_path(clip, NULL));
    assert_string_equal(text_of(clip, STLTSA_INFO_PATH), "");
    assert_int_equal(stltsa_clip_set_path(NULL, "walk.c3d"), STLTSA_E_ARGUMENT);
    stltsa_clip_free(clip);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(channels_of_a_skeleton_keep_every_bit),
        cmocka_unit_test(quaternions_of_a_skeleton_give_its_positions),
        cmocka_unit_test(half_turns_of_matrices_are_exact),
        cmocka_unit_test(skeletons_that_are_none),
        cmocka_unit_test(points_of_a_walker_have_its_cycles),
        cmocka_unit_test(points_have_names_confidence_and_gaps),
        cmocka_unit_test(stretches_are_clips),
        cmocka_unit_test(nothing_continues_over_a_hole),
        cmocka_unit_test(a_clip_of_arrays_says_where_it_is_from),
    };
    return run_on_walker(tests, argc, argv);
}
