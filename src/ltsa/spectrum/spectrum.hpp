// SPDX-License-Identifier: BSD-3-Clause
// The smallest eigenpairs of an alignment matrix (paper, Table 1, step 5).
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/alignment/alignment.hpp"

namespace stltsa::ltsa {

struct Spectrum {
    std::vector<double> values; ///< lambda_2, lambda_3, ... ascending (lambda_1 = 0 is left out)
    Matrix vectors;             ///< the first `dimension`, one per row, orthonormal, of zero mean
    double residual = 0;        ///< max ||B u - lambda u|| / k over the first `dimension`
    double first_change = 0; ///< largest principal angle by which the first correction turned them
    double last_change = 0;  ///< and the last one
    std::int64_t solves = 0;
};

/// The `count` smallest eigenpairs beside the constant one (count < frames), the first `dimension`
/// of them corrected and certified.
Spectrum smallest_eigenpairs(const Alignment& alignment, std::int64_t count, std::int64_t dimension,
                             const Progress& progress);

} // namespace stltsa::ltsa
