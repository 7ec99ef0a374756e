// SPDX-License-Identifier: BSD-3-Clause
// Local tangent coordinates of all neighborhoods.
#pragma once

#include <cstdint>
#include <span>

#include "linalg/matrix.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/parameters.hpp"
#include "ltsa/tangents/tangents.hpp"

namespace stltsa::ltsa {

/// Table 1, step 2; Table 1, step 3: parameters.dimension tangents of existing neighborhoods.
Tangents local_tangents(ConstMatrixView x, const Neighborhoods& neighborhoods,
                        const Parameters& parameters);

/// Table 1, step 1; Table 1, step 2; Table 1, step 3 in one pass: the temporal neighborhoods of a
/// block of frames and, from the same distances, their tangents.
Tangents temporal_tangents(ConstMatrixView x, std::span<const std::int64_t> lengths,
                           const Parameters& parameters, Neighborhoods& neighborhoods);

/// For local PCA: the `count` largest eigenvalues of every `stride`-th neighborhood's correlation
/// matrix, descending, one row each.
Matrix local_spectra(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                     std::int64_t stride, int threads);

} // namespace stltsa::ltsa
