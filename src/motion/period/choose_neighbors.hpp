// SPDX-License-Identifier: BSD-3-Clause
// Default k, the number of neighbors (paper, Table 1), for fits and decompositions.
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"
#include "motion/period/period.hpp"

namespace stltsa::motion {

/// Bounds on k.
struct NeighborLimits {
    std::int64_t distinct = 0; ///< frames that differ from the previous one
    int least_dimension = 1;   ///< required tangent dimension
    int most_dimension = 1;    ///< preferred tangent dimension, if there are enough frames
};

/// 1.2 periods, so that a coordinate swings once per cycle; 1.2 seconds without a period; 12
/// without a frame rate (fps 0). Bounded by the number of distinct frames.
std::int64_t choose_neighbors(const Period& period, double fps, const NeighborLimits& limits);

/// Number of frames that differ from the previous one, including the first frame.
std::int64_t distinct_frames(ConstMatrixView frames);

} // namespace stltsa::motion
