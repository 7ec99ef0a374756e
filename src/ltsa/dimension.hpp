// SPDX-License-Identifier: BSD-3-Clause
// Two estimates of the intrinsic dimension: eigengap (paper, section 2.3) and local PCA.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/graph.hpp"
#include "ltsa/parameters.hpp"

namespace stltsa::ltsa {

/// Default tangent dimension D of the matrix B whose eigengap is used.
inline constexpr int eigengap_tangents = 2;

struct DimensionOptions {
    double threshold = 0.1;       ///< tau of the eigengap, as a fraction of k
    double local_variance = 0.95; ///< share of variance that local PCA must explain
};

struct Dimension {
    Parameters parameters;
    int eigengap = 0;  ///< 0: undetermined, see eigengap_reason
    int local_pca = 0; ///< 0: undetermined, see local_pca_reason
    std::string eigengap_reason;
    std::string local_pca_reason;
    std::vector<double> eigenvalues;     ///< of B / k, ascending, the zero one first
    std::vector<double> local_variances; ///< mean share of variance of local direction 1, 2, ...
    double threshold = 0;                ///< tau as a fraction of k
    double local_variance = 0;
};

/// parameters.dimension is the tangent dimension D that B is built with. If the frames are
/// degenerate, both estimates are undetermined, with the reason.
Dimension intrinsic_dimension(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                              const Parameters& parameters, const DimensionOptions& options);

// The same in steps, for an existing graph whose embedding is needed anyway.

/// The estimate by local PCA. `tangents`: D.
Dimension local_dimension(const Graph& graph, int tangents, const DimensionOptions& options);
int eigenvalues_of_gap(const Graph& graph, int tangents);
/// Adds the estimate by the eigengap, from the first eigenvalues_of_gap() eigenvalues of B.
void set_eigengap(const Graph& graph, std::span<const double> eigenvalues, Dimension& result);
Dimension unknown_dimension(const Parameters& parameters, const DimensionOptions& options,
                            const std::string& reason);

} // namespace stltsa::ltsa
