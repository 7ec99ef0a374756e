// SPDX-License-Identifier: BSD-3-Clause
// Interpolation between two poses.
#pragma once

#include <cstddef>

#include "clip/clip.hpp"

namespace stltsa::synthesis {

/// Interpolates between two rows of channels, for joint `first` and those after it: rotations by
/// slerp, other channels linearly. Of equivalent angles it chooses those nearest to the previous
/// contents of `row`.
void blend_poses(const clip::Skeleton& skeleton, std::size_t first, const double* a,
                 const double* b, double weight_of_b, double* row);

} // namespace stltsa::synthesis
