// SPDX-License-Identifier: BSD-3-Clause
// From a rotation to the angles of a joint's channels.
#pragma once

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Writes the joint's rotation channels, in degrees, for a local rotation (child axes to parent
/// axes). `values`: the joint's numbers in a row of the clip; what they hold before chooses among
/// the sets of angles that mean the same rotation: the nearest one, so that nothing jumps from
/// frame to frame. A joint with fewer than three rotation channels gets the nearest rotation that
/// it can make.
void put_rotation(const Joint& joint, bool fixed_axes, const Quaternion& local, double* values);

} // namespace stltsa::clip
