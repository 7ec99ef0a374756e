// SPDX-License-Identifier: BSD-3-Clause
// How cyclic a coordinate is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Of the values that both have, less their means; 0 if one of them is constant.
double correlation(std::span<const double> a, std::span<const double> b);

/// Half of the autocorrelation after one period, less half of that after half a period: 1 for a
/// cosine of this period, 0 for noise.
double cyclicity(std::span<const double> coordinate, std::size_t period);

std::vector<double> column_of(ConstMatrixView matrix, std::int64_t column);

} // namespace stltsa::motion
