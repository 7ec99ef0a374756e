/* SPDX-License-Identifier: BSD-3-Clause */
/* Several clips fitted together as clips. */
#include "support.h"

enum { k = 36, d = 2 };

/* The walk, and part of it with another start and end, as two clips of one body. */
struct two {
    stltsa_clip* walk;
    stltsa_synthesis* made;
    const stltsa_clip* clips[2];
};

static int open_two(void** state) {
    struct two* two = calloc(1, sizeof *two);
    must(stltsa_clip_open(walker_path, NULL, &two->walk));
    const stltsa_piece piece = {two->walk, 130, stltsa_clip_frames(two->walk) - 90, 1, 0};
    must(stltsa_synthesize(&piece, 1, NULL, &two->made));
    two->clips[0] = two->walk;
    two->clips[1] = stltsa_synthesis_clip(two->made);
    *state = two;
    return 0;
}

static int free_two(void** state) {
    struct two* two = *state;
    stltsa_synthesis_free(two->made);
    stltsa_clip_free(two->walk);
    free(two);
    return 0;
}

/* Neighbors do not cross clips, so that each has the coordinates that it has alone. */
static void each_clip_has_the_coordinates_that_it_has_alone(void** state) {
    const struct two* two = *state;
    stltsa_options* options = new_options(k, k, d);
    stltsa_model* both = NULL;
    must(stltsa_fit_clips(two->clips, 2, options, &both));
    const stltsa_info* info = stltsa_model_info(both);
    assert_int_equal(stltsa_info_count(info, STLTSA_INFO_LENGTH), 2);
    assert_int_equal(stltsa_info_count(info, STLTSA_INFO_CLIP_FRAMES), 2);
    assert_int_equal(stltsa_info_count(info, STLTSA_INFO_COMPONENT), 2);
    double* coords = array_of(both, STLTSA_INFO_COORDS);
    int64_t row = 0;
    for (int64_t c = 0; c < 2; ++c) {
        stltsa_model* alone = fitted_clip(two->clips[c], options);
        const int64_t rows = int_of(alone, STLTSA_INFO_ROWS);
        double* own = array_of(alone, STLTSA_INFO_COORDS);
        assert_int_equal(get_int(info, STLTSA_INFO_LENGTH, c), rows);
        assert_int_equal(get_int(stltsa_model_info(both), STLTSA_INFO_CLIP_FRAMES, c),
                         stltsa_clip_frames(two->clips[c]));
        assert_int_equal(get_int(stltsa_model_info(both), STLTSA_INFO_FIRST_FRAME, c),
                         int_of(alone, STLTSA_INFO_FIRST_FRAME));
        for (int64_t i = 0; i < rows * d; ++i)
            assert_below(fabs(coords[row * d + i] - own[i]), 1e-8, "difference of a coordinate");
        row += rows;
    }
    assert_int_equal(int_of(both, STLTSA_INFO_ROWS), row);
    stltsa_model_free(both);
}

/* To the bit, after a way through bytes. */
static void each_clip_is_mapped_to_its_own_rows(void** state) {
    const struct two* two = *state;
    stltsa_options* options = new_options(k, k, d);
    stltsa_model* fitted = NULL;
    stltsa_model* both = NULL;
    unsigned char* bytes = NULL;
    size_t size = 0;
    must(stltsa_fit_clips(two->clips, 2, options, &fitted));
    must(stltsa_model_serialize(fitted, &bytes, &size));
    must(stltsa_model_parse(bytes, size, &both));
    double* coords = array_of(both, STLTSA_INFO_COORDS);
    int64_t row = 0;
    for (int64_t c = 0; c < 2; ++c) {
        const int64_t frames = stltsa_clip_frames(two->clips[c]);
        const int64_t first = get_int(stltsa_model_info(both), STLTSA_INFO_FIRST_FRAME, c);
        const int64_t step = get_int(stltsa_model_info(both), STLTSA_INFO_FRAME_STEP, c);
        double* mapped = new_matrix(frames, d);
        const stltsa_out out = packed_out(mapped, frames, d);
        must(stltsa_map_clip(both, two->clips[c], NULL, &out, NULL, NULL));
        for (int64_t i = 0; i < get_int(stltsa_model_info(both), STLTSA_INFO_LENGTH, c); ++i, ++row)
            assert_same_bits(mapped + d * (first + i * step), coords + d * row, d);
    }
    stltsa_free(bytes);
    stltsa_model_free(both);
    stltsa_model_free(fitted);
}

