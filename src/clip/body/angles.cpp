// SPDX-License-Identifier: BSD-3-Clause
#include "clip/body/angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "clip/body/kinematics.hpp"
#include "clip/body/skeleton.hpp"

namespace stltsa::clip {
namespace {

constexpr double pi = std::numbers::pi;

/// Length below which the direction of a vector is rounding, so that its angle is undefined.
constexpr double undefined = 1e-13;

/// A rotation channel. A channel about the same axis as the previous one does not change; its value
/// is in `held` and adds to the angle of the previous one.
struct Turn {
    int axis;
    double* degrees;
    double held = 0;

    double before() const { return *degrees + held; }
    Quaternion rotation() const { return axis_rotation(axis, to_radians(before())); }
};

using Angles = std::array<double, 3>; // radians, one per turn

/// The turns in the order of their matrices, leftmost first.
std::vector<Turn> turns_of(const Joint& joint, bool fixed_axes, double* values) {
    std::vector<Turn> turns;
    const std::size_t count = joint.channels.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t c = fixed_axes ? count - 1 - i : i;
        if (!is_rotation(joint.channels[c]))
            continue;
        const int axis = channel_axis(joint.channels[c]);
        if (!turns.empty() && turns.back().axis == axis)
            turns.back().held += values[c];
        else
            turns.push_back({axis, &values[c]});
    }
    return turns;
}

/// 1 if axis i, axis j and the third axis are right-handed in this order, else -1.
int handedness(int i, int j) {
    return (j - i + 3) % 3 == 1 ? 1 : -1;
}

/// A vector whose direction is half the sum or half the difference of the first and the last angle.
struct Vec2 {
    double x, y;
    double length() const { return std::hypot(x, y); }
    double angle() const { return std::atan2(y, x); }
};

struct Outer {
    double first, last;
};

/// If one of the two has no direction (gimbal lock), the first angle keeps its previous value.
Outer outer_angles(const Vec2& half_sum, const Vec2& half_difference, double first_before) {
    double sum = half_sum.angle();
    double difference = half_difference.angle();
    if (half_sum.length() < undefined)
        sum = first_before - difference;
    else if (half_difference.length() < undefined)
        difference = first_before - sum;
    return {sum + difference, sum - difference};
}

/// The twist about the axis.
Angles solve_one(const Quaternion& q, const Turn& turn) {
    const Vec2 half{q.w, component(q, turn.axis)};
    return {half.length() < undefined ? to_radians(turn.before()) : 2 * half.angle()};
}

/// The product of two turns that is nearest to q: it maximizes the dot product, which is the sum of
/// a cosine of the half sum and a cosine of the half difference.
Angles solve_two(const Quaternion& q, std::span<const Turn> turns) {
    const int i = turns[0].axis;
    const int j = turns[1].axis;
    const double a = component(q, i);
    const double b = component(q, j);
    const double c = handedness(i, j) * component(q, 3 - i - j);
    const Outer outer =
        outer_angles({q.w - c, a + b}, {q.w + c, a - b}, to_radians(turns[0].before()));
    return {outer.first, outer.last};
}

/// Bernardes and Viollet, "Quaternion to Euler angles conversion", PLOS ONE 17(11), 2022. A right
/// angle about the second axis reduces three different axes to the case first, second, first.
Angles solve_three(const Quaternion& rotation, std::span<const Turn> turns) {
    const int i = turns[0].axis;
    const int j = turns[1].axis;
    const int sign = handedness(i, j);
    const bool different = turns[2].axis != i;
    const Quaternion q = different ? rotation * axis_rotation(j, -pi / 2) : rotation;
    const Vec2 half_sum{q.w, component(q, i)};
    const Vec2 half_difference{component(q, j), sign * component(q, 3 - i - j)};
    const Outer outer = outer_angles(half_sum, half_difference, to_radians(turns[0].before()));
    const double middle = 2 * std::atan2(half_difference.length(), half_sum.length());
    return different ? Angles{outer.first, middle + pi / 2, sign * outer.last}
                     : Angles{outer.first, middle, outer.last};
}

/// The other solution for the same rotation.
Angles other_solution(const Angles& angles, std::span<const Turn> turns) {
    const bool different = turns[2].axis != turns[0].axis;
    return {angles[0] + pi, (different ? pi : 0) - angles[1], angles[2] + pi};
}

/// The angles in degrees, with whole turns added to be nearest to the previous values.
struct Candidate {
    Angles degrees{};
    double distance = 0;

