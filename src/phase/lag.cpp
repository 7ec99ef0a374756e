// SPDX-License-Identifier: BSD-3-Clause
#include "phase/lag.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.hpp"
#include "linalg/simd.hpp"

namespace stltsa::phase {
namespace {

/// A deviation from the mean that is below this share of the mean is only rounding.
constexpr double still = 1e-9;

std::int64_t wrapped(std::int64_t sample, std::int64_t count) {
    return ((sample % count) + count) % count;
}

/// Deviations from the mean of each column, scaled to length 1; empty if the curve does not move.
Matrix direction_of(const Matrix& curve) {
    Matrix direction = copied(curve.view());
    double squares = 0, levels = 0;
    for (std::int64_t c = 0; c < curve.cols(); ++c) {
        double level = 0;
        for (std::int64_t s = 0; s < curve.rows(); ++s)
            level += curve(s, c);
        level /= static_cast<double>(curve.rows());
        levels += level * level;
        for (std::int64_t s = 0; s < curve.rows(); ++s) {
            direction(s, c) -= level;
            squares += direction(s, c) * direction(s, c);
        }
    }
    const double length = std::sqrt(squares);
    if (!(length > still * std::sqrt(levels)))
        return {};
    for (std::int64_t i = 0; i < direction.rows() * direction.cols(); ++i)
        direction.data()[i] /= length;
    return direction;
}

/// Correlations of two directions at lags -most to most.
std::vector<double> correlations(const Matrix& a, const Matrix& b, std::int64_t most) {
    std::vector<double> all;
    for (std::int64_t lag = -most; lag <= most; ++lag) {
        double sum = 0;
        for (std::int64_t s = 0; s < a.rows(); ++s)
            sum += dot(a.row(s), b.row(wrapped(s + lag, a.rows())), a.cols());
        all.push_back(sum);
    }
    return all;
}

} // namespace

Lag lag_between(const Matrix& first, const Matrix& second, std::int64_t most) {
    const Matrix a = direction_of(first), b = direction_of(second);
    if (a.rows() == 0 || b.rows() == 0)
        return {none, none, none};
    // One more on each side, to tell a peak from a slope that ends there.
    const std::vector<double> found = correlations(a, b, most + 1);
    const auto at = [&](std::int64_t lag) {
        return found[static_cast<std::size_t>(lag + most + 1)];
    };
    std::int64_t best = 0;
    for (std::int64_t lag = -most; lag <= most; ++lag)
        if (at(lag) > at(best))
            best = lag;
    Lag result{none, at(best), none};
    for (std::int64_t lag = -most; lag <= most; ++lag) {
        const bool same = wrapped(lag - best + 1, a.rows()) <= 2; // shares the peak
        if (!same && at(lag) >= at(lag - 1) && at(lag) >= at(lag + 1) &&
            !(at(lag) <= result.runner_up))
            result.runner_up = at(lag);
    }
    if (at(best - 1) > at(best) || at(best + 1) > at(best))
        return result;
    const double bend = at(best - 1) - 2 * at(best) + at(best + 1);
    const double rise = (at(best + 1) - at(best - 1)) / 2;
    const bool curved = bend < 0;
    result.samples = static_cast<double>(best) - (curved ? rise / bend : 0);
    if (curved)
        result.correlation = std::min(1.0, at(best) - rise * rise / (2 * bend));
    return result;
}

Matrix later(const Matrix& curves, double shift) {
    Matrix result = Matrix::unset(curves.rows(), curves.cols());
    const double whole = std::floor(shift);
    const double part = shift - whole;
    for (std::int64_t s = 0; s < curves.rows(); ++s) {
        const std::int64_t from = wrapped(s + static_cast<std::int64_t>(whole), curves.rows());
        const double* before = curves.row(from);
        const double* after = curves.row(wrapped(from + 1, curves.rows()));
        for (std::int64_t c = 0; c < curves.cols(); ++c)
            result(s, c) = part > 0 ? before[c] + part * (after[c] - before[c]) : before[c];
    }
    return result;
}

Matrix slope(const Matrix& curves) {
    Matrix result = Matrix::unset(curves.rows(), curves.cols());
    for (std::int64_t s = 0; s < curves.rows(); ++s)
        for (std::int64_t c = 0; c < curves.cols(); ++c)
            result(s, c) = (curves(wrapped(s + 1, curves.rows()), c) -
                            curves(wrapped(s - 1, curves.rows()), c)) /
                           2;
    return result;
}

} // namespace stltsa::phase
