// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace stltsa::motion {

/// The value below which a `share` (0 to 1) of the values lies, linear between neighbors in order;
/// 0 where there are none.
double quantile(std::span<const double> values, double share);

inline double median(std::span<const double> values) {
    return quantile(values, 0.5);
}

/// Standard deviation of noise about 0, a few spikes left out of account: 1.4826 times the median
/// size (MAD).
double robust_deviation(std::span<const double> values);

} // namespace stltsa::motion
