// SPDX-License-Identifier: BSD-3-Clause
#include "phase/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stltsa::phase {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// A difference below this share of the values is only rounding.
constexpr double rounding = 1e-9;

double square(double value) {
    return value * value;
}

double count_of(const std::vector<double>& values) {
    return static_cast<double>(values.size());
}

Uncertainty error_of(const Quantity& first, const Quantity& second, bool paired) {
    if (!paired)
        return welch(deviation_of(first.deviations), count_of(first.deviations),
                     deviation_of(second.deviations), count_of(second.deviations));
    std::vector<double> differences;
    for (std::size_t k = 0; k < first.deviations.size(); ++k)
        differences.push_back(second.deviations[k] - first.deviations[k]);
    return paired_error(deviation_of(differences), count_of(differences));
}

} // namespace

// Hill, Algorithm 396: Student's t-quantiles, Communications of the ACM 13, 1970.
double t_quantile(double freedom) {
    constexpr double both_tails = 0.05;
    constexpr double normal = -1.959963984540054; // quantile of half of them
    const double a = 1 / (freedom - 0.5);
    const double b = 48 / square(a);
    double c = ((20700 * a / b - 98) * a - 16) * a + 96.36;
    const double d = ((94.5 / (b + c) - 3) / b + 1) * std::sqrt(a * std::numbers::pi / 2) * freedom;
    double y = std::pow(d * both_tails, 2 / freedom);
    if (y > 0.05 + a) {
        if (freedom < 5)
            c += 0.3 * (freedom - 4.5) * (normal + 0.6);
        c = (((0.05 * d * normal - 5) * normal - 7) * normal - 2) * normal + b + c;
        y = square(normal);
        y = (((((0.4 * y + 6.3) * y + 36) * y + 94.5) / c - y - 3) / b + 1) * normal;
        y = std::expm1(a * square(y));
    } else {
        y = ((1 / (((freedom + 6) / (freedom * y) - 0.089 * d - 0.822) * (freedom + 2) * 3) +
              0.5 / (freedom + 4)) *
                 y -
             1) *
                (freedom + 1) / (freedom + 2) +
            1 / y;
    }
    return std::sqrt(freedom * y);
}

double deviation_of(const std::vector<double>& deviations) {
    if (deviations.size() < 2)
        return none;
    double mean = 0, squares = 0;
    for (const double each : deviations)
        mean += each / count_of(deviations);
    for (const double each : deviations)
        squares += square(each - mean);
    return std::sqrt(squares / (count_of(deviations) - 1));
}

Uncertainty welch(double sd, double n, double other_sd, double m) {
    const double a = square(sd) / n, b = square(other_sd) / m;
    if (!(a + b >= 0))
        return {none, none};
    if (a + b == 0)
        return {0, 0};
    // Welch and Satterthwaite.
    const double freedom = square(a + b) / (square(a) / (n - 1) + square(b) / (m - 1));
    const double standard = std::sqrt(a + b);
    return {standard, standard * t_quantile(std::max(1.0, freedom))};
}

Uncertainty paired_error(double sd, double n) {
    const double standard = sd / std::sqrt(n);
    return {standard, n > 1 ? standard * t_quantile(n - 1) : none};
}

Estimate estimate(const Quantity& first, const Quantity& second, bool paired) {
    Estimate result;
    result.first = first.value;
    result.first_sd = deviation_of(first.deviations);
    result.second = second.value;
    result.second_sd = deviation_of(second.deviations);
    result.difference = second.value - first.value;
    const Uncertainty error = error_of(first, second, paired);
    result.error = error.standard;
    result.low = result.difference - error.margin;
    result.high = result.difference + error.margin;
    const double least =
        rounding * std::max({std::abs(first.value), std::abs(second.value), rounding});
    result.significant =
        (result.low > 0 || result.high < 0) && std::abs(result.difference) > least;
    return result;
}

} // namespace stltsa::phase
