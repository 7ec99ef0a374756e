// SPDX-License-Identifier: BSD-3-Clause
#include "motion/curve/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/numbers.hpp"

namespace stltsa::motion {
namespace {

/// Correlation of the coordinate with itself `lag` samples later; each of the two has its own mean.
double autocorrelation(std::span<const double> u, std::size_t lag) {
    if (lag + 1 >= u.size())
        return 0;
    return correlation(u.first(u.size() - lag), u.subspan(lag));
}

} // namespace

double quantile(std::span<const double> values, double share) {
    if (values.empty())
        return 0;
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

double standard_deviation(std::span<const double> values) {
    if (values.size() < 2)
        return none;
    const auto count = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double value : values)
        mean += value / count;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return std::sqrt(squares / (count - 1));
}

double robust_deviation(std::span<const double> values) {
    std::vector<double> sizes(values.size());
    std::transform(values.begin(), values.end(), sizes.begin(),
                   [](double value) { return std::abs(value); });
    return 1.4826 * median(sizes);
}

double correlation(std::span<const double> a, std::span<const double> b) {
    const std::size_t n = std::min(a.size(), b.size());
    const auto mean = [n](std::span<const double> values) {
        return std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n),
                               0.0) /
               static_cast<double>(n);
    };
    const double mean_a = n > 1 ? mean(a) : 0, mean_b = n > 1 ? mean(b) : 0;
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < n; ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return n > 1 && aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

double cyclicity(std::span<const double> coordinate, std::size_t period) {
    return (autocorrelation(coordinate, period) - autocorrelation(coordinate, period / 2)) / 2;
}

// Hill, Algorithm 396: Student's t-quantiles, Communications of the ACM 13, 1970.
double t_quantile(double freedom) {
    constexpr double both_tails = 0.05;
    constexpr double normal = -1.959963984540054; // quantile of one tail
    const double a = 1 / (freedom - 0.5);
    const double b = 48 / (a * a);
    double c = ((20700 * a / b - 98) * a - 16) * a + 96.36;
    const double d = ((94.5 / (b + c) - 3) / b + 1) * std::sqrt(a * std::numbers::pi / 2) * freedom;
    double y = std::pow(d * both_tails, 2 / freedom);
    if (y > 0.05 + a) {
        if (freedom < 5)
            c += 0.3 * (freedom - 4.5) * (normal + 0.6);
        c = (((0.05 * d * normal - 5) * normal - 7) * normal - 2) * normal + b + c;
        y = normal * normal;
        y = (((((0.4 * y + 6.3) * y + 36) * y + 94.5) / c - y - 3) / b + 1) * normal;
        y = std::expm1(a * y * y);
    } else {
        y = ((1 / (((freedom + 6) / (freedom * y) - 0.089 * d - 0.822) * (freedom + 2) * 3) +
              0.5 / (freedom + 4)) *
                 y -
             1) *
                (freedom + 1) / (freedom + 2) +
            1 / y;
    }
    const double found = std::sqrt(freedom * y);
    // Below 2 it is too large, by 18 % at 1. An interpolation between the exact values at 1 and 2
    // is too large by at most 2.6 %.
    constexpr double of_one = 12.706204736174698, of_two = 4.302652729749464;
    return freedom < 2 ? std::min(found, of_two * std::pow(of_one / of_two, 2 / freedom - 1))
                       : found;
}

std::vector<double> column_of(ConstMatrixView matrix, std::int64_t column) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(matrix.rows));
    for (std::int64_t i = 0; i < matrix.rows; ++i)
        values.push_back(matrix(i, column));
    return values;
}

} // namespace stltsa::motion
