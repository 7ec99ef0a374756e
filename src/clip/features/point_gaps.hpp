// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// What fill_gaps() found. A point is missing in a frame if its three coordinates are exactly 0, as
/// C3D files have it, or one of them is not a number.
struct Gaps {
    std::vector<std::int64_t> seen;    ///< points that take part
    std::vector<std::int64_t> filled;  ///< those of them that were missing in some frames
    std::vector<std::int64_t> dropped; ///< missing in more than half of the frames
    std::int64_t frames = 0;           ///< frames filled, summed over the points
};

/// Fills gaps linearly over time, and with the nearest value at the ends. Sets the columns of
/// dropped points to 0, so that they carry no weight and the others keep their places.
Gaps fill_gaps(Matrix& points);

} // namespace stltsa::clip
