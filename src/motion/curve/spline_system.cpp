// SPDX-License-Identifier: BSD-3-Clause
#include "motion/curve/spline_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stltsa::motion {
namespace {

constexpr std::size_t bandwidth = 3;

std::int64_t intervals_for(std::int64_t rows, double knot_step) {
    const auto length = static_cast<double>(rows - 1);
    return std::llround(std::max(1.0, length / std::max(1.0, knot_step)));
}

} // namespace

SplineSystem::SplineSystem(std::int64_t rows, double knot_step)
    : rows_(rows), intervals_(intervals_for(rows, knot_step)),
      step_(static_cast<double>(rows - 1) / static_cast<double>(intervals_)),
      normal_(static_cast<std::size_t>(coefficients()) + bandwidth), right_(normal_.size()) {}

SplineSystem::Basis SplineSystem::basis(std::int64_t row) const {
    const double place = static_cast<double>(row) / step_;
    const std::int64_t interval = std::min(static_cast<std::int64_t>(place), intervals_ - 1);
    const double u = place - static_cast<double>(interval);
    const double v = 1 - u;
    return {static_cast<std::size_t>(interval),
            {v * v * v / 6, (u * u * (3 * u - 6) + 4) / 6, (v * v * (3 * v - 6) + 4) / 6,
             u * u * u / 6}};
}

void SplineSystem::set_data(std::span<const double> values, std::span<const double> weights) {
    std::fill(normal_.begin(), normal_.end(), Column{});
    std::fill(right_.begin(), right_.end(), 0.0);
    for (std::int64_t i = 0; i < rows_; ++i) {
        const Basis b = basis(i);
        const double weight = weights[static_cast<std::size_t>(i)];
        for (std::size_t p = 0; p <= bandwidth; ++p) {
            const double weighted = weight * b.values[p];
            right_[b.first + p] += weighted * values[static_cast<std::size_t>(i)];
            for (std::size_t q = p; q <= bandwidth; ++q)
                normal_[b.first + p][q - p] += weighted * b.values[q];
        }
    }
}

SplineSystem::Band SplineSystem::penalized(double lambda) const {
    constexpr std::array<double, 3> difference{1, -2, 1};
    Band matrix = normal_;
    for (std::size_t r = 0; r + 2 < static_cast<std::size_t>(coefficients()); ++r)
        for (std::size_t p = 0; p < 3; ++p)
            for (std::size_t q = p; q < 3; ++q)
                matrix[r + p][q - p] += lambda * difference[p] * difference[q];
    return matrix;
}

/// Cholesky factor in place. The penalty makes the matrix positive definite; pivots that rounding
/// makes too small (after many rows without weight) are raised to the size of that rounding.
void SplineSystem::factor(Band& matrix) {
    double largest = std::numeric_limits<double>::min();
    for (const Column& column : matrix)
        largest = std::max(largest, column[0]);
    const double least = std::numeric_limits<double>::epsilon() * largest;
    for (std::size_t j = 0; j + bandwidth < matrix.size(); ++j) {
        Column& column = matrix[j];
        column[0] = std::sqrt(std::max(column[0], least));
        for (std::size_t p = 1; p <= bandwidth; ++p)
            column[p] /= column[0];
        for (std::size_t p = 1; p <= bandwidth; ++p)
            for (std::size_t q = p; q <= bandwidth; ++q)
                matrix[j + p][q - p] -= column[p] * column[q];
    }
}

void SplineSystem::solve(const Band& factor, std::vector<double>& x) {
    const std::size_t order = factor.size() - bandwidth;
    for (std::size_t j = 0; j < order; ++j) {
        x[j] /= factor[j][0];
        for (std::size_t p = 1; p <= bandwidth; ++p)
            x[j + p] -= factor[j][p] * x[j];
    }
    std::fill(x.begin() + static_cast<std::ptrdiff_t>(order), x.end(), 0.0);
    for (std::size_t j = order; j-- > 0;) {
        for (std::size_t p = 1; p <= bandwidth; ++p)
            x[j] -= factor[j][p] * x[j + p];
        x[j] /= factor[j][0];
    }
}

std::vector<double> SplineSystem::curve(const std::vector<double>& coefficients) const {
    std::vector<double> values(static_cast<std::size_t>(rows_));
    for (std::int64_t i = 0; i < rows_; ++i) {
        const Basis b = basis(i);
        for (std::size_t p = 0; p <= bandwidth; ++p)
            values[static_cast<std::size_t>(i)] += b.values[p] * coefficients[b.first + p];
    }
    return values;
}

/// The trace of (B^T W B + lambda D^T D)^-1 B^T W B needs the inverse Z only within the band of the
/// matrix: Z L = L^-T gives it column by column, starting at the last (Takahashi, Fagan, Chen,
/// 1973; Hutchinson, de Hoog, "Smoothing noisy data with spline functions", Numer. Math. 47, 1985).
double SplineSystem::degrees_of_freedom(const Band& factor) const {
    std::array<Column, bandwidth> later{}; // columns j + 1, j + 2, j + 3 of Z within the band
    double trace = 0;
    for (std::size_t j = static_cast<std::size_t>(coefficients()); j-- > 0;) {
        const Column& l = factor[j];
        Column z{};
        for (std::size_t row = bandwidth; row > 0; --row)
            for (std::size_t p = 1; p <= bandwidth; ++p) // Z is symmetric
                z[row] -= l[p] / l[0] * later[std::min(row, p) - 1][row < p ? p - row : row - p];
        z[0] = 1 / (l[0] * l[0]);
        for (std::size_t p = 1; p <= bandwidth; ++p)
            z[0] -= l[p] / l[0] * z[p];
        trace += z[0] * normal_[j][0];
        for (std::size_t p = 1; p <= bandwidth; ++p)
            trace += 2 * z[p] * normal_[j][p];
        later = {z, later[0], later[1]};
    }
    return trace;
}

SplineSystem::Fit SplineSystem::fit(double lambda) const {
    Band matrix = penalized(lambda);
    factor(matrix);
    std::vector<double> coefficients = right_;
    solve(matrix, coefficients);
    return {curve(coefficients), degrees_of_freedom(matrix)};
}

} // namespace stltsa::motion
