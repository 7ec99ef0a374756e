// SPDX-License-Identifier: BSD-3-Clause
// Interpolation between two poses.
#pragma once

#include <cstddef>

#include "clip/clip.hpp"

namespace stltsa::synthesis {

/// Writes the pose between two rows of channels into `row`, joint by joint from joint `first` on:
/// rotations by slerp, other channels linearly. Of equivalent angles it picks those nearest to the
/// previous contents of `row`.
void blend_poses(const clip::Skeleton& skeleton, std::size_t first, const double* a,
                 const double* b, double weight_of_b, double* row);

} // namespace stltsa::synthesis
