/* SPDX-License-Identifier: BSD-3-Clause */
/* New motion from a repeated cycle. */
#include "walking.h"

TEST(a_cycle_four_times) {
    stltsa_clip* clip = opened();
    const stltsa_part cycle = middle_cycle(clip);
    const int64_t length = cycle.end - cycle.begin;
    const stltsa_piece piece = {clip, cycle.begin, cycle.end, 4, 0};
    stltsa_synthesis* s = made(&piece, 1, NULL);
    assert_int_equal(count_of(s, STLTSA_INFO_SEAM), 3);
    const stltsa_seam first = seam_at(s, 0);
    const int64_t loop = first.cut_end - first.cut_begin;
    assert_true((double)llabs(loop - length) <= 0.08 * (double)length);
    assert_int_equal(first.frame, first.cut_end - cycle.begin);
    for (int i = 0; i < 3; ++i) {
        const stltsa_seam seam = seam_at(s, i);
        assert_int_equal(seam.frame, first.frame + i * loop);
        assert_true(seam.piece == 0 && seam.next == 0);
        assert_true(seam.cut_end == first.cut_end && seam.cut_begin == first.cut_begin);
        assert_true((double)llabs(seam.cut_end - cycle.end) <= 0.1 * (double)length + 1);
        assert_int_equal(seam.crossfade, llround(0.1 * (double)length));
        /* The walker's cycles are equal, except that frames fall between frames. */
        assert_below(seam.posture, 1.5, "posture");
        assert_below(seam.step, 1.1, "step");
        assert_below(seam.acceleration, 1.2, "acceleration");
    }
    assert_int_equal(stltsa_clip_frames(stltsa_synthesis_clip(s)),
                     first.cut_end - cycle.begin + 2 * loop + cycle.end - first.cut_begin);
    assert_int_equal(count_of(s, STLTSA_INFO_WARNING), 0);
}

TEST(every_joint_goes_on_and_bones_stay_rigid) {
    stltsa_clip* clip = opened();
    const stltsa_part cycle = middle_cycle(clip);
    const stltsa_piece piece = {clip, cycle.begin, cycle.end, 4, 0};
    stltsa_synthesis* s = made(&piece, 1, NULL);
    const stltsa_clip* loop = stltsa_synthesis_clip(s);
    const int64_t joints = count_of(clip, STLTSA_INFO_JOINT), frames = stltsa_clip_frames(loop);
    double *a = array_of(clip, STLTSA_INFO_POSITIONS), *b = array_of(loop, STLTSA_INFO_POSITIONS);
    for (int j = 0; j < joints; ++j) {
        assert_below(largest_step(b, frames, joints, j),
                     1.1 * largest_step(a, stltsa_clip_frames(clip), joints, j), "step");
        const stltsa_joint joint = joint_at(loop, j);
        const int64_t parent = joint.parent;
        if (parent < 0)
            continue;
        const double length = distance(a + 3 * j, a + 3 * parent, space);
        for (int64_t i = 0; i < frames; ++i)
            assert_below(
                fabs(distance(b + (i * joints + j) * 3, b + (i * joints + parent) * 3, space) -
                     length),
                1e-9, "length of a bone");
    }
    /* Each repetition travels as far as the source. */
    const double* source = a + cycle.begin * joints * 3;
    const double way = distance(source, a + cycle.end * joints * 3, floor_plane);
    assert_below(fabs(distance(b, b + (frames - 1) * joints * 3, floor_plane) / (4 * way) - 1),
                 0.02, "way");
}

TEST(a_loop_goes_on_from_and_into_its_neighbors) {
    stltsa_clip* clip = opened();
    const stltsa_part cycle = middle_cycle(clip);
    const int64_t n = stltsa_clip_frames(clip), channels = int_of(clip, STLTSA_INFO_CHANNELS);
    const stltsa_piece pieces[] = {{clip, 0, cycle.begin, 1, 0},
                                   {clip, cycle.begin, cycle.end, 3, 0},
                                   {clip, cycle.end, n, 1, 0}};
    stltsa_synthesis* s = made(pieces, 3, NULL);
    assert_int_equal(count_of(s, STLTSA_INFO_SEAM), 2);
    const stltsa_seam first = seam_at(s, 0), last = seam_at(s, 1);
    assert_true(first.piece == 1 && first.next == 1 && last.piece == 1 && last.next == 1);
    const int64_t frames = stltsa_clip_frames(stltsa_synthesis_clip(s));
    double *a = new_channels(clip), *b = new_channels(stltsa_synthesis_clip(s));
    /* Up to the first crossfade to the bit; after the last one in all channels except the root's.
     */
    assert_same_bits(a, b, (first.frame - first.crossfade) * channels);
    const int64_t tail = frames - last.frame - last.crossfade;
    for (int64_t i = 1; i <= tail; ++i)
        assert_same_bits(a + (n - i) * channels + 6, b + (frames - i) * channels + 6, channels - 6);
    assert_int_equal(n - tail, last.cut_begin + last.crossfade);
}

