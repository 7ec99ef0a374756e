// SPDX-License-Identifier: BSD-3-Clause
#include "phase/halves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stltsa::phase {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Below this correlation, one curve explains less than half of the variance of the other, so it is
/// not clear which of their features correspond.
constexpr double least_correlation = 0.7;
/// A deviation from the level that is below this share of the level is only rounding.
constexpr double still = 1e-9;

/// Linear interpolation between samples, cyclic. `place`: in samples.
double at(const std::vector<double>& curve, double place) {
    const auto count = static_cast<std::int64_t>(curve.size());
    const double floor = std::floor(place);
    const std::int64_t before = ((static_cast<std::int64_t>(floor) % count) + count) % count;
    const double part = place - floor;
    const double first = curve[static_cast<std::size_t>(before)];
    if (part == 0)
        return first;
    const double next = curve[static_cast<std::size_t>((before + 1) % count)];
    return first + part * (next - first);
}

std::vector<double> half_later(const std::vector<double>& curve) {
    std::vector<double> later;
    for (std::size_t s = 0; s < curve.size(); ++s)
        later.push_back(at(curve, static_cast<double>(s) + static_cast<double>(curve.size()) / 2));
    return later;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

double range_of(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    return most - least;
}

/// Deviations from the mean, of length 1; empty if the curve does not move.
std::vector<double> direction_of(std::vector<double> curve) {
    const double level = mean_of(curve);
    double squares = 0;
    for (double& value : curve) {
        value -= level;
        squares += value * value;
    }
    const double length = std::sqrt(squares);
    if (!(length > still * std::abs(level)))
        return {};
    for (double& value : curve)
        value /= length;
    return curve;
}

struct Shift {
    double samples = none, correlation = none;
};

/// The lag at which the curves match best, at most a quarter of a cycle: the peak of the parabola
/// through the best correlation and its two neighbors.
Shift best_shift(const std::vector<double>& left, const std::vector<double>& right) {
    const auto a = direction_of(left), b = direction_of(right);
    if (a.empty() || b.empty())
        return {};
    const auto count = static_cast<std::int64_t>(a.size());
    const auto correlation = [&](std::int64_t lag) {
        double sum = 0;
        for (std::int64_t s = 0; s < count; ++s)
            sum += a[static_cast<std::size_t>(s)] *
                   b[static_cast<std::size_t>((s + lag + count) % count)];
        return sum;
    };
    std::int64_t best = 0;
    double most = correlation(0);
    for (std::int64_t lag = -count / 4; lag <= count / 4; ++lag)
        if (const double found = correlation(lag); found > most) {
            best = lag;
            most = found;
        }
    const double before = correlation(best - 1), after = correlation(best + 1);
    if (!(most >= least_correlation) || before > most || after > most)
        return {none, most};
    const double bend = before - 2 * most + after, slope = (after - before) / 2;
    if (!(bend < 0))
        return {static_cast<double>(best), most};
    return {static_cast<double>(best) - slope / bend,
            std::min(1.0, most - slope * slope / (2 * bend))};
}

double chance_of(const CycleCurve& left, const CycleCurve& right, std::int64_t cycles) {
    double squares = 0;
    for (std::size_t s = 0; s < left.mean.size(); ++s)
        squares += left.deviation[s] * left.deviation[s] + right.deviation[s] * right.deviation[s];
    return std::sqrt(squares / static_cast<double>(left.mean.size()) / static_cast<double>(cycles));
}

} // namespace

CycleCurve curve_of(const Matrix& mean, const Matrix& deviation, std::int64_t column) {
    CycleCurve curve;
    for (std::int64_t s = 0; s + 1 < mean.rows(); ++s) {
        curve.mean.push_back(mean(s, column));
        curve.deviation.push_back(deviation(s, column));
    }
    return curve;
}

CycleCurve half_a_cycle_later(const CycleCurve& curve) {
    return {half_later(curve.mean), half_later(curve.deviation)};
}

CurveDifference difference(const CycleCurve& left, const CycleCurve& right, std::int64_t cycles) {
    double squares = 0;
    for (std::size_t s = 0; s < left.mean.size(); ++s)
        squares += (left.mean[s] - right.mean[s]) * (left.mean[s] - right.mean[s]);
    if (std::isnan(squares))
        return {none, none, none, none, none, none, none};
    const auto count = static_cast<double>(left.mean.size());
    const Shift shift = best_shift(left.mean, right.mean);
    return {std::sqrt(squares / count),
            chance_of(left, right, cycles),
            mean_of(left.mean) - mean_of(right.mean),
            range_of(left.mean),
            range_of(right.mean),
            shift.samples / count,
            shift.correlation};
}

} // namespace stltsa::phase
