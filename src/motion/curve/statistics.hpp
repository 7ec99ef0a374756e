// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// The value below which a `share` (0 to 1) of the values lies, interpolated; 0 without values.
double quantile(std::span<const double> values, double share);

inline double median(std::span<const double> values) {
    return quantile(values, 0.5);
}

/// NaN for fewer than two values.
double standard_deviation(std::span<const double> values);

/// Robust standard deviation of noise about 0: 1.4826 times the median absolute value.
double robust_deviation(std::span<const double> values);

/// Of the values that both have, less their means; 0 if one of them is constant.
double correlation(std::span<const double> a, std::span<const double> b);

/// Half of the autocorrelation after one period, less half of that after half a period: 1 for a
/// cosine of this period, 0 for noise.
double cyclicity(std::span<const double> coordinate, std::size_t period);

/// 97.5 % quantile of Student's t distribution. `freedom`: degrees of freedom, at least 1, not
/// necessarily whole.
double t_quantile(double freedom);

std::vector<double> column_of(ConstMatrixView matrix, std::int64_t column);

} // namespace stltsa::motion
