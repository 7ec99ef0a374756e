// SPDX-License-Identifier: BSD-3-Clause
// Local tangent coordinates of each neighborhood: G_i of Table 1, step 3 without its column
// e / sqrt(k).
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::ltsa {

/// For each frame i: d vectors g_l of k entries, orthonormal and orthogonal to e; entry j belongs
/// to the j-th neighbor. If a window varies in fewer than d directions, the others are zero
/// vectors, which keep the frames together in B.
struct Tangents {
    std::int64_t size = 0;  ///< k
    std::int64_t count = 0; ///< d
    UnsetVector<double> g;
    UnsetVector<std::int32_t> rank; ///< directions in which each window varies, at most d
    /// For each direction, the root mean square, over the windows that have it, of the angle by
    /// which rounding may have turned it.
    std::vector<double> rounding;

    const double* direction(std::int64_t frame, std::int64_t l) const {
        return g.data() + (frame * count + l) * size;
    }
    double* direction(std::int64_t frame, std::int64_t l) {
        return g.data() + (frame * count + l) * size;
    }
};

} // namespace stltsa::ltsa
