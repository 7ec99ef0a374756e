// SPDX-License-Identifier: BSD-3-Clause
// Finds the local tangent coordinates of all neighborhoods (paper, Table 1, steps 2 and 3).
#pragma once

#include <cstdint>
#include <span>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/parameters.hpp"
#include "ltsa/tangents/tangents.hpp"

namespace stltsa::ltsa {

/// Tangents of parameters.dimension dimensions, of neighborhoods that are there.
Tangents local_tangents(ConstMatrixView x, const Neighborhoods& neighborhoods,
                        const Parameters& parameters, const Progress& progress);

/// Temporal neighborhoods and their tangents in one pass: a block of frames goes from distances to
/// neighbors, and from these and the same distances to tangents, before the next one.
Tangents temporal_tangents(ConstMatrixView x, std::span<const std::int64_t> lengths,
                           const Parameters& parameters, const Progress& progress,
                           Neighborhoods& neighborhoods);

/// Eigenvalues of every `stride`-th neighborhood's correlation matrix, descending: one row each,
/// `count` columns. For local PCA.
Matrix local_spectra(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                     std::int64_t stride, int threads, const Progress& progress);

} // namespace stltsa::ltsa
