// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "clip/body/up_axis.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Turns the chosen points of each frame about the up axis so that they keep one heading, which
/// depends on their shape but not on the heading in the file. Their horizontal mean must be at the
/// origin. False, and nothing is changed, if they have no heading: they stand above each other, or
/// in one vertical plane.
bool remove_heading(Matrix& points, const std::vector<std::int64_t>& chosen, Axis up);

/// The range of the angles, in radians, by which frames of one were turned to give the other.
double turned_range(const Matrix& points, const Matrix& turned,
                    const std::vector<std::int64_t>& chosen, Axis up);

} // namespace stltsa::clip
