// SPDX-License-Identifier: BSD-3-Clause
// Shared by the tests of src/synthesis: a walking figure.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "assertions.hpp"
#include "clip/body/heading.hpp"
#include "clip/clip.hpp"
#include "synthesis/track.hpp"

namespace synthesis_testing {

using stltsa::Matrix;
using stltsa::clip::Axis;
using stltsa::clip::Channel;
using stltsa::clip::Clip;
using stltsa::clip::Joint;
using stltsa::clip::Skeleton;
using stltsa::clip::Vec3;
using stltsa::synthesis::Body;
using stltsa::synthesis::Track;
using stltsa::synthesis::operator-;

inline constexpr double leg = 90;
inline constexpr std::size_t left_leg = 3;
inline constexpr std::size_t left_foot = 4; ///< the leg's end
inline constexpr std::int64_t channels = 15;
inline constexpr std::int64_t root_channels = 6;

/// Hips, head, two legs and an arm with a hand, y up.
inline Skeleton figure() {
    using enum Channel;
    const std::vector<Channel> turns{rz, rx, ry};
    Skeleton skeleton;
    skeleton.joints = {{"Hips", -1, {}, {tx, ty, tz, ry, rx, rz}, {}, false},
                       {"Head", 0, {0, 50, 0}, turns, {}, false},
                       {"", 1, {0, 20, 0}, {}, {}, true},
                       {"LeftLeg", 0, {10, 0, 0}, {rx}, {}, false},
                       {"", 3, {0, -leg, 0}, {}, {}, true},
                       {"RightLeg", 0, {-10, 0, 0}, {rx}, {}, false},
                       {"", 5, {0, -leg, 0}, {}, {}, true},
                       {"Arm", 0, {20, 45, 0}, {rx}, {}, false},
                       {"Hand", 7, {0, -30, 0}, turns, {}, false},
                       {"", 8, {0, -8, 3}, {}, {}, true}};
    return skeleton;
}

struct Walk {
    double fps = 60;
    double seconds = 4;
    double period = 1;
    double phase = 0;   ///< share of the cycle at the start
    double turn = 0;    ///< degrees about the up axis, at the start
    double turning = 0; ///< degrees per second
    double x = 0, z = 0;
    double speed = 120;
    double arms = 0; ///< degrees by which the arm is raised
};

inline Clip clip_of(double fps, Matrix values) {
    Clip clip;
    clip.format = stltsa::clip::Format::bvh;
    clip.fps = fps;
    clip.skeleton = figure();
    clip.values = std::move(values);
    return clip;
}

inline Clip walking(const Walk& walk) {
    constexpr double pi = std::numbers::pi;
    Matrix values(std::llround(walk.seconds * walk.fps), channels);
    double x = walk.x;
    double z = walk.z;
    for (std::int64_t i = 0; i < values.rows(); ++i) {
        const double t = static_cast<double>(i) / walk.fps;
        const double swing = std::sin(2 * pi * (t / walk.period + walk.phase));
        const double turn = walk.turn + walk.turning * t;
        const double row[channels] = {x,          leg + 2 * swing,
                                      z,          turn,
                                      3 * swing,  2 * swing * swing,
                                      0,          5 * swing,
                                      0,          -25 * swing,
                                      25 * swing, 20 * swing - walk.arms,
                                      5 * swing,  0,
                                      8 * swing};
        std::copy(row, row + channels, values.row(i));
        x += std::sin(turn * pi / 180) * walk.speed / walk.fps;
        z += std::cos(turn * pi / 180) * walk.speed / walk.fps;
    }
    return clip_of(walk.fps, std::move(values));
}

inline constexpr std::int64_t world_channels = 4;

/// The clip below a constant joint, which is displaced and turned.
inline Clip below_world(Clip clip) {
    using enum Channel;
    auto& joints = clip.skeleton->joints;
    for (Joint& joint : joints)
        ++joint.parent;
    joints.insert(joints.begin(), {"World", -1, {}, {tx, ty, tz, rx}, {}, false});
    Matrix values(clip.frames(), world_channels + channels);
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        const double world[world_channels] = {5, -7, 11, 30};
        std::copy(world, world + world_channels, values.row(i));
        std::copy(clip.values.row(i), clip.values.row(i) + channels,
                  values.row(i) + world_channels);
    }
    clip.values = std::move(values);
    return clip;
}

/// The clip with a joint above its root that takes over the root's movement. The root keeps `own`
/// position channels: none, its height, or all three, constant.
inline Clip below_carrier(Clip clip, int own) {
    using enum Channel;
    auto& joints = clip.skeleton->joints;
    for (Joint& joint : joints)
        ++joint.parent;
    joints.insert(joints.begin(), {"Carrier", -1, {}, {tx, ty, tz}, {}, false});
    if (own == 1)
        joints[0].channels = {tx, tz};
    joints[1].channels = {ry, rx, rz};
    if (own > 0)
        joints[1].channels.insert(joints[1].channels.begin(), ty);
    if (own == 3)
        joints[1].channels.insert(joints[1].channels.begin(), {tx, tz});
    Matrix values(clip.frames(), own == 3 ? channels + 3 : channels);
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        const double* row = clip.values.row(i);
        std::copy(row, row + 3, values.row(i));
        if (own == 1)
            std::swap(values(i, 1), values(i, 2));
        std::copy(row + 3, row + channels, values.row(i) + values.cols() - (channels - 3));
    }
    clip.values = std::move(values);
    return clip;
}

inline Body body_of(const Clip& clip) {
    return Body(clip, stltsa::clip::body_root(clip), Axis::y);
}

inline Track track_of(const Clip& clip) {
    return make_track(body_of(clip), clip.values, clip.fps, "a clip");
}

inline Vec3 joint_position(const Skeleton& skeleton, const double* row, std::size_t joint) {
    stltsa::clip::Pose pose;
    pose.place(skeleton, row);
    return pose.position[joint];
}

inline double floor_distance(const Vec3& a, const Vec3& b) {
    return std::hypot(a[0] - b[0], a[2] - b[2]);
}

} // namespace synthesis_testing
