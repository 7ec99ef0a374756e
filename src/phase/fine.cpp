// SPDX-License-Identifier: BSD-3-Clause
#include "phase/fine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/checkpoint.hpp"
#include "linalg/gaussian.hpp"
#include "linalg/simd.hpp"
#include "motion/cycles/pose_and_velocity.hpp"

namespace stltsa::phase {
namespace {

constexpr double smoothing_s = 0.01;
constexpr double places_per_second = 100;
constexpr double acceleration_weight = 0.5;

/// Second derivatives of the natural cubic spline through each column, row by row.
Matrix spline_bends(const Matrix& values) {
    const std::int64_t n = values.rows(), p = values.cols();
    Matrix bends = Matrix::unset(n, p);
    std::fill_n(bends.row(0), p, 0.0);
    std::fill_n(bends.row(n - 1), p, 0.0);
    std::vector<double> pivot(static_cast<std::size_t>(n));
    // Row i: bend[i-1] + 4 bend[i] + bend[i+1] = 6 (second difference), eliminated downwards.
    for (std::int64_t i = 1; i + 1 < n; ++i) {
        const double before = i > 1 ? 1 / pivot[static_cast<std::size_t>(i - 1)] : 0;
        pivot[static_cast<std::size_t>(i)] = 4 - before;
        std::fill_n(bends.row(i), p, 0.0);
        axpy(6, values.row(i - 1), bends.row(i), p);
        axpy(-12, values.row(i), bends.row(i), p);
        axpy(6, values.row(i + 1), bends.row(i), p);
        axpy(-before, bends.row(i - 1), bends.row(i), p);
        checkpoint(4 * p);
    }
    for (std::int64_t i = n - 2; i > 0; --i) {
        axpy(-1, bends.row(i + 1), bends.row(i), p);
        for (std::int64_t c = 0; c < p; ++c)
            bends(i, c) /= pivot[static_cast<std::size_t>(i)];
        checkpoint(2 * p);
    }
    return bends;
}

} // namespace

FineRows::FineRows(ConstMatrixView rows, double rate, double period)
    : places_(std::max<std::int64_t>(
          1, static_cast<std::int64_t>(std::ceil(places_per_second / rate - 1e-9)))) {
    const double scale = period / (2 * std::numbers::pi);
    const Matrix smooth = gaussian_smoothed(rows, smoothing_s * rate, Beyond::reflection, 1);
    const Matrix velocity = motion::differences(smooth.view());
    const Matrix acceleration = motion::differences(velocity.view());
    values_ = Matrix::unset(rows.rows, 2 * rows.cols);
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        std::fill_n(values_.row(i), values_.cols(), 0.0);
        axpy(scale, velocity.row(i), values_.row(i), rows.cols);
        axpy(acceleration_weight * scale * scale, acceleration.row(i), values_.row(i) + rows.cols,
             rows.cols);
        checkpoint(2 * rows.cols);
    }
    bends_ = spline_bends(values_);
}

void FineRows::at(double row, double* values) const {
    const double place = std::clamp(row, 0.0, static_cast<double>(rows() - 1));
    const auto i = std::clamp<std::int64_t>(static_cast<std::int64_t>(place), 0,
                                            std::max<std::int64_t>(0, rows() - 2));
    const double b = place - static_cast<double>(i), a = 1 - b;
    const double bend_a = (a * a * a - a) / 6, bend_b = (b * b * b - b) / 6;
    const std::int64_t after = std::min(rows() - 1, i + 1);
    for (std::int64_t c = 0; c < cols(); ++c)
        values[c] = a * values_(i, c) + b * values_(after, c) + bend_a * bends_(i, c) +
                    bend_b * bends_(after, c);
}

} // namespace stltsa::phase
