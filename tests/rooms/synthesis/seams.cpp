// SPDX-License-Identifier: BSD-3-Clause
// Cuts of pieces: consecutive pieces without a seam, common postures, limits for any input.
#include "synthesis/seams.hpp"
#include "clip/testing.hpp"
#include "synthesis/testing.hpp"

using namespace synthesis_testing;
using namespace stltsa::synthesis;

namespace {

// ---- Runs ----

void pieces_that_follow_each_other_are_one_run(void**) {
    const Part parts[] = {{0, 0, 10, 1}, {0, 10, 30, 1}, {0, 30, 31, 1}};
    const auto runs = make_runs(parts);
    assert_int_equal(runs.size(), 1);
    assert_true(runs[0].begin == 0 && runs[0].end == 31);
    assert_true(runs[0].first_piece == 0 && runs[0].last_piece == 2);
}

void repetitions_and_other_clips_begin_a_run(void**) {
    const Part parts[] = {{0, 5, 10, 1}, {0, 10, 30, 3}, {0, 30, 40, 1}, {1, 40, 50, 1}};
    const auto runs = make_runs(parts);
    assert_int_equal(runs.size(), 4);
    const std::int64_t borders[][2] = {{5, 30}, {10, 30}, {10, 40}, {40, 50}};
    const std::int64_t pieces[][2] = {{0, 1}, {1, 1}, {1, 2}, {3, 3}};
    for (std::size_t i = 0; i < 4; ++i) {
        assert_true(runs[i].begin == borders[i][0] && runs[i].end == borders[i][1]);
        assert_true(runs[i].first_piece == pieces[i][0] && runs[i].last_piece == pieces[i][1]);
    }
    assert_int_equal(runs[3].track, 1);
}

// ---- Cuts ----

Join join_of(const Track& earlier, std::int64_t from, std::int64_t end, const Track& later,
             std::int64_t begin, std::int64_t to) {
    return {&earlier, &later, end, begin, end - from, to - begin, {}};
}

/// The later clip shows the same cycle at another phase: a cut there is invisible.
void the_same_posture_is_found(void**) {
    Walk walk;
    walk.seconds = 6;
    const Track earlier = track_of(walking(walk));
    for (const int frames : {0, 7, 23, 30, 44, 59}) {
        walk.phase = frames / walk.fps;
        const Track later = track_of(walking(walk));
        const Join join = join_of(earlier, 60, 200, later, 100, 300);
        const Cut cut = find_cut(join, {30, 9, 0.1});
        // Frame e there is frame b here: e - b frames of phase, up to whole cycles.
        assert_int_equal((cut.end - cut.begin - frames + 600) % 60, 0);
        ASSERT_NEAR(cut.distance, 0, 1e-6);
        assert_int_equal(cut.crossfade, 9);
    }
}

/// Without velocities, a leg that swings forward looks like one that swings back.
void velocities_distinguish_forward_from_backward(void**) {
    Walk walk;
    walk.seconds = 6;
    const Track track = track_of(walking(walk));
    const Join join = join_of(track, 60, 195, track, 150, 300);
    const Cut cut = find_cut(join, {14, 0, 0.1});
    for (std::int64_t end = 195 - 14; end <= 195 + 14; ++end)
        for (std::int64_t begin = 150 - 14; begin <= 150 + 14; ++begin)
            assert_true(cut.distance <=
                        std::sqrt(squared_distance(track, end, track, begin, 0.1)) + 1e-9);
}

void limits_hold_for_any_join(void**) {
    const Track track = track_of(walking({}));
    const std::int64_t frames = track.frames();
    clip_testing::Random random;
    const auto below = [&](std::int64_t bound) {
        return static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(bound)));
    };
    for (int i = 0; i < 300; ++i) {
        const std::int64_t end = 1 + below(frames);
        const std::int64_t begin = below(frames);
        Join join{&track, &track, end, begin, 1 + below(end), 1 + below(frames - begin), {}};
        const CutOptions options{below(20), below(20), 0.1};
        const Cut cut = find_cut(join, options);
        assert_true(std::abs(cut.end - end) <= options.search);
        assert_true(std::abs(cut.begin - begin) <= options.search);
        assert_true(cut.end >= 1 && cut.end <= frames && cut.begin >= 0 && cut.begin < frames);
        // The cuts and crossfades of a run leave at least half of its length.
        assert_true(end - cut.end <= join.earlier_length / 4);
        assert_true(cut.begin - begin <= join.later_length / 4);
        assert_true(cut.crossfade >= 0 && cut.crossfade <= options.crossfade);
        assert_true(cut.crossfade <= join.earlier_length / 4);
        assert_true(cut.end + cut.crossfade <= frames && cut.begin - cut.crossfade >= 0);
        assert_true(cut.begin + cut.crossfade <= frames && cut.end - cut.crossfade >= 0);
    }
}

