// SPDX-License-Identifier: BSD-3-Clause
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "clip/body/kinematics.hpp"
#include "clip/features/column_owners.hpp"
#include "clip/features/drift.hpp"
#include "clip/features/features.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

/// A body whose root turns and leans, with a head above it, feet below it and arms at its sides. It
/// stands along the axis `up`.
Skeleton body(std::size_t up) {
    const std::size_t side = (up + 1) % 3, front = (up + 2) % 3;
    Skeleton skeleton;
    const auto add = [&](const char* name, int parent, double across, double high, double ahead) {
        Joint joint;
        joint.name = name;
        joint.parent = parent;
        joint.offset[side] = across;
        joint.offset[up] = high;
        joint.offset[front] = ahead;
        joint.channels = {Channel::rz, Channel::rx, Channel::ry};
        skeleton.joints.push_back(joint);
    };
    add("Hips", -1, 0, 0, 0);
    skeleton.joints[0].channels = {Channel::tx, Channel::ty, Channel::tz,
                                   Channel::rz, Channel::rx, Channel::ry};
    add("Head", 0, 0, 8, 0);
    add("LeftFoot", 0, 1, -9, 1);
    add("RightFoot", 0, -1, -9, 1);
    add("LeftHand", 0, 4, 5, 0);
    add("RightHand", 0, -4, 5, 0);
    return skeleton;
}

/// Small swings of every channel, smooth in time.
Clip swinging(std::size_t up, std::int64_t frames = 50) {
    Clip clip;
    clip.format = Format::bvh;
    clip.fps = 100;
    clip.skeleton = body(up);
    clip.values = Matrix(frames, 21);
    for (std::int64_t i = 0; i < frames; ++i)
        for (std::int64_t c = 0; c < 21; ++c)
            clip.values(i, c) = 10 * std::sin(0.1 * static_cast<double>(i * (c % 5 + 1) + c));
    return clip;
}

/// The angles z, x, y of q = Rz Rx Ry.
std::array<double, 3> zxy_angles(const Quaternion& q) {
    const Vec3 x = rotate(q, {1, 0, 0}), y = rotate(q, {0, 1, 0}), z = rotate(q, {0, 0, 1});
    return {std::atan2(-y[0], y[1]), std::asin(std::clamp(y[2], -1.0, 1.0)),
            std::atan2(-x[2], z[2])};
}

/// The clip, moved and turned about the up axis.
Clip moved(Clip clip, std::size_t up, double radians) {
    const Quaternion turn = axis_rotation(static_cast<int>(up), radians);
    Pose pose;
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        double* row = clip.values.row(i);
        pose.place(*clip.skeleton, row);
        const Vec3 at = rotate(turn, pose.position[0]) + Vec3{100, 20, -30};
        const auto angles = zxy_angles(turn * pose.world[0]);
        for (std::size_t c = 0; c < 3; ++c) {
            row[c] = at[c];
            row[3 + c] = angles[c] * 180 / std::numbers::pi;
        }
    }
    return clip;
}

void ignore_place_and_heading(void**) {
    for (const std::size_t up : {0u, 1u, 2u}) {
        const Clip clip = swinging(up);
        for (const double turn : {0.7, -2.0, 3.1, std::numbers::pi}) {
            const Clip other = moved(clip, up, turn);
            for (const Features kind :
                 {Features::positions, Features::rotations6d, Features::euler})
                check_same(features(clip, kind, static_cast<Axis>(up + 1)),
                           features(other, kind, static_cast<Axis>(up + 1)), 1e-11);
        }
    }
}

void contain_lean(void**) {
    Clip clip = swinging(1);
    const Matrix upright = features(clip, Features::positions, Axis::y);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 4) += 30; // about x: pitch
    const Matrix leaning = features(clip, Features::positions, Axis::y);
    assert_true(std::abs(leaning(0, 5) - upright(0, 5)) > 3); // the head, forward
}

