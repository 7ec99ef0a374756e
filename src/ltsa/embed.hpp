// SPDX-License-Identifier: BSD-3-Clause
// The part of a fit that depends on the number of coordinates (Table 1, step 4; Table 1, step 5).
#pragma once

#include "ltsa/graph.hpp"
#include "ltsa/model.hpp"

namespace stltsa::ltsa {

/// Eigenvalues per component that a fit reports: the zero one, those of the coordinates, and the
/// next one, which shows the gap.
constexpr int eigenvalues_of_fit(int dimension) {
    return dimension + 2;
}

/// Embeds every component with the graph's first `dimension` tangents. `eigenvalues`: number per
/// component, including the zero one.
Model embed(const Graph& graph, int dimension, int eigenvalues);

} // namespace stltsa::ltsa