/// The pair at a clip's start is slightly more similar, but leaves no room for the crossfade.
void a_crossfade_has_room_if_possible(void**) {
    Walk walk;
    walk.period = 1e9;
    walk.speed = 0;
    const Track hanging = track_of(walking(walk));
    walk.arms = 10;
    Clip rising = walking(walk);
    for (std::int64_t i = 0; i < rising.frames(); ++i)
        rising.values(i, 11) -= 0.01 * static_cast<double>(i);
    const Track raised = track_of(rising);
    const Join join = join_of(hanging, 40, 218, raised, 2, 200);
    assert_int_equal(find_cut(join, {20, 0, 0.1}).begin, 0);
    assert_int_equal(find_cut(join, {20, 9, 0.1}).crossfade, 9);
}

void a_repetition_keeps_its_length(void**) {
    Walk walk;
    walk.turning = 5;
    const Track track = track_of(walking(walk));
    Join join = join_of(track, 60, 130, track, 60, 130); // ten frames more than a cycle
    join.lengths = lengths_repeated(70);
    const Cut cut = find_cut(join, {40, 0, 0.1});
    assert_true(std::abs(cut.end - cut.begin - 70) <= 5); // 8 % of 70
}

void half_of_the_frames_left_out_stay_out(void**) {
    constexpr double cycle = 60;
    for (std::int64_t asked = 1; asked < 200; ++asked)
        for (const std::int64_t sign : {1, -1}) {
            const Lengths lengths = lengths_left_out(sign * asked, cycle);
            const std::int64_t least =
                asked <= 30 ? asked : std::max<std::int64_t>(30, (asked + 1) / 2);
            assert_true(lengths.allow(sign * least));
            assert_true(lengths.allow(sign * 1000));
            for (std::int64_t fewer = -1000; fewer < least; ++fewer)
                assert_false(lengths.allow(sign * fewer));
        }
    for (const std::int64_t any : {-5, 0, 5}) // nothing is left out
        assert_true(lengths_left_out(0, cycle).allow(any));
}

/// Frames that are left out, or played twice, must not return: the same frame is the most similar
/// of all.
void frames_left_out_stay_out(void**) {
    const Track track = track_of(walking({})); // cycles of 60 frames
    for (const int skip : {1, 10, 45, 60, 75, 90, -1, -10, -45, -60, -75}) {
        const std::vector<Track> tracks{track, track};
        for (const std::size_t other : {0U, 1U}) { // the same clip, read twice
            const Part parts[] = {{0, 0, 120, 1}, {other, 120 + skip, 240, 1}};
            const Cut cut = choose_cuts(tracks, parts, make_runs(parts), {})[0].cut;
            const std::int64_t skipped = cut.begin - cut.end;
            assert_true(skip > 0 ? skipped > 0 : skipped < 0);
            assert_true(2 * std::abs(skipped) >= std::abs(skip));
            if (std::abs(skip) < 30)
                assert_true(std::abs(skipped) >= std::abs(skip));
            if (std::abs(skip) > 30)
                assert_int_equal(skipped % 60, 0); // the same posture, whole cycles away
        }
    }
}

/// A T-pose at the start of a clip that is only slightly longer leaves no choice of cuts.
void without_a_choice_cuts_stay_where_they_are(void**) {
    Walk walk;
    walk.seconds = 16 / walk.fps;
    Track track = track_of(walking(walk));
    track.first = 3;
    const Join join{&track, &track, 16, 0, 16, 16, lengths_repeated(16)};
    const Cut cut = find_cut(join, {4, 2, 0.1});
    assert_true(cut.end == 16 && cut.begin == 0);
}

/// Neither a crossfade nor a cut may reach into the T-pose at a clip's start.
void a_t_pose_is_not_blended(void**) {
    Clip clip = walking({});
    for (std::int64_t c = root_channels; c < channels; ++c)
        clip.values(0, c) = c == 11 ? -90 : 0;
    const Track track = track_of(clip);
    assert_true(track.first >= 1 && track.first <= 3);
    const Join join = join_of(track, 60, 180, track, 0, 200);
    for (const std::int64_t search : {0, 4, 8, 25}) {
        const Cut cut = find_cut(join, {search, 9, 0.1});
        assert_true(cut.begin - cut.crossfade >= (search == 0 ? 0 : track.first));
    }
    // Not even if the T-pose is the most similar.
    Clip posing = clip;
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        std::copy_n(clip.values.row(0), channels, posing.values.row(i));
    const Track earlier = track_of(posing);
    const Join alike = join_of(earlier, 60, 180, track, 0, 200);
    assert_true(find_cut(alike, {25, 0, 0}).begin >= track.first);
}

