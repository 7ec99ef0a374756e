// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Strays last less than this.
constexpr double longest_stray_s = 0.1;

/// Sets to NaN the points that jump away and back faster than a limb can move, such as misread
/// keypoints. Returns the number of such frames for each point; empty if there are fewer than eight
/// points, or if the frame rate or the size of the body is unknown. `width`: columns of a point.
std::vector<std::int64_t> drop_strays(Matrix& rows, int width, double fps);

} // namespace stltsa::clip
