// SPDX-License-Identifier: BSD-3-Clause
// The walker's body, 18 joints of three rotations each, and its pose at one moment of a walk.
#pragma once

#include <array>
#include <optional>

#include "rotation.hpp"

namespace walker {

enum Side : std::size_t { left, right };
constexpr Side other(Side side) {
    return side == left ? right : left;
}
/// Along x: 1 left, -1 right.
constexpr double sign(Side side) {
    return side == left ? 1 : -1;
}

enum Joint : std::size_t {
    hips,
    spine,
    neck,
    head,
    left_arm, ///< then forearm, hand
    right_arm = left_arm + 3,
    left_thigh = right_arm + 3, ///< then shank, foot, toes
    right_thigh = left_thigh + 4,
    joint_count = right_thigh + 4
};
constexpr std::size_t arm(Side side) {
    return side == left ? left_arm : right_arm;
}
constexpr std::size_t thigh(Side side) {
    return side == left ? left_thigh : right_thigh;
}

struct JointInfo {
    const char* name;
    int parent;                     ///< -1: root
    Vector offset = {};             ///< from the parent, in the T-pose
    std::optional<Vector> end = {}; ///< site, where no joint follows
};
using Body = std::array<JointInfo, joint_count>;
Body make_body(double height);

constexpr double toe_out = 7; ///< degrees; see README.md

/// Where a foot meets the floor, from the ankle in the foot's frame.
struct Sole {
    Vector heel;
    Vector ball;            ///< the toe joint
    double ball_height = 0; ///< above the floor when the foot is flat
};
Sole make_sole(double height);

/// What a pose depends on.
struct Moment {
    std::array<double, 2> phase{};        ///< of each leg, cycles
    double amplitude = 0;                 ///< 0: standing, 1: normal walking
    double heading = 0;                   ///< degrees about y
    std::array<double, 2> foot_heading{}; ///< the same for each foot
    double lean = 0;                      ///< of all above the ankles, forward, degrees
};

struct LegPose {
    Rotation thigh, shank, foot, toes; ///< against the world
    Vector ankle, heel, ball;          ///< from the root
};

struct Pose {
    std::array<Rotation, joint_count> local; ///< against the parent
    std::array<LegPose, 2> legs;
};
Pose make_pose(const Body& body, const Sole& sole, const Moment& moment);

} // namespace walker