// ---- Choice of cuts ----

/// Clips joined as a whole can be cut in one direction only: a search over half a cycle still
/// reaches every phase.
void whole_clips_meet_at_any_phase(void**) {
    for (const double phase : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        Walk walk;
        walk.period = 2;
        walk.seconds = 10;
        const Clip first = walking(walk);
        walk.phase = phase;
        const Clip second = walking(walk);
        const std::vector<Track> tracks{track_of(first), track_of(second)};
        const Part parts[] = {{0, 0, 600, 1}, {1, 0, 600, 1}};
        const auto runs = make_runs(parts);
        const auto cuts = choose_cuts(tracks, parts, runs, {});
        assert_int_equal(cuts.size(), 1);
        assert_true(cuts[0].posture < 1);
    }
}

void repetitions_have_the_same_cut(void**) {
    const std::vector<Track> tracks{track_of(walking({}))};
    const Part parts[] = {{0, 60, 119, 4}};
    const auto runs = make_runs(parts);
    const auto cuts = choose_cuts(tracks, parts, runs, {});
    assert_int_equal(cuts.size(), 3);
    for (const ChosenCut& chosen : cuts) {
        assert_int_equal(chosen.cut.end - chosen.cut.begin, 60); // a whole cycle, one frame more
        assert_true(chosen.cut.end == cuts[0].cut.end);
        assert_true(chosen.posture < 1);
    }
}

/// A file in other units has the same postures.
void postures_do_not_depend_on_the_unit(void**) {
    Walk walk;
    walk.arms = 15;
    Clip clip = walking({});
    Clip other = walking(walk);
    double before = 0;
    for (int pass = 0; pass < 2; ++pass) {
        const std::vector<Track> tracks{track_of(clip), track_of(other)};
        const Part parts[] = {{0, 0, 120, 1}, {1, 120, 240, 1}};
        const auto cuts = choose_cuts(tracks, parts, make_runs(parts), {});
        if (pass > 0)
            ASSERT_NEAR(cuts[0].posture, before, 1e-6 * before);
        before = cuts[0].posture;
        for (Clip* scaled : {&clip, &other}) {
            for (Joint& joint : scaled->skeleton->joints)
                joint.offset = stltsa::clip::operator*(0.01, joint.offset);
            for (std::int64_t i = 0; i < scaled->frames(); ++i)
                for (std::int64_t c = 0; c < 3; ++c)
                    scaled->values(i, c) *= 0.01;
        }
    }
    assert_true(before > 1);
}

/// Posture is measured in repetitions: twice the difference gives twice the value.
void postures_are_measured_by_repetitions(void**) {
    const Clip clip = walking({});
    Options options;
    options.search = 0;
    double before = 0;
    for (const double arms : {5.0, 10.0, 20.0, 40.0}) {
        Walk raised;
        raised.arms = arms;
        const std::vector<Track> tracks{track_of(clip), track_of(walking(raised))};
        const Part parts[] = {{0, 0, 120, 1}, {1, 120, 240, 1}};
        const auto cuts = choose_cuts(tracks, parts, make_runs(parts), options);
        if (before > 0)
            ASSERT_NEAR(cuts[0].posture / before, 2, 0.15);
        before = cuts[0].posture;
    }
    assert_true(before > 3);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(pieces_that_follow_each_other_are_one_run),
        cmocka_unit_test(repetitions_and_other_clips_begin_a_run),
        cmocka_unit_test(the_same_posture_is_found),
        cmocka_unit_test(velocities_distinguish_forward_from_backward),
        cmocka_unit_test(limits_hold_for_any_join),
        cmocka_unit_test(a_crossfade_has_room_if_possible),
        cmocka_unit_test(a_repetition_keeps_its_length),
        cmocka_unit_test(half_of_the_frames_left_out_stay_out),
        cmocka_unit_test(frames_left_out_stay_out),
        cmocka_unit_test(without_a_choice_cuts_stay_where_they_are),
        cmocka_unit_test(a_t_pose_is_not_blended),
        cmocka_unit_test(whole_clips_meet_at_any_phase),
        cmocka_unit_test(repetitions_have_the_same_cut),
        cmocka_unit_test(postures_do_not_depend_on_the_unit),
        cmocka_unit_test(postures_are_measured_by_repetitions),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
