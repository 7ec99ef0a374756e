// SPDX-License-Identifier: BSD-3-Clause
// Weighted sums of rows: mean cycles at a phase, their normal equations, smoothing. A sum stays in
// registers over all rows, instead of being read and written for each of them.
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa {

/// out += weights[0] * row 0 + weights[step] * row 1 + ..., in this order.
void add_weighted(ConstMatrixView rows, const double* weights, std::int64_t step, double* out);

/// out += weights[0] * (row 0 - center) + weights[1] * (row 1 - center) + ..., in this order.
void add_weighted_differences(ConstMatrixView rows, const double* center, const double* weights,
                              double* out);

} // namespace stltsa
