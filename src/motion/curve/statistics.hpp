// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace stltsa::motion {

/// The value below which a `share` (0 to 1) of the values lies, interpolated; 0 without values.
double quantile(std::span<const double> values, double share);

inline double median(std::span<const double> values) {
    return quantile(values, 0.5);
}

/// Robust standard deviation of noise about 0: 1.4826 times the median absolute value.
double robust_deviation(std::span<const double> values);

} // namespace stltsa::motion
