// SPDX-License-Identifier: BSD-3-Clause
#include "phase/halves.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "phase/lag.hpp"

namespace stltsa::phase {
namespace {

Matrix column_of(const std::vector<double>& curve) {
    Matrix column = Matrix::unset(static_cast<std::int64_t>(curve.size()), 1);
    std::ranges::copy(curve, column.data());
    return column;
}

/// The curve at no more than 1000 phases, because the cost of a lag grows with their square. The
/// lags of 30 000 samples differ by less than 0.001 of the cycle (tests/api/sides.c).
Matrix thinned(const std::vector<double>& curve) {
    constexpr std::int64_t most = 1000;
    const std::int64_t count = std::ssize(curve);
    Matrix column = Matrix::unset(std::min(count, most), 1);
    for (std::int64_t s = 0; s < column.rows(); ++s)
        column(s, 0) = curve[static_cast<std::size_t>(s * count / column.rows())];
    return column;
}

std::vector<double> half_later(const std::vector<double>& curve) {
    const Matrix shifted = later(column_of(curve).view(), static_cast<double>(curve.size()) / 2);
    return {shifted.data(), shifted.data() + shifted.rows()};
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

CurveDifference difference(const CycleCurve& left, const CycleCurve& right, std::int64_t cycles,
                           PacedPoll& polls) {
    double squares = 0;
    for (std::size_t s = 0; s < left.mean.size(); ++s)
        squares += (left.mean[s] - right.mean[s]) * (left.mean[s] - right.mean[s]);
    if (std::isnan(squares))
        return {none, none, none, none, none, none, none};
    const auto count = static_cast<double>(left.mean.size());
    const Matrix one = thinned(left.mean), other = thinned(right.mean);
    const Lag lag = lag_between(one.view(), other.view(), one.rows() / 4, polls);
    return {std::sqrt(squares / count),
            chance_of(left, right, cycles),
            mean_of(left.mean) - mean_of(right.mean),
            range_of(left.mean),
            range_of(right.mean),
            lag.correlation >= least_correlation ? lag.samples / static_cast<double>(one.rows())
                                                 : none,
            lag.correlation};
}

} // namespace stltsa::phase
