// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Strays last less than this.
constexpr double longest_stray_s = 0.1;

/// A point that leaves its path and returns faster than a limb can, as keypoints do that are taken
/// for others. Makes such values NaN. Frames of each point; empty: there are none, or fewer than
/// three points. `width`: columns of a point.
std::vector<std::int64_t> drop_strays(Matrix& rows, int width, double fps);

} // namespace stltsa::clip
