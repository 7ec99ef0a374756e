// SPDX-License-Identifier: BSD-3-Clause
// From where a joint is to be, and how it is to be turned, to the numbers of its channels.
#pragma once

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Writes the joint's rotation channels, in degrees, for a local rotation (child axes to parent
/// axes). `values`: the joint's numbers in a row of the clip; what they hold before chooses among
/// the sets of angles that mean the same rotation: the nearest one, so that nothing jumps from
/// frame to frame. A joint with fewer than three rotation channels gets the nearest rotation that
/// it can make. Values that mean the rotation already stay as they are, to the bit.
void put_rotation(const Joint& joint, bool fixed_axes, const Quaternion& local, double* values);

/// Writes the joint's position channels for a place in the parent's axes; axes along which it has
/// none are left out.
void put_position(const Joint& joint, bool translations_add, const Vec3& place, double* values);

/// Writes position channels of a row so that the joint comes to this place in the world: its own
/// and, until there are three, those of the joints above it.
void put_world_position(const Skeleton& skeleton, std::size_t joint, const Vec3& place,
                        double* row);

} // namespace stltsa::clip
