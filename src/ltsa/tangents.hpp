// SPDX-License-Identifier: BSD-3-Clause
// Local tangent coordinates of each neighborhood (paper, Table 1, steps 2 and 3).
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/neighbors.hpp"

namespace stltsa::ltsa {

/// For each frame i: d vectors g_l of k entries, orthonormal and orthogonal to e, entry j belonging
/// to the j-th neighbor. A direction that is not there (fewer than d in the window) is a zero
/// vector, so that it ties the frames together instead of letting them go.
struct Tangents {
    std::int64_t size = 0;  ///< k
    std::int64_t count = 0; ///< d
    AlignedVector<double> g;
    std::vector<std::int32_t> rank; ///< of each window: directions that are there, at most d

    const double* direction(std::int64_t frame, std::int64_t l) const {
        return g.data() + (frame * count + l) * size;
    }
    double* direction(std::int64_t frame, std::int64_t l) {
        return g.data() + (frame * count + l) * size;
    }
};

/// Tangents of `count` dimensions. `window`: largest distance in frames between a frame and its
/// neighbors where they are temporal, so that distances are shared; 0 where they are not.
Tangents local_tangents(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                        std::int64_t window, int threads, const Progress& progress);

/// Eigenvalues of every `stride`-th neighborhood's correlation matrix, descending: one row each,
/// `count` columns. For local PCA.
Matrix local_spectra(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                     std::int64_t stride, int threads, const Progress& progress);

} // namespace stltsa::ltsa