    Candidate(const Angles& angles, std::span<const Turn> turns) {
        for (std::size_t t = 0; t < turns.size(); ++t) {
            const double angle = angles[t] * (180 / pi);
            const double before = turns[t].before();
            degrees[t] = angle + 360 * std::round((before - angle) / 360);
            distance += (degrees[t] - before) * (degrees[t] - before);
        }
    }
};

Candidate nearest(const Quaternion& q, std::span<const Turn> turns) {
    if (turns.size() == 1)
        return {solve_one(q, turns[0]), turns};
    if (turns.size() == 2)
        return {solve_two(q, turns), turns};
    const Angles angles = solve_three(q, turns);
    const Candidate one(angles, turns);
    const Candidate other(other_solution(angles, turns), turns);
    return other.distance < one.distance ? other : one;
}

/// Whether the values represent this rotation already. They must then change neither by rounding
/// nor to other values for the same rotation.
bool is_rotation_of(const Joint& joint, bool fixed_axes, const double* values,
                    const Quaternion& local) {
    constexpr double rounding = 1e-14;
    const Quaternion difference = conjugate(joint_rotation(joint, fixed_axes, values)) * local;
    return norm({difference.x, difference.y, difference.z}) < rounding;
}

} // namespace

void put_rotation(const Joint& joint, bool fixed_axes, const Quaternion& local, double* values) {
    if (is_rotation_of(joint, fixed_axes, values, local))
        return;
    const std::vector<Turn> all = turns_of(joint, fixed_axes, values);
    std::span<const Turn> turns(all);
    Quaternion left = conjugate(joint.axis) * local * joint.axis;
    for (; turns.size() > 3; turns = turns.subspan(1)) // three are enough: the others do not change
        left = conjugate(turns[0].rotation()) * left;
    if (turns.empty())
        return;
    const Candidate best = nearest(left, turns);
    for (std::size_t t = 0; t < turns.size(); ++t)
        *turns[t].degrees = best.degrees[t] - turns[t].held;
}

void put_position(const Joint& joint, const Vec3& place, double* values) {
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
        if (is_rotation(joint.channels[c]))
            continue;
        const auto axis = static_cast<std::size_t>(channel_axis(joint.channels[c]));
        values[c] = place[axis] - (joint.adds ? joint.offset[axis] : 0);
    }
}

void put_world_position(const Skeleton& skeleton, std::size_t joint, const Vec3& place,
                        double* row) {
    const std::vector<std::size_t> begins = channel_begins(skeleton);
    std::ptrdiff_t axes = 0;
    for (int j = static_cast<int>(joint); j >= 0 && axes < 3;) {
        const auto at = static_cast<std::size_t>(j);
        const Joint& moved = skeleton.joints[at];
        Pose pose;
        pose.place(skeleton, row, joint + 1);
        Vec3 local = at == joint ? place : pose.position[at] + (place - pose.position[joint]);
        j = moved.parent;
        if (j >= 0) {
            const auto parent = static_cast<std::size_t>(j);
            local = rotate(conjugate(pose.world[parent]), local - pose.position[parent]);
        }
        put_position(moved, local, row + begins[at]);
        axes += std::count_if(moved.channels.begin(), moved.channels.end(),
                              [](Channel channel) { return !is_rotation(channel); });
    }
}

} // namespace stltsa::clip
