// SPDX-License-Identifier: BSD-3-Clause
// Forward kinematics: from a row of channel values to rotations and positions.
#pragma once

#include <numbers>
#include <vector>

#include "clip/quaternion.hpp"

namespace stltsa::clip {

inline double to_radians(double degrees) {
    return degrees * (std::numbers::pi / 180);
}

/// The local rotation that a joint's numbers in a row mean: the product of its rotation channels.
Quaternion joint_rotation(const Joint& joint, bool fixed_axes, const double* values);

/// One frame of a skeleton, an entry per joint.
struct Pose {
    std::vector<Quaternion> local; ///< child axes to parent axes
    std::vector<Quaternion> world; ///< child axes to world axes
    std::vector<Vec3> position;    ///< in the world

    /// Places the first `count` joints as `row` says: a number per channel, joint after joint.
    void place(const Skeleton& skeleton, const double* row, std::size_t count);
    void place(const Skeleton& skeleton, const double* row) {
        place(skeleton, row, skeleton.joints.size());
    }
};

} // namespace stltsa::clip
