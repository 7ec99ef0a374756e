/* SPDX-License-Identifier: BSD-3-Clause */
/* New motion from consecutive pieces and from joined clips. */
#include "walking.h"

/* ---- Consecutive pieces ---- */

TEST(units_give_the_clip_back) {
    stltsa_clip* clip = opened();
    stltsa_decomposition* d = decomposed(clip, NULL);
    stltsa_piece pieces[5];
    assert_int_equal(count_of(d, STLTSA_INFO_UNIT), 5);
    for (int i = 0; i < 5; ++i) {
        const stltsa_unit unit = unit_at(d, i);
        pieces[i] = (stltsa_piece){clip, unit.begin, unit.end, 1, 0};
    }
    stltsa_synthesis* s = made(pieces, 5, NULL);
    const stltsa_clip* again = stltsa_synthesis_clip(s);
    assert_int_equal(count_of(s, STLTSA_INFO_SEAM), 0);
    assert_int_equal(count_of(s, STLTSA_INFO_WARNING), 0);
    assert_int_equal(stltsa_clip_frames(again), stltsa_clip_frames(clip));
    assert_int_equal(int_of(again, STLTSA_INFO_FORMAT), STLTSA_FORMAT_BVH);
    assert_true(stltsa_clip_fps(again) == stltsa_clip_fps(clip));
    double *a = new_channels(clip), *b = new_channels(again);
    assert_same_bits(a, b, stltsa_clip_frames(clip) * int_of(clip, STLTSA_INFO_CHANNELS));
}

TEST(one_piece_is_its_frames) {
    stltsa_clip* clip = opened();
    const stltsa_piece piece = {clip, 100, 101, 1, 0};
    stltsa_synthesis* s = made(&piece, 1, NULL);
    assert_int_equal(stltsa_clip_frames(stltsa_synthesis_clip(s)), 1);
    const int64_t channels = int_of(clip, STLTSA_INFO_CHANNELS);
    double *a = new_channels(clip), *b = new_channels(stltsa_synthesis_clip(s));
    assert_same_bits(a + 100 * channels, b, channels);
}

/* ---- Joined clips ---- */

TEST(walks_on_from_where_it_stood) {
    struct figure there = usual_figure;
    there.turn = 130;
    there.x = 1000;
    there.z = -400;
    stltsa_clip *here = new_figure(usual_figure), *far = new_figure(there);
    const stltsa_piece near_pieces[] = {{here, 0, 300, 1, 0}, {here, 100, 400, 1, 0}};
    const stltsa_piece far_pieces[] = {{here, 0, 300, 1, 0}, {far, 100, 400, 1, 0}};
    stltsa_synthesis *a = made(near_pieces, 2, NULL), *b = made(far_pieces, 2, NULL);
    const stltsa_clip *clip_a = stltsa_synthesis_clip(a), *clip_b = stltsa_synthesis_clip(b);
    const int64_t frames = stltsa_clip_frames(clip_a), joints = count_of(clip_a, STLTSA_INFO_JOINT);
    assert_int_equal(stltsa_clip_frames(clip_b), frames);
    double *x = array_of(clip_a, STLTSA_INFO_POSITIONS),
           *y = array_of(clip_b, STLTSA_INFO_POSITIONS),
           *source = array_of(here, STLTSA_INFO_POSITIONS);
    assert_below(largest_difference(x, y, frames * joints * 3), 1e-7, "where the later clip was");
    assert_below(largest_step(x, frames, joints, 0), 1.1 * largest_step(source, 480, joints, 0),
                 "step");
    /* It walks along z all the time, for the length of its frames. */
    const stltsa_seam seam = seam_at(a, 0);
    const double way = (double)(seam.cut_end + 400 - seam.cut_begin) / 120 * 120;
    assert_below(fabs(x[(frames - 1) * joints * 3 + 2] - way), 8, "way");
    assert_below(fabs(x[(frames - 1) * joints * 3]), 1, "to the side");
}

/* The beginning of a walk is not a fault of the seam, in any order: the livelier piece sets the
   scale. */
