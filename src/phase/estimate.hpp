// SPDX-License-Identifier: BSD-3-Clause
// A quantity of two motions, and how precisely their difference is known.
#pragma once

#include <cstddef>
#include <vector>

namespace stltsa::phase {

/// A quantity of a mean cycle, and how each cycle deviates from it.
struct Quantity {
    double value = 0;
    std::vector<double> deviations;
};

/// Unknown fields are NaN: for a single cycle, those that depend on the spread.
struct Estimate {
    double first = 0, first_sd = 0; ///< value, standard deviation between cycles
    double second = 0, second_sd = 0;
    double difference = 0;    ///< second minus first
    double error = 0;         ///< its standard error
    double low = 0, high = 0; ///< its 95 % confidence interval
    bool significant = false; ///< the interval excludes 0, by more than rounding
};

/// By what factor the variance of a mean is larger than for independent values, because cycles
/// resemble those before them; at least 1.
class Persistence {
  public:
    /// Adds the deviations of one of several quantities over the same cycles.
    void add(std::vector<double> deviations);
    double value() const;

  private:
    std::size_t cycles_ = 0;
    double sum_ = 0, counted_ = 0; ///< of the correlations between cycles
};

/// Persistence of the cycles of both motions. `paired`: cycle k is the same cycle in both, and
/// `first` is the persistence of the differences; `second` is not used.
struct Dependence {
    double first = 1, second = 1; ///< see Persistence
    bool paired = false;
};

/// The dependence of several quantities of one kind.
class Dependences {
  public:
    explicit Dependences(bool paired) : paired_(paired) {}
    /// Adds a quantity of both motions.
    void add(const Quantity& first, const Quantity& second);
    Dependence value() const;

  private:
    Persistence first_, second_;
    bool paired_;
};

/// The dependence of a single quantity.
Dependence dependence_of(const Quantity& first, const Quantity& second, bool paired);

Estimate estimate(const Quantity& first, const Quantity& second, const Dependence& dependence);

/// The standard error of a difference of means, and half the width of its 95 % interval.
struct Uncertainty {
    double standard = 0, margin = 0;
};
/// Standard deviation between cycles, number of cycles, and their persistence.
struct Spread {
    double sd = 0, count = 0, persistence = 1;
};
/// For two motions, with the degrees of freedom of Welch and Satterthwaite.
Uncertainty uncertainty(const Spread& first, const Spread& second);
/// For differences within cycles.
Uncertainty uncertainty(const Spread& differences);

} // namespace stltsa::phase
