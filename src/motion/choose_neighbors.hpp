// SPDX-License-Identifier: BSD-3-Clause
// k, the neighbors of each frame, if the caller names no number: for fits and decompositions.
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"
#include "motion/period.hpp"

namespace stltsa::motion {

/// What the neighbors must be enough for, and what there is to choose from.
struct NeighborLimits {
    std::int64_t distinct = 0; ///< frames that differ from the one before
    int least_dimension = 1;   ///< tangent dimension that is needed
    int most_dimension = 1;    ///< that is wanted if there are frames enough
};

/// 1.2 periods, which makes a coordinate swing once per cycle; 1.2 seconds without a period; 12
/// without a frame rate (fps 0). Limited to what the frames allow.
std::int64_t choose_neighbors(const Period& period, double fps, const NeighborLimits& limits);

/// Frames that differ from the one before, the first included.
std::int64_t distinct_frames(ConstMatrixView frames);

} // namespace stltsa::motion
