// SPDX-License-Identifier: BSD-3-Clause
// Inverse kinematics of single joints: from positions and rotations to channel values.
#pragma once

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Writes the joint's rotation channels, in degrees, for a local rotation (child axes to parent
/// axes). `values`: the joint's channels in a row of the clip. Of the angles that represent the
/// same rotation, it chooses those nearest to the previous values, so that nothing jumps from frame
/// to frame. A joint with fewer than three rotation channels gets the nearest rotation that it can
/// have. Values that represent the rotation already keep their bits.
void put_rotation(const Joint& joint, bool fixed_axes, const Quaternion& local, double* values);

/// Writes the joint's position channels, if any, for a position in the parent's axes.
void put_position(const Joint& joint, const Vec3& place, double* values);

/// Writes position channels of a row for a world position of the joint: its own channels and, until
/// there are three, those of its ancestors.
void put_world_position(const Skeleton& skeleton, std::size_t joint, const Vec3& place,
                        double* row);

} // namespace stltsa::clip