void positions_are_world_positions_without_heading(void**) {
    const Clip clip = swinging(1);
    const Matrix world = positions(clip);
    const Matrix body = features(clip, Features::positions, Axis::y);
    assert_int_equal(body.cols(), 18);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::int64_t j = 0; j < 6; ++j) {
            // Height and distance from the vertical through the root do not change.
            ASSERT_NEAR(body(i, 3 * j + 1), world(i, 3 * j + 1) - world(i, 1), 1e-12);
            ASSERT_NEAR(
                std::hypot(body(i, 3 * j), body(i, 3 * j + 2)),
                std::hypot(world(i, 3 * j) - world(i, 0), world(i, 3 * j + 2) - world(i, 2)),
                1e-12);
        }
}

void rotations6d_are_columns_of_rotations(void**) {
    const Clip clip = swinging(1);
    const Matrix columns = features(clip, Features::rotations6d, Axis::y);
    assert_int_equal(columns.cols(), 36);
    Pose pose;
    pose.place(*clip.skeleton, clip.values.row(7));
    for (std::size_t j = 1; j < 6; ++j) {
        const Vec3 x = rotate(pose.local[j], {1, 0, 0}), y = rotate(pose.local[j], {0, 1, 0});
        for (std::size_t i = 0; i < 3; ++i) {
            ASSERT_NEAR(columns(7, static_cast<std::int64_t>(6 * j + i)), x[i], 1e-14);
            ASSERT_NEAR(columns(7, static_cast<std::int64_t>(6 * j + 3 + i)), y[i], 1e-14);
        }
    }
}

void euler_is_unwrapped_radians_below_the_root(void**) {
    Clip clip = swinging(1);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::int64_t c = 6; c < 21; ++c)
            clip.values(i, c) = std::remainder(20.0 * static_cast<double>(i + c), 360);
    const Matrix angles = features(clip, Features::euler, {});
    assert_int_equal(angles.cols(), 15);
    for (std::int64_t i = 1; i < angles.rows(); ++i)
        for (std::int64_t c = 0; c < angles.cols(); ++c)
            ASSERT_NEAR(angles(i, c) - angles(i - 1, c), 20 * std::numbers::pi / 180, 1e-12);
}

void raw_is_the_file(void**) {
    const Clip clip = swinging(1);
    check_same(features(clip, Features::raw, {}), clip.values, 0);
    const Clip rows = parse("1,2\n3,4\n5,7\n", Format::csv);
    check_same(features(rows, {}, {}), rows.values, 0);
    for (const Features kind : {Features::positions, Features::rotations6d, Features::euler})
        ASSERT_FAILS(Status::unsupported, "need a skeleton", features(rows, kind, Axis::y));
}

void heading_continues_through_upside_down(void**) {
    // A somersault: pitch through whole turns. The yaw is undefined at 180 degrees, and 0
    // elsewhere.
    Clip clip = swinging(1, 73);
    clip.values = Matrix(73, 21);
    for (std::int64_t i = 0; i < 73; ++i)
        clip.values(i, 4) = static_cast<double>(i) * 10;
    const Matrix body = features(clip, Features::positions, Axis::y);
    for (std::int64_t i = 0; i < 73; ++i) {
        const double angle = static_cast<double>(i) * 10 * std::numbers::pi / 180;
        ASSERT_NEAR(body(i, 4), 8 * std::cos(angle), 1e-9);
        ASSERT_NEAR(body(i, 5), 8 * std::sin(angle), 1e-9);
    }
}

void heading_stays_while_it_is_undefined(void**) {
    Clip clip = swinging(1, 2);
    clip.values = Matrix(2, 21);
    clip.values(0, 5) = 40;  // yaw alone, then
    clip.values(1, 3) = 180; // upside down
    const Matrix body = features(clip, Features::positions, Axis::y);
    const Vec3& offset = clip.skeleton->joints[2].offset;
    const Vec3 expected =
        rotate(axis_rotation(1, to_radians(-40)), {-offset[0], -offset[1], offset[2]});
    for (std::size_t i = 0; i < 3; ++i)
        ASSERT_NEAR(body(1, static_cast<std::int64_t>(6 + i)), expected[i], 1e-12);
}

