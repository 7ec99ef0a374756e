// SPDX-License-Identifier: BSD-3-Clause
// A quantity of two motions, and how well their difference is known.
#pragma once

#include <vector>

namespace stltsa::phase {

/// A quantity of a mean cycle, and how each cycle deviates from it.
struct Quantity {
    double value = 0;
    std::vector<double> deviations;
};

/// Fields that are unknown are NaN: those of the spread for a single cycle.
struct Estimate {
    double first = 0, first_sd = 0; ///< standard deviation over the cycles
    double second = 0, second_sd = 0;
    double difference = 0;    ///< second less first
    double error = 0;         ///< its standard error
    double low = 0, high = 0; ///< its 95 % confidence interval
    bool significant = false; ///< the interval does not include 0
};

/// 97.5 % quantile of Student's t distribution; `freedom` at least 1, not necessarily whole.
double t_quantile(double freedom);

/// The difference of two quantities from cycles that are independent (Welch), or `paired`: cycle k
/// of both is the same.
Estimate estimate(const Quantity& first, const Quantity& second, bool paired);

/// Standard deviation of deviations from their mean; NaN for one.
double deviation_of(const std::vector<double>& deviations);

/// The standard error of a difference of means, and the half width of its 95 % interval, from
/// standard deviations of `n` and `m` independent values.
struct Uncertainty {
    double standard = 0, margin = 0;
};
Uncertainty welch(double sd, double n, double other_sd, double m);
/// The same from the standard deviation of n differences.
Uncertainty paired_error(double sd, double n);

} // namespace stltsa::phase
