// SPDX-License-Identifier: BSD-3-Clause
// Between two poses.
#pragma once

#include <cstddef>

#include "clip/clip.hpp"

namespace stltsa::synthesis {

/// Writes the pose between two rows of channels into `row`, joint by joint from joint `first` on:
/// rotations by slerp, other channels linear. What `row` holds before chooses among the angles
/// that mean the same rotation.
void blend_poses(const clip::Skeleton& skeleton, std::size_t first, const double* a,
                 const double* b, double weight_of_b, double* row);

} // namespace stltsa::synthesis