void heading_of_a_root_whose_axes_are_upside_down(void**) {
    // The same motion on a rig whose root axes differ by half a turn.
    Clip clip = swinging(1);
    const Matrix expected = features(clip, Features::positions, Axis::y);
    for (Joint& joint : clip.skeleton->joints)
        joint.offset = {joint.offset[0], -joint.offset[1], -joint.offset[2]};
    const Quaternion flip{0, 1, 0, 0};
    Pose pose;
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        pose.place(*clip.skeleton, clip.values.row(i));
        const auto angles = zxy_angles(pose.world[0] * flip);
        for (std::size_t c = 0; c < 3; ++c)
            clip.values(i, static_cast<std::int64_t>(3 + c)) = angles[c] * 180 / std::numbers::pi;
    }
    const Matrix turned = features(clip, Features::positions, Axis::y);
    // Equal up to one constant turn about y, because the axes are arbitrary.
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        ASSERT_NEAR(turned(i, 4), expected(i, 4), 1e-11);
        ASSERT_NEAR(turned(i, 3), -expected(i, 3), 1e-11);
        ASSERT_NEAR(turned(i, 5), -expected(i, 5), 1e-11);
    }
}

void constant_joints_above_the_body_are_skipped(void**) {
    const Clip clip = swinging(1);
    Clip below = clip;
    Joint reference;
    reference.name = "Reference";
    reference.channels = {Channel::tx, Channel::ry};
    std::vector<Joint>& joints = below.skeleton->joints;
    for (Joint& joint : joints)
        ++joint.parent;
    joints.insert(joints.begin(), reference);
    below.values = Matrix(clip.frames(), 23);
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        below.values(i, 0) = 7;
        below.values(i, 1) = 33; // degrees, constant
        std::copy(clip.values.row(i), clip.values.row(i) + 21, below.values.row(i) + 2);
    }
    for (const Features kind : {Features::positions, Features::rotations6d, Features::euler})
        check_same(features(below, kind, Axis::y), features(clip, kind, Axis::y), 1e-11);
}

/// The heading is that of the first joint that turns, whichever joint travels through space.
void translating_joints_above_the_body_are_skipped(void**) {
    const Clip clip = swinging(1);
    Clip below = clip;
    std::vector<Joint>& joints = below.skeleton->joints;
    for (Joint& joint : joints)
        ++joint.parent;
    joints.insert(joints.begin(),
                  {"Reference", -1, {}, {Channel::tx, Channel::tz, Channel::ry}, {}, false});
    below.values = Matrix(clip.frames(), 24);
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        below.values(i, 0) = 3 * static_cast<double>(i);
        below.values(i, 1) = 5 - static_cast<double>(i);
        below.values(i, 2) = 33;
        std::copy(clip.values.row(i), clip.values.row(i) + 21, below.values.row(i) + 3);
    }
    for (const Features kind : {Features::positions, Features::rotations6d, Features::euler})
        check_same(features(below, kind, Axis::y), features(clip, kind, Axis::y), 1e-9);
}

void a_constant_root_of_several_limbs_stays_the_root(void**) {
    Clip clip = swinging(1);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        std::fill_n(clip.values.row(i), 6, 12.5);
    assert_int_equal(features(clip, Features::positions, Axis::y).cols(), 18);
}

void up_is_from_feet_to_head(void**) {
    for (const std::size_t up : {0u, 1u, 2u})
        assert_int_equal(static_cast<int>(up_axis(swinging(up), {})), up + 1);
    // Axes that point down work too.
    Clip down = swinging(2);
    for (Joint& joint : down.skeleton->joints)
        joint.offset[2] = -joint.offset[2];
    assert_true(up_axis(down, {}) == Axis::z);
    // Outstretched arms wider than the body's height do not matter.
    Clip wide = swinging(1);
    wide.skeleton->joints[4].offset[2] = 40;
    assert_true(up_axis(wide, {}) == Axis::y);
    assert_true(up_axis(wide, Axis::z) == Axis::z);
}