TEST(half_a_cycle_too_much_is_refused) {
    stltsa_clip* clip = opened();
    const stltsa_part cycle = middle_cycle(clip);
    const int64_t half = (cycle.end - cycle.begin) / 2;
    const stltsa_piece piece = {clip, cycle.begin, cycle.end + half, 2, 0};
    stltsa_synthesis* s = NULL;
    assert_int_equal(stltsa_synthesize(&piece, 1, NULL, &s), STLTSA_E_NO_COMMON_POSTURE);
    assert_null(s);
    assert_non_null(strstr(stltsa_last_error(), "pieces[0]"));
    assert_non_null(strstr(stltsa_last_error(), "seam at frame"));
    stltsa_options* options = with(STLTSA_OPT_POSTURE_LIMIT, 0);
    s = made(&piece, 1, options);
    assert_true(seam_at(s, 0).posture > 3);
    assert_true(warnings_of(s, "times as much as those of repetitions"));
}

/* Every seam of a loop has the same cuts, so facts about one hold for all. */
TEST(warnings_are_given_once) {
    stltsa_clip* clip = opened();
    const stltsa_part cycle = middle_cycle(clip);
    const int64_t half = (cycle.end - cycle.begin) / 2;
    stltsa_options* options = with(STLTSA_OPT_POSTURE_LIMIT, 0);
    stltsa_piece piece = {clip, cycle.begin, cycle.end + half, 2, 0};
    stltsa_synthesis* s = made(&piece, 1, options);
    const int64_t count = count_of(s, STLTSA_INFO_WARNING);
    assert_true(count > 0 && !warnings_of(s, "more like it"));
    piece.repeat = 20;
    s = made(&piece, 1, options);
    assert_int_equal(count_of(s, STLTSA_INFO_WARNING), count);
    assert_true(warnings_of(s, "(and 18 more like it)"));
}

static stltsa_synthesis* made_of_cycles(const stltsa_clip* clip, const stltsa_options* options) {
    stltsa_decomposition* d = decomposed(clip, NULL);
    stltsa_synthesis* s = NULL;
    must(stltsa_synthesize_loop(clip, d, options, &s));
    return keep_synthesis(s);
}

/* All three cycles; the travel is that of the clip between the cuts. */
TEST(the_loop_of_a_clip) {
    stltsa_clip* clip = opened();
    stltsa_synthesis* s = made_of_cycles(clip, NULL);
    assert_int_equal(int_of(s, STLTSA_INFO_LOOP), 1);
    assert_int_equal(int_of(s, STLTSA_INFO_LOOP_CYCLES), 3);
    assert_int_equal(int_of(s, STLTSA_INFO_SOURCE_CYCLES), 3);
    assert_true(real_of(s, STLTSA_INFO_COVERAGE) == 1);
    assert_int_equal(count_of(s, STLTSA_INFO_NOTE), 1);
    assert_int_equal(count_of(s, STLTSA_INFO_SEAM), 1);
    const stltsa_seam wrap = seam_at(s, 0);
    const int64_t frames = stltsa_clip_frames(stltsa_synthesis_clip(s));
    assert_int_equal(wrap.frame, frames);
    assert_int_equal(wrap.cut_end - wrap.cut_begin, frames);
    const int64_t joints = count_of(clip, STLTSA_INFO_JOINT);
    double* source = array_of(clip, STLTSA_INFO_POSITIONS);
    const double* from = source + wrap.cut_begin * joints * 3;
    const double* to = source + wrap.cut_end * joints * 3;
    for (int axis = 0; axis < 3; axis += 2)
        assert_below(fabs(get_real(stltsa_synthesis_info(s), STLTSA_INFO_TRAVEL, axis) -
                          (to[axis] - from[axis])),
                     1, "difference of the travel");
    assert_true(get_real(stltsa_synthesis_info(s), STLTSA_INFO_TRAVEL, 1) == 0);
    assert_below(fabs(real_of(s, STLTSA_INFO_TURN)), 0.1, "turn");
}

