// SPDX-License-Identifier: BSD-3-Clause
// Played and blended frames: rigid motion outside crossfades, standing feet inside.
#include "synthesis/splice.hpp"
#include "clip/body/kinematics.hpp"
#include "synthesis/footing.hpp"
#include "synthesis/testing.hpp"

using namespace synthesis_testing;
using namespace stltsa::synthesis;

namespace {

constexpr Cut cut{150, 80, 12, 0};

/// Frames [0, 150) of one track, then those of the other from 80 to 200.
Matrix joined(const Body& body, const Track& earlier, const Track& later, const Cut& at = cut) {
    Splicer splicer(body, at.end + 200 - at.begin);
    splicer.play(earlier, 0, at.end - at.crossfade);
    splicer.cross(earlier, later, at);
    splicer.play(later, at.begin + at.crossfade, 200);
    return splicer.take();
}

Walk elsewhere() {
    Walk walk;
    walk.turn = 140;
    walk.turning = 20;
    walk.x = 900;
    return walk;
}

void before_the_first_seam_bits_are_kept(void**) {
    const Clip clip = walking({});
    const Matrix made = joined(body_of(clip), track_of(clip), track_of(walking(elsewhere())));
    for (std::int64_t i = 0; i < cut.end - cut.crossfade; ++i)
        assert_memory_equal(made.row(i), clip.values.row(i), channels * sizeof(double));
}

/// All channels except the root's to the bit; the joints as one rigid body at unchanged heights.
void after_a_seam_the_source_is_moved_rigidly(void**) {
    const Clip clip = walking({});
    const Clip other = walking(elsewhere());
    const Body body = body_of(clip);
    const Matrix made = joined(body, track_of(clip), track_of(other));
    const std::int64_t shift = cut.end - cut.begin;
    const std::int64_t first = cut.begin + cut.crossfade;
    const auto place = [&](const double* row) {
        return joint_position(body.skeleton(), row, left_foot);
    };
    for (std::int64_t i = first; i < 200; ++i) {
        const double* now = made.row(i + shift);
        assert_memory_equal(now + root_channels, other.values.row(i) + root_channels,
                            (channels - root_channels) * sizeof(double));
        ASSERT_NEAR(place(now)[1], place(other.values.row(i))[1], 1e-9);
        ASSERT_NEAR(floor_distance(place(now), place(made.row(first + shift))),
                    floor_distance(place(other.values.row(i)), place(other.values.row(first))),
                    1e-8);
    }
}

/// No jumps: no joint moves faster than in the sources, inside the seam or next to it.
void no_joint_jumps(void**) {
    const Clip clip = walking({});
    Walk walk;
    walk.phase = (cut.end - cut.begin) / walk.fps; // in phase with the first
    walk.turn = 140;
    const Clip other = walking(walk);
    const Body body = body_of(clip);
    for (const std::int64_t crossfade : {0, 1, 5, 12}) {
        const Cut at{cut.end, cut.begin, crossfade, 0};
        const Matrix made = joined(body, track_of(clip), track_of(other), at);
        for (std::size_t j = 0; j < body.skeleton().joints.size(); ++j)
            for (std::int64_t i = 1; i < made.rows(); ++i) {
                const Vec3 step = joint_position(body.skeleton(), made.row(i), j) -
                                  joint_position(body.skeleton(), made.row(i - 1), j);
                const Vec3 same = joint_position(body.skeleton(), clip.values.row(i % 60 + 60), j) -
                                  joint_position(body.skeleton(), clip.values.row(i % 60 + 59), j);
                // The same walk continues: each step is that of the source at the same phase.
                ASSERT_NEAR(stltsa::clip::norm(step), stltsa::clip::norm(same), 0.02);
            }
    }
}

/// Without blending, the step across the seam is the mean of both sources' steps.
void without_a_crossfade_the_step_is_between(void**) {
    Walk walk;
    const Clip clip = walking(walk);
    walk.speed = 300;
    const Clip other = walking(walk);
    const Body body = body_of(clip);
    const Matrix made = joined(body, track_of(clip), track_of(other), {150, 80, 0, 0});
    ASSERT_NEAR(made(150, 2) - made(149, 2), (120.0 + 300.0) / 2 / 60, 0.05);
}

/// From one pose to the other, monotonically, with zero slope at the ends.
void a_crossfade_turns_one_pose_into_the_other(void**) {
    Matrix values(240, channels);
    std::fill_n(values.row(0), 240 * channels, 0.0);
    const Clip hanging = clip_of(60, values);
    for (std::int64_t i = 0; i < 240; ++i)
        values(i, 11) = -80;
    const Clip raised = clip_of(60, values);
    const Matrix made = joined(body_of(hanging), track_of(hanging), track_of(raised));
    const std::int64_t begin = cut.end - cut.crossfade;
    const std::int64_t end = cut.end + cut.crossfade;
    for (std::int64_t i = begin; i < end; ++i) {
        assert_true(made(i, 11) < made(i - 1, 11));
        ASSERT_NEAR(made(i, 11) + made(begin + end - 1 - i, 11), -80, 1e-9); // symmetric
    }
    ASSERT_NEAR(made(begin, 11), 0, 1);
    ASSERT_NEAR(made(end - 1, 11), -80, 1);
    assert_true(made(end, 11) == -80);
}

/// A body that moves over its left foot, fastest at frame `middle`: the foot rests in the world,
/// and the hips turn about it like an inverted pendulum.
Clip standing_on_the_left(double lean, std::int64_t middle) {
    Matrix values(240, channels);
    std::fill_n(values.row(0), 240 * channels, 0.0);
    for (std::int64_t i = 0; i < 240; ++i) {
        const double phase = 2 * std::numbers::pi * static_cast<double>(i - middle) / 200;
        const double angle = lean + 25 * std::sin(phase);
        const double radians = angle * std::numbers::pi / 180;
        values(i, 1) = leg * std::cos(radians);
        values(i, 2) = leg * std::sin(radians);
        values(i, 9) = angle;
        values(i, 10) = -angle; // the other leg swings
    }
    Clip clip = clip_of(60, std::move(values));
    const Vec3 first = joint_position(*clip.skeleton, clip.values.row(0), left_foot);
    const Vec3 last = joint_position(*clip.skeleton, clip.values.row(239), left_foot);
    ASSERT_NEAR(stltsa::clip::norm(first - last), 0, 1e-9); // otherwise the test is void
    return clip;
}

void a_standing_foot_does_not_slide(void**) {
    const Clip clip = standing_on_the_left(0, 150);
    const Clip other = standing_on_the_left(3, 80); // at the cut 3 degrees ahead
    const Body body = body_of(clip);
    const Matrix made = joined(body, track_of(clip), track_of(other));
    const Vec3 foot = joint_position(body.skeleton(), made.row(0), left_foot);
    for (std::int64_t i = 0; i < made.rows(); ++i) {
        const Vec3 now = joint_position(body.skeleton(), made.row(i), left_foot);
        assert_true(floor_distance(now, foot) < 0.2); // the hips are 5 apart
    }
}

void standing_joints_determine_the_offset(void**) {
    const Clip clip = standing_on_the_left(0, 150);
    const Clip other = standing_on_the_left(3, 4);
    const Track a = track_of(clip);
    const Track b = track_of(other);
    const Vec3 offset = standing_offset(a, 150, b, 80);
    const auto seen = [](const Clip& of, std::int64_t frame) { // relative to the hips
        return joint_position(*of.skeleton, of.values.row(frame), left_foot) -
               joint_position(*of.skeleton, of.values.row(frame), 0);
    };
    const Vec3 expected = seen(other, 80) - seen(clip, 150);
    assert_true(std::abs(expected[2]) > 4);
    ASSERT_NEAR(offset[2], expected[2], 0.02 * std::abs(expected[2]));
    // The same frame: no offset.
    ASSERT_NEAR(stltsa::clip::norm(standing_offset(a, 50, a, 50)), 0, 1e-12);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(before_the_first_seam_bits_are_kept),
        cmocka_unit_test(after_a_seam_the_source_is_moved_rigidly),
        cmocka_unit_test(no_joint_jumps),
        cmocka_unit_test(without_a_crossfade_the_step_is_between),
        cmocka_unit_test(a_crossfade_turns_one_pose_into_the_other),
        cmocka_unit_test(a_standing_foot_does_not_slide),
        cmocka_unit_test(standing_joints_determine_the_offset),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
