// SPDX-License-Identifier: BSD-3-Clause
// Converts rotations to the angles of a joint's channels: forward kinematics restores them.
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clip/body/angles.hpp"
#include "clip/body/kinematics.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;

using Row = std::vector<double>;

Quaternion random_rotation(Random& random) {
    for (;;) {
        const Quaternion q{random.next(), random.next(), random.next(), random.next()};
        const double size = std::sqrt(dot(q, q));
        if (size > 0.1 && size < 1)
            return {q.w / size, q.x / size, q.y / size, q.z / size};
    }
}

/// Angle between two rotations in radians.
double apart(const Quaternion& a, const Quaternion& b) {
    const Quaternion rest = conjugate(a) * b;
    return 2 * std::atan2(norm({rest.x, rest.y, rest.z}), std::abs(rest.w));
}

/// A joint that turns in this order ("XYZ"), with position channels in between if `mixed`.
Joint joint_of(const std::string& order, bool mixed = false) {
    Joint joint;
    for (const char axis : order) {
        if (mixed)
            joint.channels.push_back(Channel::ty);
        joint.channels.push_back(static_cast<Channel>(static_cast<int>(Channel::rx) + axis - 'X'));
    }
    return joint;
}

Quaternion rotation_of(const Joint& joint, bool fixed_axes, const Row& values) {
    Skeleton skeleton;
    skeleton.fixed_axes = fixed_axes;
    skeleton.joints.push_back(joint);
    Pose pose;
    pose.place(skeleton, values.data());
    return pose.local[0];
}

/// All orders of this many axes, neighbors different.
std::vector<std::string> orders(std::size_t length) {
    std::vector<std::string> all{""};
    for (std::size_t i = 0; i < length; ++i) {
        std::vector<std::string> longer;
        for (const std::string& order : all)
            for (const char axis : {'X', 'Y', 'Z'})
                if (order.empty() || order.back() != axis)
                    longer.push_back(order + axis);
        all = longer;
    }
    return all;
}

struct Kind {
    Joint joint;
    bool fixed_axes;
};

/// Joints of these orders: about moving and fixed axes, with and without a bone axis.
std::vector<Kind> kinds(const std::vector<std::string>& all_orders) {
    Random random;
    std::vector<Kind> all;
    for (const std::string& order : all_orders)
        for (const bool fixed_axes : {false, true}) {
            all.push_back({joint_of(order), fixed_axes});
            all.push_back({joint_of(order, true), fixed_axes});
            all.back().joint.axis = random_rotation(random);
        }
    return all;
}

Row random_row(Random& random, const Joint& joint, double range) {
    Row row(joint.channels.size());
    for (double& value : row)
        value = range * random.next();
    return row;
}

void every_rotation_comes_back(void**) {
    Random random;
    std::vector<std::string> all = orders(3);
    for (const char* order : {"XYXY", "ZXYZ", "XXYZ", "XYYZ", "XYZZ", "ZXXYYX"})
        all.push_back(order);
    for (const Kind& kind : kinds(all))
        for (int repeat = 0; repeat < 50; ++repeat) {
            const Quaternion wanted = random_rotation(random);
            Row row = random_row(random, kind.joint, 400);
            const Row before = row;
            put_rotation(kind.joint, kind.fixed_axes, wanted, row.data());
            ASSERT_NEAR(apart(rotation_of(kind.joint, kind.fixed_axes, row), wanted), 0, 1e-12);
            for (std::size_t c = 0; c < row.size(); ++c)
                if (kind.joint.channels[c] == Channel::ty)
                    assert_true(row[c] == before[c]);
        }
}

void values_of_the_same_rotation_stay(void**) {
    Random random;
    for (std::size_t length = 0; length <= 3; ++length)
        for (const Kind& kind : kinds(orders(length)))
            for (const double step : {0.0, 90.0}) { // multiples of 90 include gimbal lock
                Row row = random_row(random, kind.joint, 400);
                for (double& value : row)
                    value = step == 0 ? value : step * std::round(value / step);
                const Row before = row;
                put_rotation(kind.joint, kind.fixed_axes,
                             rotation_of(kind.joint, kind.fixed_axes, row), row.data());
                assert_true(row == before);
            }
}

/// The values after a step of the rotation channels, from the values before and the rotation.
void check_step(const Kind& kind, const Row& before, const Row& after, double tolerance) {
    Row row = before;
    const Quaternion wanted = rotation_of(kind.joint, kind.fixed_axes, after);
    put_rotation(kind.joint, kind.fixed_axes, wanted, row.data());
    ASSERT_NEAR(apart(rotation_of(kind.joint, kind.fixed_axes, row), wanted), 0, 1e-12);
    for (std::size_t c = 0; c < row.size(); ++c)
        if (kind.joint.channels[c] != Channel::ty)
            ASSERT_NEAR(row[c], after[c], tolerance);
}

