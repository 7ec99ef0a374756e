/* SPDX-License-Identifier: BSD-3-Clause */
/* Mapping of clips: a walk to its curve, and back to poses of the same body. */
#include "support.h"

/* A model with three coordinates, at the default rate of 30 of the clip's 120 frames per second. */
static stltsa_model* fitted(const stltsa_clip* clip, int64_t features) {
    stltsa_options* options = with_int(STLTSA_OPT_DIMENSION, 3);
    must(stltsa_options_set_int(options, STLTSA_OPT_FEATURES, features));
    stltsa_model* model = fitted_clip(clip, options);
    return model;
}

static double* new_mapped(const stltsa_model* model, const stltsa_clip* clip, double* distance,
                          int64_t* nearest) {
    const int64_t frames = stltsa_clip_frames(clip);
    double* coords = new_matrix(frames, 3);
    const stltsa_out out = packed_out(coords, frames, 3);
    const stltsa_out far = packed_out(distance, frames, 1);
    const stltsa_out found = list_out(nearest, frames);
    must(stltsa_map_clip(model, clip, NULL, &out, distance == NULL ? NULL : &far,
                         nearest == NULL ? NULL : &found));
    return coords;
}

static stltsa_clip* posed(const stltsa_model* model, const double* coords, int64_t count,
                          const stltsa_options* options) {
    const stltsa_in in = packed_in(coords, count, 3);
    stltsa_clip* poses = NULL;
    must(stltsa_unmap_clip(model, &in, NULL, options, NULL, NULL, &poses));
    return keep_clip(poses);
}

static void assert_maps_to_itself(const stltsa_clip* clip, int64_t features) {
    stltsa_model* model = fitted(clip, features);
    const int64_t frames = stltsa_clip_frames(clip);
    double* distance = new_matrix(frames, 1);
    int64_t* nearest = calloc((size_t)frames, sizeof *nearest);
    double* mapped = new_mapped(model, clip, distance, nearest);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    const int64_t first = int_of(model, STLTSA_INFO_FIRST_FRAME);
    const int64_t step = int_of(model, STLTSA_INFO_FRAME_STEP);
    assert_true(step > 1);
    for (int64_t i = 0; i < int_of(model, STLTSA_INFO_ROWS); ++i)
        assert_same_bits(mapped + 3 * (first + i * step), coords + 3 * i, 3);
    /* The frames between are of the same walk. */
    for (int64_t i = first; i < frames; ++i)
        assert_below(distance[i], 1, "distance of a frame of the fitted clip");
    free(nearest);
}

TEST(fitted_clip_gets_its_own_coordinates) {
    stltsa_clip* clip = opened();
    assert_maps_to_itself(clip, STLTSA_FEATURES_POSITIONS);
    assert_maps_to_itself(clip, STLTSA_FEATURES_ROTATIONS6D);
    assert_maps_to_itself(clip, STLTSA_FEATURES_EULER);
}

/* Also if rows are equal, except for their coordinates: standing before and after. */
TEST(equal_frames_keep_their_own_coordinates) {
    enum { frames = 300, cols = 4 };
    double* x = new_matrix(frames, cols);
    for (int64_t i = 0; i < frames; ++i)
        for (int64_t c = 0; c < cols; ++c)
            x[i * cols + c] =
                (double)((i + c * c) % 40 < 20 ? (i + c * c) % 20 : 20 - (i + c * c) % 20);
    stltsa_clip* clip = matrix_clip(x, frames, cols, 30);
    stltsa_options* options = new_options(12, 12, 3);
    must(stltsa_options_set_real(options, STLTSA_OPT_SMOOTHING, 0));
    stltsa_model* model = fitted_clip(clip, options);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    assert_true(memcmp(coords + 3 * 50, coords + 3 * 90, 3 * sizeof *coords) != 0);
    assert_memory_equal(x + 50 * cols, x + 90 * cols, cols * sizeof *x);
    double* mapped = new_mapped(model, clip, NULL, NULL);
    assert_same_bits(mapped, coords, 3 * frames);
}