/* Where the first frame follows the last, no joint moves further than elsewhere. */
TEST(a_loop_in_place_ends_where_it_starts) {
    stltsa_clip* clip = opened();
    stltsa_options* options = with_int(STLTSA_OPT_IN_PLACE, 1);
    stltsa_synthesis* s = made_of_cycles(clip, options);
    assert_int_equal(int_of(s, STLTSA_INFO_IN_PLACE), 1);
    assert_true(fabs(get_real(stltsa_synthesis_info(s), STLTSA_INFO_TRAVEL, 0)) +
                    fabs(get_real(stltsa_synthesis_info(s), STLTSA_INFO_TRAVEL, 2)) >
                100); /* what was removed */
    const stltsa_clip* loop = stltsa_synthesis_clip(s);
    const int64_t frames = stltsa_clip_frames(loop), joints = count_of(loop, STLTSA_INFO_JOINT);
    double* positions = array_of(loop, STLTSA_INFO_POSITIONS);
    for (int64_t j = 0; j < joints; ++j) {
        const double step =
            distance(positions + ((frames - 1) * joints + j) * 3, positions + j * 3, space);
        double most = 0;
        for (int64_t i = 1; i < frames; ++i)
            most = fmax(most, distance(positions + ((i - 1) * joints + j) * 3,
                                       positions + (i * joints + j) * 3, space));
        assert_below(step, 1.02 * most + 1e-9, "step");
    }
}

TEST(what_is_no_loop_is_refused) {
    stltsa_clip* clip = opened();
    stltsa_options* options = with_int(STLTSA_OPT_IN_PLACE, 1);
    const stltsa_piece piece = {clip, 0, 100, 1, 0};
    stltsa_synthesis* s = NULL;
    assert_int_equal(stltsa_synthesize(&piece, 1, options, &s), STLTSA_E_ARGUMENT);
    stltsa_decomposition* d = decomposed(clip, NULL);
    assert_int_equal(stltsa_synthesize_loop(NULL, d, NULL, &s), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_synthesize_loop(clip, NULL, NULL, &s), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_synthesize_loop(clip, d, NULL, NULL), STLTSA_E_ARGUMENT);
    struct figure brief = usual_figure;
    brief.frames = 100;
    stltsa_clip* other = new_figure(brief);
    must_fail(stltsa_synthesize_loop(other, d, NULL, &s), STLTSA_E_ARGUMENT, "another clip");
    assert_null(s);
}

/* A step and a half: the whole clip, whose ends do not meet. */
TEST(without_cycles_the_ends_must_meet) {
    struct figure brief = usual_figure;
    brief.frames = 90;
    stltsa_clip* clip = new_figure(brief);
    stltsa_decomposition* d = decomposed(clip, NULL);
    assert_int_equal(count_of(d, STLTSA_INFO_CYCLE), 0);
    stltsa_synthesis* s = NULL;
    must_fail(stltsa_synthesize_loop(clip, d, NULL, &s), STLTSA_E_NO_COMMON_POSTURE,
              "no cycle was found");
    stltsa_options* options = with(STLTSA_OPT_POSTURE_LIMIT, 0);
    must(stltsa_synthesize_loop(clip, d, options, &s));
    assert_int_equal(int_of(s, STLTSA_INFO_LOOP), 1);
    assert_int_equal(count_of(s, STLTSA_INFO_LOOP_CYCLES), 0);
    stltsa_synthesis_free(s);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cycle_four_times),
        cmocka_unit_test(every_joint_goes_on_and_bones_stay_rigid),
        cmocka_unit_test(a_loop_goes_on_from_and_into_its_neighbors),
        cmocka_unit_test(half_a_cycle_too_much_is_refused),
        cmocka_unit_test(warnings_are_given_once),
        cmocka_unit_test(the_loop_of_a_clip),
        cmocka_unit_test(a_loop_in_place_ends_where_it_starts),
        cmocka_unit_test(what_is_no_loop_is_refused),
        cmocka_unit_test(without_cycles_the_ends_must_meet),
    };
    return run_on_walker(tests, argc, argv);
}
