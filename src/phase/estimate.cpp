// SPDX-License-Identifier: BSD-3-Clause
#include "phase/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::phase {
namespace {

/// A difference below this share of the values is only rounding.
constexpr double rounding = 1e-9;

double square(double value) {
    return value * value;
}

double count_of(const std::vector<double>& values) {
    return static_cast<double>(values.size());
}

std::vector<double> differences_of(const Quantity& first, const Quantity& second) {
    std::vector<double> differences;
    for (std::size_t k = 0; k < first.deviations.size(); ++k)
        differences.push_back(second.deviations[k] - first.deviations[k]);
    return differences;
}

Spread spread_of(const std::vector<double>& deviations, double persistence) {
    return {motion::standard_deviation(deviations), count_of(deviations), persistence};
}

Uncertainty uncertainty_of(const Quantity& first, const Quantity& second,
                           const Dependence& dependence) {
    if (dependence.paired)
        return uncertainty(spread_of(differences_of(first, second), dependence.first));
    return uncertainty(spread_of(first.deviations, dependence.first),
                       spread_of(second.deviations, dependence.second));
}

/// Degrees of freedom of the equivalent number of independent values.
double freedom_of(const Spread& spread) {
    return std::max(1.0, spread.count / spread.persistence - 1);
}

double variance_of_mean(const Spread& spread) {
    return square(spread.sd) / spread.count * spread.persistence;
}

/// Cycles this far apart may still resemble each other.
std::size_t reach_of(std::size_t cycles) {
    return std::clamp<std::size_t>(cycles / 3, 1, 3);
}

/// With fewer cycles, their correlation cannot be estimated.
constexpr std::size_t least_cycles = 4;

/// Deviations need not have a mean of exactly 0.
std::vector<double> centered(std::vector<double> values) {
    double mean = 0;
    for (const double value : values)
        mean += value / count_of(values);
    for (double& value : values)
        value -= mean;
    return values;
}

} // namespace

void Persistence::add(std::vector<double> deviations) {
    cycles_ = deviations.size();
    if (cycles_ < least_cycles)
        return;
    const std::vector<double> values = centered(std::move(deviations));
    double squares = 0, products = 0;
    for (std::size_t k = 0; k < cycles_; ++k) {
        squares += square(values[k]);
        for (std::size_t h = 1; h <= reach_of(cycles_) && k + h < cycles_; ++h)
            products += values[k] * values[k + h];
    }
    if (squares > 0) {
        sum_ += products / squares;
        ++counted_;
    }
}

// With autocovariances c_h of the deviations from the mean of n values that are correlated up to
// lag L, the variance of the mean is (c_0 + 2 sum c_h) / (n - 1 - 2 sum (1 - h / n)): subtracting
// the sample mean lowers each c_h by the variance of the mean, which the denominator corrects.
double Persistence::value() const {
    if (counted_ == 0)
        return 1;
    const auto n = static_cast<double>(cycles_);
    double lost = 1;
    for (std::size_t h = 1; h <= reach_of(cycles_); ++h)
        lost += 2 * (1 - static_cast<double>(h) / n);
    return std::max(1.0, (n - 1) * (1 + 2 * sum_ / counted_) / (n - lost));
}

void Dependences::add(const Quantity& first, const Quantity& second) {
    if (first.deviations.empty())
        return;
    first_.add(paired_ ? differences_of(first, second) : first.deviations);
    if (!paired_)
        second_.add(second.deviations);
}

Dependence Dependences::value() const {
    return {first_.value(), paired_ ? 1 : second_.value(), paired_};
}

Dependence dependence_of(const Quantity& first, const Quantity& second, bool paired) {
    Dependences of(paired);
    of.add(first, second);
    return of.value();
}

Uncertainty uncertainty(const Spread& first, const Spread& second) {
    const double a = variance_of_mean(first), b = variance_of_mean(second);
    if (!(a + b >= 0))
        return {none, none};
    if (a + b == 0)
        return {0, 0};
    const double freedom =
        square(a + b) / (square(a) / freedom_of(first) + square(b) / freedom_of(second));
    const double standard = std::sqrt(a + b);
    return {standard, standard * motion::t_quantile(std::max(1.0, freedom))};
}

Uncertainty uncertainty(const Spread& differences) {
    const double standard = std::sqrt(variance_of_mean(differences));
    return {standard,
            differences.count > 1 ? standard * motion::t_quantile(freedom_of(differences)) : none};
}

Estimate estimate(const Quantity& first, const Quantity& second, const Dependence& dependence) {
    Estimate result;
    result.first = first.value;
    result.first_sd = motion::standard_deviation(first.deviations);
    result.second = second.value;
    result.second_sd = motion::standard_deviation(second.deviations);
    result.difference = second.value - first.value;
    const Uncertainty error = uncertainty_of(first, second, dependence);
    result.error = error.standard;
    result.low = result.difference - error.margin;
    result.high = result.difference + error.margin;
    const double least =
        rounding * std::max({std::abs(first.value), std::abs(second.value), rounding});
    result.significant = (result.low > 0 || result.high < 0) && std::abs(result.difference) > least;
    return result;
}

} // namespace stltsa::phase
