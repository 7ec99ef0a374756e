// SPDX-License-Identifier: BSD-3-Clause
// Position and heading of the body: steps lead from one frame to the next, anywhere.
#include "clip/body/angles.hpp"
#include "clip/features/features.hpp"
#include "clip/testing.hpp"
#include "synthesis/synthesis.hpp"
#include "synthesis/testing.hpp"

using namespace synthesis_testing;
using namespace stltsa::synthesis;
using stltsa::clip::conjugate;

namespace {

constexpr double degree = std::numbers::pi / 180;

Walk turning_walk() {
    Walk walk;
    walk.turn = 170; // through the jump of angles from 180 to -180
    walk.turning = 90;
    walk.x = 300;
    return walk;
}

double angle_between(const Quaternion& a, const Quaternion& b) {
    return stltsa::clip::norm(stltsa::clip::rotation_vector(conjugate(a) * b));
}

void assert_same_place(const RootState& a, const RootState& b) {
    ASSERT_NEAR(floor_distance(a.position, b.position), 0, 1e-9);
    ASSERT_NEAR(std::remainder(angle_between(a.yaw, b.yaw), 2 * std::numbers::pi), 0, 1e-9);
}

void steps_lead_to_the_next_frame(void**) {
    const Clip clip = walking(turning_walk());
    const Body body = body_of(clip);
    const Track track = track_of(clip);
    RootState at = track.root(0);
    for (std::int64_t i = 1; i < track.frames(); ++i) {
        at = body.after(at, body.step(track.root(i - 1), track.root(i)));
        assert_same_place(at, track.root(i));
        ASSERT_NEAR(at.position[1], track.root(0).position[1], 0); // steps do not change height
    }
}

void steps_are_relative_to_the_body(void**) {
    Walk walk = turning_walk();
    const Clip clip = walking(walk);
    walk.turn = -20;
    walk.x = -50;
    walk.z = 77;
    const Clip other = walking(walk);
    const Track a = track_of(clip);
    const Track b = track_of(other);
    const Body body = body_of(clip);
    for (std::int64_t i = 1; i < a.frames(); ++i) {
        const Step one = body.step(a.root(i - 1), a.root(i));
        const Step two = body.step(b.root(i - 1), b.root(i));
        ASSERT_NEAR(one.turn, two.turn, 1e-12);
        ASSERT_NEAR(stltsa::clip::norm(one.displacement - two.displacement), 0, 1e-9);
        ASSERT_NEAR(one.displacement[2], walk.speed / walk.fps, 0.3); // forward is along z
        ASSERT_NEAR(one.displacement[1], 0, 0);
    }
}

void a_placement_takes_one_state_to_another(void**) {
    const Clip clip = walking(turning_walk());
    const Body body = body_of(clip);
    const Track track = track_of(clip);
    const RootState& from = track.root(13);
    const RootState& to = track.root(200);
    const RootState moved = body.moved(body.placement(from, to), from);
    assert_same_place(moved, to);
    ASSERT_NEAR(moved.position[1], from.position[1], 0);
    ASSERT_NEAR(angle_between(moved.tilt, from.tilt), 0, 1e-12);
}

/// Every joint has the position given by the state, and the channels of other joints do not change.
void written_states_are_read_back(void**) {
    const Clip clip = walking(turning_walk());
    const Body body = body_of(clip);
    const Track track = track_of(clip);
    const Placement placement{stltsa::clip::axis_rotation(1, 130 * degree), {40, 0, -30}};
    std::vector<double> row(channels);
    for (std::int64_t i = 0; i < track.frames(); ++i) {
        const double* source = clip.values.row(i);
        std::copy(source, source + channels, row.begin());
        body.write(body.moved(placement, track.root(i)), row.data());
        assert_true(std::equal(row.begin() + root_channels, row.end(), source + root_channels));
        for (std::size_t j = 0; j < body.skeleton().joints.size(); ++j) {
            const Vec3 before = joint_position(body.skeleton(), source, j);
            const Vec3 expected = rotate(placement.turn, before) + placement.shift;
            const Vec3 found = joint_position(body.skeleton(), row.data(), j);
            ASSERT_NEAR(stltsa::clip::norm(found - expected), 0, 1e-9);
        }
    }
}

/// The heading has the turn of the clip; the tilt has none of it.
void yaw_and_tilt_make_the_rotation(void**) {
    const Clip clip = walking(turning_walk());
    const Track track = track_of(clip);
    for (std::int64_t i = 0; i < track.frames(); ++i) {
        const RootState& root = track.root(i);
        const auto whole =
            stltsa::clip::joint_rotation(clip.skeleton->joints[0], false, clip.values.row(i));
        ASSERT_NEAR(std::abs(dot(root.yaw * root.tilt, whole)), 1, 1e-12);
        ASSERT_NEAR(root.yaw.x, 0, 1e-12);
        ASSERT_NEAR(root.yaw.z, 0, 1e-12);
        ASSERT_NEAR(root.tilt.y, 0, 1e-12);
    }
}

/// A joint above the moving one keeps its place, and the root's channels are relative to it.
void constant_joints_above_the_root(void**) {
    Clip clip = below_world(walking({}));
    const Body body = body_of(clip);
    assert_int_equal(body.root(), 1);
    assert_int_equal(body.root_channels(), world_channels + root_channels);
    assert_false(body.turns_above_root(clip.values));
    const Track track = track_of(clip);
    std::vector<double> row(clip.values.row(7), clip.values.row(7) + channels + world_channels);
    body.write(track.root(50), row.data());
    for (std::int64_t c = 0; c < world_channels + root_channels; ++c)
        ASSERT_NEAR(row[static_cast<std::size_t>(c)], clip.values(50, c), 1e-9);
    clip.values(3, 1) += 1;
    assert_false(body.turns_above_root(clip.values));
    clip.values(3, 3) += 1;
    assert_true(body.turns_above_root(clip.values));
}

/// The joint that carries the body in any of the clips does so in all.
void a_clip_that_stands_still_does_not_choose_the_root(void**) {
    Matrix rest(120, channels);
    std::fill_n(rest.row(0), 120 * channels, 0.0);
    const Clip still = below_world(clip_of(60, std::move(rest)));
    Clip walk = below_world(walking({}));
    const Piece pieces[] = {{&still, 0, 60, 1}, {&walk, 60, 180, 1}};
    Options options;
    options.posture_limit = 0;
    options.up = Axis::y;
    const Synthesis made = synthesize(pieces, options);
    for (std::int64_t i = 0; i < made.clip.frames(); ++i)
        for (std::int64_t c = 0; c < world_channels; ++c)
            ASSERT_NEAR(made.clip.values(i, c), still.values(0, c), 0);
    walk.values(100, 3) += 1;
    const Clip other = below_world(walking({}));
    const Piece moved[] = {{&other, 0, 60, 1}, {&walk, 60, 180, 1}};
    ASSERT_FAILS(stltsa::Status::unsupported, "above", synthesize(moved, options));
}

/// A joint that only travels carries the joint that turns: the path is written to the channels of
/// the one that has them.
void a_translating_joint_carries_the_root(void**) {
    Walk turning;
    turning.turning = 40;
    const Clip walk = walking(turning);
    for (const int own : {0, 1, 3}) {
        const Clip carried = below_carrier(walk, own);
        assert_int_equal(stltsa::clip::body_root(carried), 1);
        const Piece pieces[] = {{&walk, 60, 120, 4}};
        const Piece same[] = {{&carried, 60, 120, 4}};
        Options options;
        options.up = Axis::y;
        const Synthesis expected = synthesize(pieces, options);
        const Synthesis made = synthesize(same, options);
        assert_int_equal(made.clip.frames(), expected.clip.frames());
        const Matrix a = positions(expected.clip);
        const Matrix b = positions(made.clip);
        for (std::int64_t i = 0; i < a.rows(); ++i)
            for (std::int64_t c = 0; c < a.cols(); ++c)
                ASSERT_NEAR(b(i, c + 3), a(i, c), 1e-8);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(steps_lead_to_the_next_frame),
        cmocka_unit_test(steps_are_relative_to_the_body),
        cmocka_unit_test(a_placement_takes_one_state_to_another),
        cmocka_unit_test(written_states_are_read_back),
        cmocka_unit_test(yaw_and_tilt_make_the_rotation),
        cmocka_unit_test(constant_joints_above_the_root),
        cmocka_unit_test(a_clip_that_stands_still_does_not_choose_the_root),
        cmocka_unit_test(a_translating_joint_carries_the_root),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
