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

/// How much larger the variance of a mean is than that of independent values, because cycles
/// resemble those before them; at least 1. From deviations of like quantities: each is a sequence
/// of the same cycles.
double persistence(const std::vector<std::vector<double>>& deviations);

/// Of the cycles of both motions; `paired`: cycle k of both is the same, and only `first` counts,
/// which is that of the differences.
struct Dependence {
    double first = 1, second = 1; ///< persistence
    bool paired = false;
};

/// The dependence of like quantities, of one kind.
Dependence dependence_of(const std::vector<const Quantity*>& first,
                         const std::vector<const Quantity*>& second, bool paired);

Estimate estimate(const Quantity& first, const Quantity& second, const Dependence& dependence);

/// Standard deviation of deviations from their mean; NaN for one.
double deviation_of(const std::vector<double>& deviations);

/// The standard error of a difference of means, and the half width of its 95 % interval.
struct Uncertainty {
    double standard = 0, margin = 0;
};
/// A standard deviation of so many cycles, and their persistence.
struct Spread {
    double sd = 0, count = 0, persistence = 1;
};
/// Of two motions, by Welch and Satterthwaite.
Uncertainty uncertainty(const Spread& first, const Spread& second);
/// Of differences within cycles.
Uncertainty uncertainty(const Spread& differences);

} // namespace stltsa::phase