/* Its own coordinates give back the second clip's poses: its feet as far from its hips. */
static void poses_of_the_second_clip_come_back(void** state) {
    const struct two* two = *state;
    stltsa_options* options = new_options(k, k, d);
    stltsa_model* both = NULL;
    stltsa_clip* poses = NULL;
    must(stltsa_fit_clips(two->clips, 2, options, &both));
    const int64_t begin = int_of(both, STLTSA_INFO_LENGTH);
    const int64_t rows = get_int(stltsa_model_info(both), STLTSA_INFO_LENGTH, 1);
    double* coords = array_of(both, STLTSA_INFO_COORDS);
    const stltsa_in in = packed_in(coords + begin * d, rows, d);
    must(stltsa_options_set_int(options, STLTSA_OPT_COMPONENT, 1));
    must(stltsa_unmap_clip(both, &in, NULL, options, NULL, NULL, &poses));
    int64_t count = 0;
    must(stltsa_clip_feature_count(poses, NULL, &count));
    const int64_t frames = stltsa_clip_frames(two->clips[1]);
    double* wanted = new_matrix(frames, count);
    double* found = new_matrix(rows, count);
    const stltsa_out to_wanted = packed_out(wanted, frames, count);
    const stltsa_out to_found = packed_out(found, rows, count);
    must(stltsa_clip_features(two->clips[1], NULL, &to_wanted));
    must(stltsa_clip_features(poses, NULL, &to_found));
    const int64_t first = get_int(stltsa_model_info(both), STLTSA_INFO_FIRST_FRAME, 1);
    const int64_t step = get_int(stltsa_model_info(both), STLTSA_INFO_FRAME_STEP, 1);
    for (int64_t i = 0; i < rows; ++i)
        for (int64_t f = 0; f < count; ++f)
            assert_below(fabs(found[i * count + f] - wanted[(first + i * step) * count + f]), 1e-6,
                         "difference of a position");
    stltsa_clip_free(poses);
    stltsa_model_free(both);
}

static stltsa_clip* numbers(int64_t cols, double fps) {
    double* x = new_matrix(200, cols);
    for (int64_t i = 0; i < 200 * cols; ++i)
        x[i] = sin(0.1 * (double)(i / cols) + (double)(i % cols));
    stltsa_clip* clip = matrix_clip(x, 200, cols, fps);
    return clip;
}

static void assert_refused(const stltsa_clip* a, const stltsa_clip* b, stltsa_status status,
                           const char* text) {
    const stltsa_clip* clips[2] = {a, b};
    stltsa_model* model = (stltsa_model*)&model;
    must_fail(stltsa_fit_clips(clips, 2, NULL, &model), status, text);
    assert_null(model);
}

static void clips_that_do_not_go_together_are_refused(void** state) {
    const struct two* two = *state;
    stltsa_clip* three = numbers(3, 30);
    stltsa_clip* four = numbers(4, 30);
    stltsa_clip* faster = numbers(3, 40);
    stltsa_clip* nearly = numbers(3, 29.97);
    stltsa_model* model = NULL;
    assert_refused(two->walk, three, STLTSA_E_SHAPE, "only one has a skeleton");
    assert_refused(three, four, STLTSA_E_SHAPE, "clips[1] has 4 features, clips[0] has 3");
    assert_refused(three, faster, STLTSA_E_SHAPE, "clips[1] has 40 samples a second");
    assert_refused(three, NULL, STLTSA_E_ARGUMENT, "clips[1] is NULL");
    assert_int_equal(stltsa_fit_clips(NULL, 2, NULL, &model), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_fit_clips(two->clips, 0, NULL, &model), STLTSA_E_ARGUMENT);
    const stltsa_clip* alike[2] = {three, nearly};
    must(stltsa_fit_clips(alike, 2, NULL, &model));
    stltsa_model_free(model);
}

static void a_body_of_another_hierarchy_is_refused(void** state) {
    const struct two* two = *state;
    const char other[] = "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition "
                         "Zposition Zrotation Xrotation Yrotation\n End Site\n {\n  OFFSET 0 1 0\n "
                         "}\n}\nMOTION\nFrames: 2\nFrame Time: 0.0083333\n0 1 0 0 0 0\n"
                         "0 1 0 0 10 0\n";
    stltsa_clip* clip = NULL;
    must(stltsa_clip_parse(other, sizeof other - 1, STLTSA_FORMAT_BVH, NULL, NULL, &clip));
    assert_refused(two->walk, clip, STLTSA_E_SHAPE, "other joints or channels");
    stltsa_clip_free(clip);
}

static void the_dimension_of_two_clips_is_that_of_the_body(void** state) {
    const struct two* two = *state;
    stltsa_options* options = new_options(k, k, d);
    must(stltsa_options_unset(options, STLTSA_OPT_DIMENSION));
    must(stltsa_options_set_int(options, STLTSA_OPT_INTRINSIC, 1));
    stltsa_model* both = NULL;
    must(stltsa_fit_clips(two->clips, 2, options, &both));
    for (int64_t c = 0; c < 2; ++c) {
        stltsa_model* alone = fitted_clip(two->clips[c], options);
        assert_int_equal(int_of(both, STLTSA_INFO_LOCAL_PCA), int_of(alone, STLTSA_INFO_LOCAL_PCA));
    }
    stltsa_model_free(both);
}

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    walker_path = argv[1];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_clip_has_the_coordinates_that_it_has_alone),
        cmocka_unit_test(each_clip_is_mapped_to_its_own_rows),
        cmocka_unit_test(poses_of_the_second_clip_come_back),
        cmocka_unit_test(clips_that_do_not_go_together_are_refused),
        cmocka_unit_test(a_body_of_another_hierarchy_is_refused),
        cmocka_unit_test(the_dimension_of_two_clips_is_that_of_the_body),
    };
    return cmocka_run_group_tests(tests, open_two, free_two);
}