TEST(seams_are_measured_by_the_livelier_piece) {
    struct figure standing = usual_figure;
    standing.still = 1;
    stltsa_clip *still = new_figure(standing), *walk = new_figure(usual_figure);
    stltsa_options* options = with(STLTSA_OPT_POSTURE_LIMIT, 0);
    for (int order = 0; order < 2; ++order) {
        const stltsa_piece rest = {still, 100, 300, 1, 0}, way = {walk, 100, 400, 1, 0};
        const stltsa_piece pieces[] = {order ? way : rest, order ? rest : way};
        stltsa_synthesis* s = made(pieces, 2, options);
        assert_below(seam_at(s, 0).step, 1.5, "step");
        assert_below(seam_at(s, 0).acceleration, 5, "acceleration");
    }
}

TEST(other_rates_are_resampled) {
    struct figure slow = usual_figure;
    slow.fps = 60;
    slow.frames = 240;
    stltsa_clip *fast_clip = new_figure(usual_figure), *slow_clip = new_figure(slow);
    const stltsa_piece fast[] = {{fast_clip, 0, 300, 1, 0}, {fast_clip, 100, 400, 1, 0}};
    const stltsa_piece mixed[] = {{fast_clip, 0, 300, 1, 0}, {slow_clip, 50, 200, 1, 0}};
    stltsa_synthesis *a = made(fast, 2, NULL), *b = made(mixed, 2, NULL);
    const stltsa_clip *clip_a = stltsa_synthesis_clip(a), *clip_b = stltsa_synthesis_clip(b);
    assert_true(warnings_of(b, "resampled"));
    assert_false(warnings_of(a, "resampled"));
    assert_true(stltsa_clip_fps(clip_b) == 120);
    assert_int_equal(seam_at(b, 0).cut_end, seam_at(a, 0).cut_end);
    assert_int_equal(seam_at(b, 0).cut_begin, seam_at(a, 0).cut_begin);
    assert_int_equal(stltsa_clip_frames(clip_a), stltsa_clip_frames(clip_b));
    double *x = array_of(clip_a, STLTSA_INFO_POSITIONS),
           *y = array_of(clip_b, STLTSA_INFO_POSITIONS);
    const int64_t count = stltsa_clip_frames(clip_a) * count_of(clip_a, STLTSA_INFO_JOINT) * 3;
    assert_below(largest_difference(x, y, count), 0.1, "resampled");
}

/* ---- Options ---- */

TEST(no_search_cuts_where_the_pieces_end) {
    stltsa_clip* clip = new_figure(usual_figure);
    stltsa_options* options = with(STLTSA_OPT_CUT_RANGE, 0);
    must(stltsa_options_set_real(options, STLTSA_OPT_CROSSFADE, 0.05));
    must(stltsa_options_set_real(options, STLTSA_OPT_POSTURE_LIMIT, 0));
    const stltsa_piece pieces[] = {{clip, 20, 300, 1, 0}, {clip, 100, 400, 2, 0}};
    stltsa_synthesis* s = made(pieces, 2, options);
    const stltsa_seam join = seam_at(s, 0), loop = seam_at(s, 1);
    assert_true(join.cut_end == 300 && join.cut_begin == 100 && join.frame == 280);
    assert_true(join.piece == 0 && join.next == 1 && join.crossfade == 6);
    assert_true(loop.cut_end == 400 && loop.cut_begin == 100 && loop.frame == 580);
    assert_int_equal(stltsa_clip_frames(stltsa_synthesis_clip(s)), 880);
}

