// SPDX-License-Identifier: BSD-3-Clause
// Loops: the last frame meets the first, with and without travel; which cycles make a clip's loop.
#include "clip/testing.hpp"
#include "synthesis/longest_loop.hpp"
#include "synthesis/testing.hpp"

using namespace synthesis_testing;
using namespace stltsa::synthesis;

namespace {

constexpr std::int64_t period = 60;

Synthesis looped(const Clip& clip, std::int64_t begin, std::int64_t end, std::int64_t repeat = 1,
                 Options options = {}) {
    options.loop = true;
    const Piece piece{&clip, begin, end, repeat};
    return synthesize({&piece, 1}, options);
}

Walk walk_turning(double degrees) {
    Walk walk;
    walk.seconds = 8;
    walk.turning = degrees;
    return walk;
}

/// The largest distance of the poses of two frames, in channels below the root.
double pose_difference(const Clip& a, std::int64_t i, const Clip& b, std::int64_t j) {
    double most = 0;
    for (std::int64_t c = root_channels; c < channels; ++c)
        most = std::max(most, std::abs(a.values(i, c) - b.values(j, c)));
    return most;
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

// ---- Going round ----

/// Played three times by hand, or made of three repetitions: the same poses, the same path.
void three_rounds_are_three_times_one(void**) {
    for (const double degrees : {0.0, 25.0})
        for (const std::int64_t length : {60, 63, 121})
            for (const double crossfade : {0.0, 0.1}) {
                const Clip clip = walking(walk_turning(degrees));
                Options options;
                options.crossfade = crossfade;
                const Synthesis one = looped(clip, 100, 100 + length, 1, options);
                const Synthesis three = looped(clip, 100, 100 + length, 3, options);
                const std::int64_t frames = one.clip.frames();
                assert_int_equal(three.clip.frames(), 3 * frames);
                for (std::int64_t i = 0; i < 3 * frames; ++i)
                    ASSERT_NEAR(pose_difference(three.clip, i, one.clip, i % frames), 0, 1e-9);
                ASSERT_NEAR(three.loop->turn, 3 * one.loop->turn, 1e-9);
                if (degrees == 0)
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        ASSERT_NEAR(three.loop->travel[axis], 3 * one.loop->travel[axis], 1e-6);
            }
}

void the_wrap_is_the_last_seam(void**) {
    const Clip clip = walking(walk_turning(0));
    const Synthesis made = looped(clip, 100, 160, 3);
    assert_int_equal(made.seams.size(), 3);
    const Seam& wrap = made.seams.back();
    assert_int_equal(wrap.frame, made.clip.frames());
    assert_int_equal(wrap.cut_end - wrap.cut_begin, period);
    for (const Seam& seam : made.seams)
        assert_true(seam.step < 1.05);
    const Piece pieces[] = {{&clip, 100, 160, 1}, {&clip, 300, 420, 1}};
    Options options;
    options.loop = true;
    const Synthesis two = synthesize(pieces, options);
    assert_int_equal(two.seams.size(), 2);
    assert_true(two.seams[1].piece == 1 && two.seams[1].next == 0);
    assert_int_equal(two.seams[1].frame, two.clip.frames());
    assert_true(two.loop->coverage > 0.9 && two.loop->coverage <= 1);
}

/// From a walk at 120 a second to one at 300 and back: no step is shorter or longer than theirs.
void speeds_change_gradually(void**) {
    Walk walk = walk_turning(0);
    const Clip slow = walking(walk);
    walk.speed = 300;
    const Clip fast = walking(walk);
    const Piece pieces[] = {{&slow, 100, 160, 1}, {&fast, 160, 220, 1}};
    Options options;
    options.loop = true;
    const Synthesis made = synthesize(pieces, options);
    assert_true(made.seams[1].crossfade > 3);
    double way = 0;
    for (std::int64_t i = 1; i < made.clip.frames(); ++i) {
        const double step = made.clip.values(i, 2) - made.clip.values(i - 1, 2);
        assert_true(step > 1.99 && step < 5.01);
        way += step;
    }
    const double wrap = made.loop->travel[2] - way; // from the last frame to the next
    ASSERT_NEAR(wrap, 3.5, 0.3);
}

/// Against the walk's own speed and turn.
void travel_and_turn_are_those_of_the_walk(void**) {
    const Synthesis straight = looped(walking(walk_turning(0)), 100, 160);
    ASSERT_NEAR(straight.loop->travel[2], 120, 0.5);
    ASSERT_NEAR(straight.loop->travel[0], 0, 0.5);
    assert_true(straight.loop->travel[1] == 0);
    ASSERT_NEAR(straight.loop->turn, 0, 1e-3);
    const Synthesis turning = looped(walking(walk_turning(25)), 100, 220);
    ASSERT_NEAR(turning.loop->turn * 180 / std::numbers::pi, 50, 1);
    // More than half a circle is counted as it is walked.
    const Synthesis round = looped(walking(walk_turning(100)), 60, 240);
    ASSERT_NEAR(round.loop->turn * 180 / std::numbers::pi, 300, 6);
}

// ---- In place ----

void in_place_no_joint_jumps_at_the_wrap(void**) {
    for (const double degrees : {0.0, 25.0, 100.0}) {
        Options options;
        options.in_place = true;
        const Synthesis made = looped(walking(walk_turning(degrees)), 100, 220, 1, options);
        const std::int64_t frames = made.clip.frames();
        const auto steps_of = [&](std::size_t joint) {
            std::vector<double> steps;
            for (std::int64_t i = 0; i < frames; ++i)
                steps.push_back(stltsa::clip::norm(
                    joint_position(figure(), made.clip.values.row((i + 1) % frames), joint) -
                    joint_position(figure(), made.clip.values.row(i), joint)));
            return steps;
        };
        for (std::size_t joint = 0; joint < figure().joints.size(); ++joint) {
            std::vector<double> steps = steps_of(joint);
            const double wrap = steps.back();
            steps.pop_back();
            // Half a cycle earlier the step is the mirrored one.
            assert_true(wrap <= 1.05 * *std::max_element(steps.begin(), steps.end()) + 1e-3);
        }
    }
}

/// Of a straight walk, only the mean motion is removed: pose, height and sway stay.
void in_place_only_the_path_changes(void**) {
    Options options;
    const Clip clip = walking(walk_turning(0));
    const Synthesis going = looped(clip, 100, 160, 1, options);
    options.in_place = true;
    const Synthesis made = looped(clip, 100, 160, 1, options);
    const std::int64_t frames = made.clip.frames();
    assert_int_equal(frames, going.clip.frames());
    for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(made.loop->travel[axis], going.loop->travel[axis], 1e-9);
    for (std::int64_t i = 0; i < frames; ++i) {
        assert_true(pose_difference(made.clip, i, going.clip, i) == 0);
        const double share = static_cast<double>(i) / static_cast<double>(frames);
        for (std::int64_t c = 0; c < 3; ++c)
            ASSERT_NEAR(made.clip.values(i, c),
                        going.clip.values(i, c) -
                            share * going.loop->travel[static_cast<std::size_t>(c)],
                        1e-6);
    }
}

void in_place_needs_a_loop(void**) {
    const Clip clip = walking({});
    const Piece piece{&clip, 0, 60, 1};
    Options options;
    options.in_place = true;
    ASSERT_FAILS(stltsa::Status::argument, "option loop", synthesize({&piece, 1}, options));
}

// ---- The longest loop ----

std::vector<CycleFrames> cycles_of(std::int64_t count) {
    std::vector<CycleFrames> cycles;
    for (std::int64_t i = 0; i < count; ++i)
        cycles.push_back({i * period, (i + 1) * period});
    return cycles;
}

/// A walk whose arm rises by `drift` degrees with each cycle, and by 80 in cycle `raised`.
Clip arms_rise(std::int64_t cycles, std::int64_t raised, double drift) {
    Walk walk;
    walk.seconds = static_cast<double>(cycles);
    Clip clip = walking(walk);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 11) -=
            drift * static_cast<double>(i) / period + (i >= raised * period + 20 ? 80 : 0);
    return clip;
}

/// The seam of one cycle is the smallest, because of the drift.
void the_longest_range_with_a_good_seam(void**) {
    const Clip clip = arms_rise(9, 6, 0.5);
    const LongestLoop found = longest_loop(clip, cycles_of(9), {});
    assert_int_equal(found.piece.cycles, 6);
    assert_true(found.piece.begin == 0 && found.piece.end == 6 * period);
    assert_true(contains(found.note, "cycles 1 to 6 of 9"));
}

/// With more than 66 cycles, up to three of a hundred may be missing.
void of_very_many_cycles_nearly_the_longest(void**) {
    const LongestLoop all = longest_loop(arms_rise(120, 120, 0), cycles_of(120), {});
    assert_int_equal(all.piece.cycles, 120);
    const LongestLoop most = longest_loop(arms_rise(120, 97, 0), cycles_of(120), {});
    assert_true(most.piece.cycles <= 97 && most.piece.cycles >= 94);
}

void cycles_with_something_between_make_no_loop(void**) {
    std::vector<CycleFrames> cycles = cycles_of(9);
    cycles.erase(cycles.begin() + 3);
    const LongestLoop found = longest_loop(arms_rise(9, 9, 0), cycles, {});
    assert_int_equal(found.piece.cycles, 5);
    assert_int_equal(found.piece.begin, 4 * period);
}

/// On stairs the postures meet, but not the heights.
void the_root_must_meet_as_well(void**) {
    Clip clip = arms_rise(5, 5, 0);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 1) += 0.7 * static_cast<double>(i);
    const LongestLoop found = longest_loop(clip, cycles_of(5), {});
    assert_int_equal(found.piece.cycles, 1);
    assert_true(contains(found.note, "no range"));
}

