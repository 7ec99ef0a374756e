// SPDX-License-Identifier: BSD-3-Clause
// Forward kinematics: from a row of channel values to rotations and positions.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "clip/body/quaternion.hpp"

namespace stltsa::clip {

inline double to_radians(double degrees) {
    return degrees * (std::numbers::pi / 180);
}

/// A joint's local rotation: the product of its rotation channels.
Quaternion joint_rotation(const Joint& joint, bool fixed_axes, const double* values);

/// Position of the joint in its parent's axes.
Vec3 joint_translation(const Joint& joint, const double* values);

/// The work of placing a skeleton in a frame, for each of its channels, compared with adding; for
/// checkpoint().
inline constexpr std::int64_t work_of_channel = 100;

/// One frame of a skeleton; each vector has one entry per joint.
struct Pose {
    std::vector<Quaternion> local; ///< child axes to parent axes
    std::vector<Quaternion> world; ///< child axes to world axes
    std::vector<Vec3> position;    ///< in the world

    /// Computes the first `count` joints from `row`, which has one value per channel.
    void place(const Skeleton& skeleton, const double* row, std::size_t count);
    void place(const Skeleton& skeleton, const double* row) {
        place(skeleton, row, skeleton.joints.size());
    }
    /// The same from `local`, which is set, and the position of the root; the other joints stay at
    /// their offsets.
    void place(const Skeleton& skeleton, const Vec3& root);

  private:
    void place_joint(const Joint& joint, std::size_t j, const Vec3& offset);
};

} // namespace stltsa::clip
