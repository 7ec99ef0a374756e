// SPDX-License-Identifier: BSD-3-Clause
// Intrinsic dimension of the frames (paper, section 2.3), and local PCA beside it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/parameters.hpp"

namespace stltsa::ltsa {

struct DimensionOptions {
    double threshold = 0.1;       ///< tau of the eigengap, as a fraction of k
    double local_variance = 0.95; ///< share of a neighborhood's variance that local PCA must hold
};

struct Dimension {
    Parameters parameters;
    int eigengap = 0;  ///< 0: cannot tell, see eigengap_reason
    int local_pca = 0; ///< 0: cannot tell, see local_pca_reason
    std::string eigengap_reason;
    std::string local_pca_reason;
    std::vector<double> eigenvalues;     ///< of B / k, ascending, the zero one first
    std::vector<double> local_variances; ///< mean share of variance of local direction 1, 2, ...
    double threshold = 0;                ///< tau as a fraction of k
    double local_variance = 0;
};

/// parameters.dimension is the tangent dimension D that B is built with.
Dimension intrinsic_dimension(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                              const Parameters& parameters, const DimensionOptions& options,
                              const Progress& progress);

} // namespace stltsa::ltsa