static double bone(const double* positions, int64_t joint, int64_t parent) {
    const double* a = positions + 3 * joint;
    const double* b = positions + 3 * parent;
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* Points on the whole curve, and off it. */
static double* new_points(const stltsa_model* model, int64_t* count) {
    const int64_t rows = int_of(model, STLTSA_INFO_ROWS);
    double* points = array_of(model, STLTSA_INFO_COORDS);
    uint64_t seed = 21;
    for (int64_t i = 0; i < 3 * rows; ++i)
        points[i] += 0.01 * (uniform(&seed) - 0.5);
    *count = rows;
    return points;
}

TEST(bones_keep_their_lengths) {
    stltsa_clip* clip = opened();
    stltsa_model* model = fitted(clip, STLTSA_FEATURES_POSITIONS);
    int64_t count = 0;
    double* points = new_points(model, &count);
    stltsa_clip* poses = posed(model, points, count, NULL);
    const int64_t joints = count_of(clip, STLTSA_INFO_JOINT);
    assert_int_equal(count_of(poses, STLTSA_INFO_JOINT), joints);
    assert_int_equal(stltsa_clip_frames(poses), count);
    assert_true(stltsa_clip_fps(poses) == real_of(model, STLTSA_INFO_FPS));
    double* source = array_of(clip, STLTSA_INFO_POSITIONS);
    double* made = array_of(poses, STLTSA_INFO_POSITIONS);
    for (int64_t j = 1; j < joints; ++j) {
        const int64_t parent = joint_at(clip, j).parent;
        assert_int_equal(joint_at(poses, j).parent, parent);
        for (int64_t i = 0; i < count; ++i)
            assert_below(fabs(bone(made + 3 * joints * i, j, parent) - bone(source, j, parent)),
                         1e-9, "change of a bone");
    }
    /* Over the origin, at the height of a walking body. */
    for (int64_t i = 0; i < count; ++i) {
        const double* root = made + 3 * joints * i;
        assert_true(fabs(root[0]) < 1e-9 && fabs(root[2]) < 1e-9);
        assert_below(fabs(root[1] - source[1]), 15, "height against standing, in cm");
    }
}

/* Each point becomes a frame, so poses have the rate of the points; by default that of the rows. */
TEST(poses_have_the_rate_of_the_points) {
    stltsa_clip* clip = opened();
    stltsa_model* model = fitted(clip, STLTSA_FEATURES_POSITIONS);
    const int64_t frames = stltsa_clip_frames(clip);
    double* coords = new_mapped(model, clip, NULL, NULL);
    stltsa_clip* untold = posed(model, coords, frames, NULL);
    assert_true(stltsa_clip_fps(untold) == real_of(model, STLTSA_INFO_FPS));
    stltsa_options* options = with(STLTSA_OPT_FPS, stltsa_clip_fps(clip));
    stltsa_clip* told = posed(model, coords, frames, options);
    assert_true(stltsa_clip_fps(told) == stltsa_clip_fps(clip));
    assert_true(stltsa_clip_fps(told) == 4 * stltsa_clip_fps(untold));
    assert_int_equal(stltsa_clip_frames(told), frames);
}

/* The coordinates of the rows give the poses of the fitted frames. */
TEST(poses_of_the_rows_come_back) {
    stltsa_clip* clip = opened();
    stltsa_model* model = fitted(clip, STLTSA_FEATURES_POSITIONS);
    const int64_t rows = int_of(model, STLTSA_INFO_ROWS);
    const int64_t joints = count_of(clip, STLTSA_INFO_JOINT);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    stltsa_clip* poses = posed(model, coords, rows, NULL);
    double *source = array_of(clip, STLTSA_INFO_ROTATIONS),
           *made = array_of(poses, STLTSA_INFO_ROTATIONS);
    const int64_t first = int_of(model, STLTSA_INFO_FIRST_FRAME);
    const int64_t step = int_of(model, STLTSA_INFO_FRAME_STEP);
    for (int64_t i = 0; i < rows; ++i)
        for (int64_t j = 1; j < joints; ++j) { /* the root has no yaw */
            const double* a = source + 4 * ((first + i * step) * joints + j);
            const double* b = made + 4 * (i * joints + j);
            const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
            assert_below(1 - fabs(cosine), 1e-12, "turn of a joint");
        }
}

static void frames_are_features_of_the_poses(const stltsa_clip* clip, int64_t features) {
    stltsa_model* model = fitted(clip, features);
    int64_t count = 0;
    double* points = new_points(model, &count);
    stltsa_clip* poses = posed(model, points, count, NULL);
    const int64_t width = int_of(model, STLTSA_INFO_FEATURE_COUNT);
    double* frames = new_matrix(count, width);
    double* expected = new_matrix(count, width);
    const stltsa_in in = packed_in(points, count, 3);
    const stltsa_out out = packed_out(frames, count, width);
    const stltsa_out expected_out = packed_out(expected, count, width);
    must(stltsa_unmap(model, &in, NULL, NULL, &out, NULL, NULL));
    stltsa_options* options = with_int(STLTSA_OPT_FEATURES, features);
    must(stltsa_clip_features(poses, options, &expected_out));
    assert_below(largest_difference(frames, expected, count * width), 1e-9, "features");
    /* Rows are independent. */
    double* one = new_matrix(1, width);
    const stltsa_in one_in = packed_in(points + 3 * 33, 1, 3);
    const stltsa_out one_out = packed_out(one, 1, width);
    must(stltsa_unmap(model, &one_in, NULL, NULL, &one_out, NULL, NULL));
    assert_same_bits(one, frames + 33 * width, width);
}

TEST(frames_of_points_are_features_of_their_poses) {
    stltsa_clip* clip = opened();
    frames_are_features_of_the_poses(clip, STLTSA_FEATURES_POSITIONS);
    frames_are_features_of_the_poses(clip, STLTSA_FEATURES_ROTATIONS6D);
}

TEST(threads_change_nothing) {
    stltsa_clip* clip = opened();
    stltsa_model* model = fitted(clip, STLTSA_FEATURES_POSITIONS);
    int64_t count = 0;
    double* points = new_points(model, &count);
    const int64_t width = 3 * count_of(clip, STLTSA_INFO_JOINT);
    double* positions[2];
    for (int t = 0; t < 2; ++t) {
        stltsa_options* options = with_int(STLTSA_OPT_THREADS, t + 1);
        stltsa_clip* poses = posed(model, points, count, options);
        positions[t] = array_of(poses, STLTSA_INFO_POSITIONS);
    }
    assert_same_bits(positions[0], positions[1], count * width);
}

TEST(bare_numbers_have_no_poses) {
    enum { frames = 200, cols = 6 };
    double* x = new_motion(frames, cols, 31);
    const stltsa_in in = packed_in(x, frames, cols);
    stltsa_clip* numbers = NULL;
    must(stltsa_clip_from_matrix(&in, 30, &numbers));
    stltsa_options* options = new_options(20, 20, 3);
    stltsa_model *of_numbers = fitted_clip(numbers, options),
                 *of_matrix = fitted_rows(x, frames, cols, options);
    stltsa_clip* walk = opened();
    stltsa_model* of_walk = fitted(walk, STLTSA_FEATURES_POSITIONS);

    double y[3 * frames] = {0};
    const stltsa_in points = packed_in(y, 1, 3);
    stltsa_clip* poses = walk;
    assert_int_equal(stltsa_unmap_clip(of_numbers, &points, NULL, NULL, NULL, NULL, &poses),
                     STLTSA_E_UNSUPPORTED);
    assert_null(poses);
    const stltsa_in none = packed_in(y, 0, 3);
    poses = walk;
    assert_int_equal(stltsa_unmap_clip(of_walk, &none, NULL, NULL, NULL, NULL, &poses),
                     STLTSA_E_SHAPE);
    assert_null(poses);
    const stltsa_out out = packed_out(y, frames, 3);
    assert_int_equal(stltsa_map_clip(of_matrix, numbers, NULL, &out, NULL, NULL),
                     STLTSA_E_UNSUPPORTED);
    assert_int_equal(stltsa_map_clip(of_walk, numbers, NULL, &out, NULL, NULL), STLTSA_E_SHAPE);
    double* all = new_matrix(stltsa_clip_frames(walk), 3);
    const stltsa_out walk_out = packed_out(all, stltsa_clip_frames(walk), 3);
    assert_int_equal(stltsa_map_clip(of_numbers, walk, NULL, &walk_out, NULL, NULL),
                     STLTSA_E_SHAPE);
    must(stltsa_map_clip(of_numbers, numbers, NULL, &out, NULL, NULL));
    stltsa_clip_free(numbers);
}

int main(int argc, char** argv) {
    walker_path = argc > 1 ? argv[1] : "walker.bvh";
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fitted_clip_gets_its_own_coordinates),
        cmocka_unit_test(equal_frames_keep_their_own_coordinates),
        cmocka_unit_test(bones_keep_their_lengths),
        cmocka_unit_test(poses_have_the_rate_of_the_points),
        cmocka_unit_test(poses_of_the_rows_come_back),
        cmocka_unit_test(frames_of_points_are_features_of_their_poses),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(bare_numbers_have_no_poses),
    };
    return run_on_walker(tests, argc, argv);
}