/// Up for twelve cycles, then down: only cycles 5 to 20 end at the height where they start.
void ranges_of_one_height_are_tried_first(void**) {
    Clip clip = arms_rise(20, 20, 0);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 1) -= 0.7 * std::abs(static_cast<double>(i - 12 * period));
    const LongestLoop found = longest_loop(clip, cycles_of(20), {});
    assert_int_equal(found.piece.cycles, 16);
    assert_int_equal(found.piece.begin, 4 * period);
}

void without_cycles_the_whole_clip(void**) {
    const Clip clip = walking({});
    const LongestLoop found = longest_loop(clip, {}, {});
    assert_true(found.piece.begin == 0 && found.piece.end == clip.frames());
    assert_int_equal(found.piece.cycles, 0);
    assert_true(contains(found.note, "no cycle"));
    ASSERT_FAILS(stltsa::Status::argument, "another clip", longest_loop(clip, cycles_of(5), {}));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(three_rounds_are_three_times_one),
        cmocka_unit_test(the_wrap_is_the_last_seam),
        cmocka_unit_test(speeds_change_gradually),
        cmocka_unit_test(travel_and_turn_are_those_of_the_walk),
        cmocka_unit_test(in_place_no_joint_jumps_at_the_wrap),
        cmocka_unit_test(in_place_only_the_path_changes),
        cmocka_unit_test(in_place_needs_a_loop),
        cmocka_unit_test(the_longest_range_with_a_good_seam),
        cmocka_unit_test(of_very_many_cycles_nearly_the_longest),
        cmocka_unit_test(cycles_with_something_between_make_no_loop),
        cmocka_unit_test(the_root_must_meet_as_well),
        cmocka_unit_test(ranges_of_one_height_are_tried_first),
        cmocka_unit_test(without_cycles_the_whole_clip),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