void up_is_the_largest_extent_without_names(void**) {
    for (const std::size_t up : {0u, 1u, 2u}) {
        Clip clip = swinging(up);
        for (Joint& joint : clip.skeleton->joints)
            joint.name = "bone";
        assert_int_equal(static_cast<int>(up_axis(clip, {})), up + 1);
    }
}

void up_follows_the_motion_not_the_rest_pose(void**) {
    // A body modelled along y, which a constant root rotation turns to stand along z.
    Clip clip = swinging(1);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::int64_t c = 3; c < 6; ++c)
            clip.values(i, c) = c == 4 ? 90 : 0;
    assert_true(up_axis(clip, {}) == Axis::z);
    clip.format = Format::amc; // y by convention
    assert_true(up_axis(clip, {}) == Axis::y);
}

void numbers_too_large_for_a_pose(void**) {
    Clip clip = swinging(1);
    clip.skeleton->joints[1].offset[1] = 1e308;
    clip.skeleton->joints[2].offset[1] = -1e308;
    clip.values(3, 1) = 1.7e308;
    ASSERT_FAILS(Status::not_finite, "frame 0", positions(clip));
    ASSERT_FAILS(Status::not_finite, "frame", features(clip, Features::positions, Axis::y));
}

void numbers_too_large_for_distances(void**) {
    const auto largest_of = [](const char* number) {
        return parse(std::string("1,2\n3,") + number + "\n", Format::csv);
    };
    assert_true(features(largest_of("-1e100"), {}, {})(1, 1) == -1e100);
    ASSERT_FAILS(Status::not_finite, "frame 1 are too large: column 1 is -1.1e+100",
                 features(largest_of("-1.1e100"), {}, {}));
}

/// Where nothing moves, a long gap is not predicted but filled.
void a_gap_in_columns_that_stay(void**) {
    std::string text;
    for (int i = 0; i < 512; ++i) // a power of two: the mean is exact
        text += i < 100 || i >= 250 ? "1,2,3\n" : "1,,3\n";
    const Matrix made = features(parse(text, Format::csv), {}, {});
    for (std::int64_t i = 0; i < made.rows(); ++i)
        assert_true(made(i, 0) == 1 && made(i, 1) == 2 && made(i, 2) == 3);
}

void clips_without_rotations(void**) {
    const Clip clip = parse("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n}\nMOTION\n"
                            "Frames: 2\nFrame Time: 1\n1\n2\n",
                            Format::bvh);
    ASSERT_FAILS(Status::unsupported, "no joint of this clip has rotations",
                 features(clip, Features::euler, {}));
    ASSERT_FAILS(Status::unsupported, "no joint of this clip has rotations",
                 features(clip, Features::rotations6d, {}));
    assert_int_equal(features(clip, Features::positions, {}).cols(), 3);
}

void features_are_counted_without_being_computed(void**) {
    Clip clip = parse(small_bvh, Format::bvh);
    for (const Features kind :
         {Features::positions, Features::rotations6d, Features::euler, Features::raw})
        assert_int_equal(feature_count(clip, kind), features(clip, kind, Axis::y).cols());
    assert_int_equal(feature_count(clip, {}), feature_count(clip, Features::positions));
    clip.values(1, 0) = std::numeric_limits<double>::infinity(); // computing a pose would fail
    assert_int_equal(feature_count(clip, Features::positions), 15);
    clip.skeleton.reset();
    assert_int_equal(feature_count(clip, {}), 10);
    ASSERT_FAILS(Status::unsupported, "need a skeleton", feature_count(clip, Features::euler));
}

