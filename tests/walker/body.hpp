// SPDX-License-Identifier: BSD-3-Clause
// The walker's body, 18 joints with three rotations each, and its pose at one moment of a walk.
#pragma once

#include <array>
#include <optional>

#include "rotation.hpp"

namespace walker {

enum Side : std::size_t { left, right };
constexpr Side other(Side side) {
    return side == left ? right : left;
}
/// Sign along x: 1 left, -1 right.
constexpr double sign(Side side) {
    return side == left ? 1 : -1;
}

enum Joint : std::size_t {
    hips,
    spine,
    neck,
    head,
    left_arm, ///< followed by the forearm and the hand
    right_arm = left_arm + 3,
    left_thigh = right_arm + 3, ///< followed by the shank, the foot and the toes
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
    std::optional<Vector> end = {}; ///< end site, if no joint follows
};
using Body = std::array<JointInfo, joint_count>;
Body make_body(double height);

constexpr double toe_out = 7; ///< degrees; see README.md

/// Contact points of a foot, from the ankle in the foot's frame.
struct Sole {
    Vector heel;
    Vector ball;            ///< the toe joint
    double ball_height = 0; ///< above the floor when the foot is flat
};
Sole make_sole(double height);

/// The variables of a pose.
struct Moment {
    std::array<double, 2> phase{};        ///< of each leg, cycles
    double amplitude = 0;                 ///< 0: standing, 1: normal walking
    double heading = 0;                   ///< degrees about y
    std::array<double, 2> foot_heading{}; ///< degrees about y, for each foot
    double lean = 0;                      ///< forward lean of everything above the ankles, degrees
};

struct LegPose {
    Rotation thigh, shank, foot, toes; ///< in the world
    Vector ankle, heel, ball;          ///< from the root
};

struct Pose {
    std::array<Rotation, joint_count> local; ///< relative to the parent
    std::array<LegPose, 2> legs;
};
Pose make_pose(const Body& body, const Sole& sole, const Moment& moment);

} // namespace walker