TEST(where_the_clip_ends_nothing_is_blended) {
    stltsa_clip* clip = new_figure(usual_figure);
    stltsa_options* options = with(STLTSA_OPT_CUT_RANGE, 0);
    const stltsa_piece piece = {clip, 0, 480, 2, 0};
    stltsa_synthesis* s = made(&piece, 1, options);
    assert_int_equal(seam_at(s, 0).crossfade, 0);
    assert_true(warnings_of(s, "blended"));
    assert_int_equal(stltsa_clip_frames(stltsa_synthesis_clip(s)), 960);
    /* Four whole cycles: the step across the seam is like the others. */
    double* x = array_of(stltsa_synthesis_clip(s), STLTSA_INFO_POSITIONS);
    const int64_t joints = count_of(clip, STLTSA_INFO_JOINT);
    const double step = distance(x + 480 * joints * 3, x + 479 * joints * 3, floor_plane);
    assert_below(fabs(step - 1.3), 0.2, "step");
    /* No crossfade requested, no warning. */
    must(stltsa_options_set_real(options, STLTSA_OPT_CROSSFADE, 0));
    s = made(&piece, 1, options);
    assert_false(warnings_of(s, "blended"));
}

TEST(short_pieces_keep_half_their_length) {
    stltsa_clip* clip = new_figure(usual_figure);
    stltsa_options* options = with(STLTSA_OPT_POSTURE_LIMIT, 0);
    must(stltsa_options_set_real(options, STLTSA_OPT_CUT_RANGE, 3));
    must(stltsa_options_set_real(options, STLTSA_OPT_CROSSFADE, 3));
    const int64_t lengths[] = {1, 2, 3, 5, 8, 40};
    for (int l = 0; l < 6; ++l) {
        const int64_t length = lengths[l];
        const stltsa_piece pieces[] = {{clip, 10, 10 + length, 3, 0},
                                       {clip, 300, 300 + length, 2, 0},
                                       {clip, 200, 200 + length, 1, 0}};
        stltsa_synthesis* s = made(pieces, 3, options);
        const int64_t count = count_of(s, STLTSA_INFO_SEAM);
        assert_int_equal(count, 5);
        int64_t before = 0;
        for (int64_t i = 0; i <= count; ++i) {
            const int64_t frame =
                i < count ? seam_at(s, i).frame : stltsa_clip_frames(stltsa_synthesis_clip(s));
            assert_true(2 * (frame - before) >= length);
            before = frame;
        }
    }
}

static int32_t refuse(void* user, int32_t stage, double fraction) {
    (void)fraction;
    return stage == *(int32_t*)user;
}

TEST(progress_can_cancel) {
    stltsa_clip* clip = new_figure(usual_figure);
    const stltsa_piece piece = {clip, 100, 220, 2, 0};
    for (int32_t stage = STLTSA_STAGE_FEATURES; stage <= STLTSA_STAGE_SYNTHESIS;
         stage += STLTSA_STAGE_SYNTHESIS - STLTSA_STAGE_FEATURES) {
        stltsa_options* options = with_progress(refuse, &stage);
        stltsa_synthesis* s = NULL;
        assert_int_equal(stltsa_synthesize(&piece, 1, options, &s), STLTSA_E_CANCELLED);
        assert_null(s);
    }
}

/* ---- Determinism ---- */

TEST(the_same_bits_every_time) {
    stltsa_clip* clip = new_figure(usual_figure);
    const stltsa_piece pieces[] = {{clip, 0, 200, 1, 0}, {clip, 100, 220, 3, 0}};
    stltsa_synthesis *a = made(pieces, 2, NULL), *b = made(pieces, 2, NULL);
    const stltsa_clip* clip_a = stltsa_synthesis_clip(a);
    double *x = new_channels(clip_a), *y = new_channels(stltsa_synthesis_clip(b));
    assert_same_bits(x, y, stltsa_clip_frames(clip_a) * int_of(clip_a, STLTSA_INFO_CHANNELS));
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units_give_the_clip_back),
        cmocka_unit_test(one_piece_is_its_frames),
        cmocka_unit_test(walks_on_from_where_it_stood),
        cmocka_unit_test(seams_are_measured_by_the_livelier_piece),
        cmocka_unit_test(other_rates_are_resampled),
        cmocka_unit_test(no_search_cuts_where_the_pieces_end),
        cmocka_unit_test(where_the_clip_ends_nothing_is_blended),
        cmocka_unit_test(short_pieces_keep_half_their_length),
        cmocka_unit_test(progress_can_cancel),
        cmocka_unit_test(the_same_bits_every_time),
    };
    return run_on_walker(tests, argc, argv);
}