/// Legs have a side; hands have none, though they hang lower than the hips.
void sides_are_those_of_the_legs(void**) {
    for (const std::size_t up : {1u, 2u}) {
        Skeleton skeleton = body(up);
        const std::size_t side = (up + 1) % 3;
        for (const int chest : {1, 1}) { // hands that hang from the head's joint
            Joint hand;
            hand.parent = chest;
            hand.offset[side] = skeleton.joints.size() % 2 == 0 ? 4 : -4;
            hand.offset[up] = -12;
            skeleton.joints.push_back(hand);
        }
        const std::size_t joints = skeleton.joints.size();
        Matrix samples(10, static_cast<std::int64_t>(3 * joints));
        for (std::int64_t i = 0; i < samples.rows(); ++i)
            for (std::size_t j = 1; j < joints; ++j)
                for (std::size_t a = 0; a < 3; ++a)
                    samples(i, static_cast<std::int64_t>(3 * j + a)) =
                        skeleton.joints[j].offset[a] +
                        (skeleton.joints[j].parent == 1 ? skeleton.joints[1].offset[a] : 0);
        Clip clip = swinging(up);
        clip.skeleton = skeleton;
        const auto axis = static_cast<Axis>(up + 1);
        const auto weights = side_weights(clip, Features::positions, axis, samples.view());
        assert_int_equal(weights.size(), samples.cols());
        const std::size_t front = (up + 2) % 3;
        for (std::size_t c = 0; c < weights.size(); ++c) {
            const bool left = c == 3 * 2 + front, right = c == 3 * 3 + front;
            ASSERT_NEAR(weights[c], left ? 1 : right ? -1 : 0, 0);
        }
        assert_true(side_weights(clip, Features::euler, axis, samples.view()).empty());
    }
}

/// Only what goes one way all the time is drift; a sway, a cycle and a new posture are not.
void drift_is_removed_from_columns_that_only_drift(void**) {
    constexpr std::int64_t rows = 1800, columns = 5;
    constexpr double fps = 30;
    Matrix samples(rows, columns);
    for (std::int64_t i = 0; i < rows; ++i) {
        const double t = static_cast<double>(i) / fps;
        const double cycle = std::sin(2 * std::numbers::pi * t);
        samples(i, 0) = static_cast<double>(i);
        samples(i, 1) = 1.3 * t + 0.05 * cycle;
        samples(i, 2) = cycle;
        samples(i, 3) = t < 30 ? 0 : 1;
        samples(i, 4) = std::sin(0.3 * t) + 0.1 * cycle;
    }
    const Matrix before = copied(samples.view());
    const std::vector<std::int64_t> expected{0, 1};
    assert_true(remove_drift(samples, fps) == expected);
    for (std::int64_t i = 0; i < rows; ++i) {
        assert_true(samples(i, 0) == 0); // no rounding errors, which could look like cycles
        ASSERT_NEAR(samples(i, 1), 0.05 * before(i, 2), 0.03);
        for (std::int64_t c = 2; c < columns; ++c)
            ASSERT_NEAR(samples(i, c), before(i, c), 0);
    }
    Matrix brief = copied(before.view().block(0, 200)); // 6.7 s say too little
    assert_true(remove_drift(brief, fps).empty());
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(sides_are_those_of_the_legs),
        cmocka_unit_test(drift_is_removed_from_columns_that_only_drift),
        cmocka_unit_test(ignore_place_and_heading),
        cmocka_unit_test(contain_lean),
        cmocka_unit_test(positions_are_world_positions_without_heading),
        cmocka_unit_test(rotations6d_are_columns_of_rotations),
        cmocka_unit_test(euler_is_unwrapped_radians_below_the_root),
        cmocka_unit_test(raw_is_the_file),
        cmocka_unit_test(heading_continues_through_upside_down),
        cmocka_unit_test(heading_stays_while_it_is_undefined),
        cmocka_unit_test(heading_of_a_root_whose_axes_are_upside_down),
        cmocka_unit_test(constant_joints_above_the_body_are_skipped),
        cmocka_unit_test(translating_joints_above_the_body_are_skipped),
        cmocka_unit_test(a_constant_root_of_several_limbs_stays_the_root),
        cmocka_unit_test(up_is_from_feet_to_head),
        cmocka_unit_test(up_is_the_largest_extent_without_names),
        cmocka_unit_test(up_follows_the_motion_not_the_rest_pose),
        cmocka_unit_test(numbers_too_large_for_a_pose),
        cmocka_unit_test(numbers_too_large_for_distances),
        cmocka_unit_test(a_gap_in_columns_that_stay),
        cmocka_unit_test(clips_without_rotations),
        cmocka_unit_test(features_are_counted_without_being_computed),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