void near_values_are_found_again(void**) {
    Random random;
    for (std::size_t length = 1; length <= 3; ++length)
        for (const Kind& kind : kinds(orders(length)))
            for (int repeat = 0; repeat < 20; ++repeat) {
                const Row before = random_row(random, kind.joint, 700);
                Row after = before;
                for (double& value : after)
                    value += 1e-3 * random.next();
                check_step(kind, before, after, 1e-6); // gimbal lock may be near
            }
}

/// The middle angle passes through gimbal lock (90 and -90 for three different axes, 0 and 180 if
/// the first is also the last) in steps of 5 degrees, while the others move too.
void nothing_jumps_on_the_way_through_gimbal_lock(void**) {
    for (const Kind& kind : kinds(orders(3)))
        for (const double shift : {0.0, 1e-9, 1e-5, 0.01, 2.5}) {
            Row before(kind.joint.channels.size(), 0);
            const std::size_t stride = before.size() / 3;
            const auto at = [&](int i) {
                Row row(before.size(), 0);
                row[stride - 1] = 20 + 0.5 * i;
                row[2 * stride - 1] = shift - 185 + 5 * i;
                row[3 * stride - 1] = 40 - 0.7 * i;
                return row;
            };
            before = at(0);
            for (int i = 1; i < 80; ++i) {
                Row row = before;
                const Quaternion wanted = rotation_of(kind.joint, kind.fixed_axes, at(i));
                put_rotation(kind.joint, kind.fixed_axes, wanted, row.data());
                ASSERT_NEAR(apart(rotation_of(kind.joint, kind.fixed_axes, row), wanted), 0, 1e-12);
                // At gimbal lock the first angle keeps its previous value.
                for (std::size_t t = 1; t <= 3; ++t)
                    ASSERT_NEAR(row[t * stride - 1], at(i)[t * stride - 1], 1.5);
                before = row;
            }
        }
}

void in_gimbal_lock_the_first_angle_stays(void**) {
    for (const Kind& kind : kinds(orders(3))) {
        const std::size_t stride = kind.joint.channels.size() / 3;
        const bool different = kind.joint.channels[stride - 1] != kind.joint.channels.back();
        const std::size_t first = kind.fixed_axes ? 3 * stride - 1 : stride - 1;
        for (const double middle : {0.0, 180.0}) {
            Row row(kind.joint.channels.size(), 0);
            row[stride - 1] = 30;
            row[2 * stride - 1] = different ? middle - 90 : middle;
            row[3 * stride - 1] = 70;
            const Quaternion wanted = rotation_of(kind.joint, kind.fixed_axes, row);
            row[stride - 1] = 31;
            row[3 * stride - 1] = 65;
            const double before = row[first];
            put_rotation(kind.joint, kind.fixed_axes, wanted, row.data());
            ASSERT_NEAR(row[first], before, 1e-12);
            ASSERT_NEAR(apart(rotation_of(kind.joint, kind.fixed_axes, row), wanted), 0, 1e-12);
        }
    }
}

/// Joints with one or two axes get the nearest rotation: no small change comes nearer.
void the_nearest_rotation_that_a_joint_can_have(void**) {
    Random random;
    for (std::size_t length = 1; length <= 2; ++length)
        for (const Kind& kind : kinds(orders(length)))
            for (int repeat = 0; repeat < 20; ++repeat) {
                const Quaternion wanted = random_rotation(random);
                Row row = random_row(random, kind.joint, 200);
                put_rotation(kind.joint, kind.fixed_axes, wanted, row.data());
                const double least = apart(rotation_of(kind.joint, kind.fixed_axes, row), wanted);
                for (int other = 0; other < 100; ++other) {
                    Row changed = row;
                    for (double& value : changed)
                        value += (other < 50 ? 1 : 180) * random.next();
                    const double now =
                        apart(rotation_of(kind.joint, kind.fixed_axes, changed), wanted);
                    assert_true(now >= least - 1e-9);
                }
            }
}

void a_half_turn_about_another_axis_keeps_the_values(void**) {
    // All turns about x are equally far from a half turn about y.
    Row row{12.5};
    put_rotation(joint_of("X"), false, {0, 0, 1, 0}, row.data());
    ASSERT_NEAR(row[0], 12.5, 1e-12);
    // If x and y turn in this order, only their sum or difference is determined.
    Row two{12.5, 3};
    put_rotation(joint_of("XY"), false, {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}, two.data());
    ASSERT_NEAR(two[0], 12.5, 1e-12);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(every_rotation_comes_back),
        cmocka_unit_test(values_of_the_same_rotation_stay),
        cmocka_unit_test(near_values_are_found_again),
        cmocka_unit_test(nothing_jumps_on_the_way_through_gimbal_lock),
        cmocka_unit_test(in_gimbal_lock_the_first_angle_stays),
        cmocka_unit_test(the_nearest_rotation_that_a_joint_can_have),
        cmocka_unit_test(a_half_turn_about_another_axis_keeps_the_values),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
