// SPDX-License-Identifier: BSD-3-Clause
#include "phase/lag.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/checkpoint.hpp"
#include "base/numbers.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/extrema.hpp"

namespace stltsa::phase {
namespace {

/// A deviation from the mean that is below this share of the mean is only rounding.
constexpr double still = 1e-9;

std::int64_t wrapped(std::int64_t sample, std::int64_t count) {
    return ((sample % count) + count) % count;
}

/// Deviations from the mean of each column, scaled to length 1; empty if the curve does not move.
Matrix direction_of(ConstMatrixView curve) {
    std::vector<double> mean(static_cast<std::size_t>(curve.cols));
    const double share = 1 / static_cast<double>(curve.rows);
    for (std::int64_t s = 0; s < curve.rows; ++s) {
        axpy(share, curve.row(s), mean.data(), curve.cols);
        checkpoint(curve.cols);
    }
    Matrix direction = Matrix::unset(curve.rows, curve.cols);
    double squares = 0;
    for (std::int64_t s = 0; s < curve.rows; ++s) {
        double* row = direction.row(s);
        for (std::int64_t c = 0; c < curve.cols; ++c)
            row[c] = curve(s, c) - mean[static_cast<std::size_t>(c)];
        squares += dot(row, row, curve.cols);
        checkpoint(4 * curve.cols);
    }
    const double length = std::sqrt(squares);
    if (!(length > still * std::sqrt(dot(mean.data(), mean.data(), curve.cols))))
        return {};
    for (std::int64_t s = 0; s < curve.rows; ++s) {
        for (std::int64_t c = 0; c < curve.cols; ++c)
            direction(s, c) /= length;
        checkpoint(curve.cols);
    }
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
        checkpoint(a.rows() * a.cols());
    }
    return all;
}

} // namespace

Lag lag_between(ConstMatrixView first, ConstMatrixView second, std::int64_t most) {
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
    const double vertex = motion::parabola_vertex(at(best - 1), at(best), at(best + 1));
    result.samples = static_cast<double>(best) + vertex;
    result.correlation = std::min(1.0, at(best) + vertex * (at(best + 1) - at(best - 1)) / 4);
    return result;
}

Matrix later(ConstMatrixView curves, double shift) {
    Matrix result = Matrix::unset(curves.rows, curves.cols);
    const double whole = std::floor(shift);
    const double part = shift - whole;
    for (std::int64_t s = 0; s < curves.rows; ++s) {
        const std::int64_t from = wrapped(s + static_cast<std::int64_t>(whole), curves.rows);
        const double* before = curves.row(from);
        const double* after = curves.row(wrapped(from + 1, curves.rows));
        for (std::int64_t c = 0; c < curves.cols; ++c)
            result(s, c) = part > 0 ? before[c] + part * (after[c] - before[c]) : before[c];
        checkpoint(2 * curves.cols);
    }
    return result;
}

Matrix slope(ConstMatrixView curves) {
    Matrix result = Matrix::unset(curves.rows, curves.cols);
    for (std::int64_t s = 0; s < curves.rows; ++s) {
        const double* before = curves.row(wrapped(s - 1, curves.rows));
        const double* after = curves.row(wrapped(s + 1, curves.rows));
        for (std::int64_t c = 0; c < curves.cols; ++c)
            result(s, c) = (after[c] - before[c]) / 2;
        checkpoint(2 * curves.cols);
    }
    return result;
}

} // namespace stltsa::phase
