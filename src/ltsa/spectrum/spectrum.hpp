// SPDX-License-Identifier: BSD-3-Clause
// The smallest eigenpairs of the alignment matrix B (Table 1, step 5).
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/alignment/alignment.hpp"

namespace stltsa::ltsa {

struct Spectrum {
    std::vector<double> values; ///< lambda_2, lambda_3, ... ascending (lambda_1 = 0 is left out)
    Matrix vectors;             ///< u_2 .. u_{d+1}, one per row, orthonormal, with zero mean
    double residual = 0;        ///< max ||B u - lambda u|| / k over these vectors
    double first_change = 0; ///< largest principal angle by which the first correction turned them
    double last_change = 0;  ///< the same for the last correction
    std::int64_t solves = 0;
};

/// Table 1, step 5: the `count` smallest eigenpairs of B except the constant one (count < frames).
/// All are corrected; changes and residual are those of the first `dimension`.
Spectrum smallest_eigenpairs(const Alignment& alignment, std::int64_t count,
                             std::int64_t dimension);

} // namespace stltsa::ltsa
