// SPDX-License-Identifier: BSD-3-Clause
#include "phase/pose_and_velocity.hpp"

#include <algorithm>
#include <numbers>

#include "base/progress.hpp"
#include "linalg/gaussian.hpp"
#include "linalg/simd.hpp"

namespace stltsa::phase {
namespace {

/// Sigma in seconds; from 10 to 50 ms events scatter alike in phase.
constexpr double smoothing_s = 0.02;
constexpr double velocity_weight = 2;

} // namespace

Matrix differences(ConstMatrixView rows, const std::function<void()>& poll) {
    PacedPoll polls(poll);
    Matrix result = Matrix::unset(rows.rows, rows.cols);
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        const std::int64_t before = std::max<std::int64_t>(0, i - 1);
        const std::int64_t after = std::min(rows.rows - 1, i + 1);
        const double scale = 1 / static_cast<double>(after - before);
        std::fill_n(result.row(i), rows.cols, 0.0);
        axpy(scale, rows.row(after), result.row(i), rows.cols);
        axpy(-scale, rows.row(before), result.row(i), rows.cols);
        polls.did(2 * rows.cols);
    }
    return result;
}

Matrix pose_and_velocity(ConstMatrixView rows, double rate, double period,
                         const std::function<void()>& poll) {
    const Matrix pose = gaussian_smoothed(rows, smoothing_s * rate, Beyond::reflection, 1, poll);
    const Matrix velocity = differences(pose.view(), poll);
    PacedPoll polls(poll);
    const double scale = velocity_weight * period / (2 * std::numbers::pi);
    Matrix both = Matrix::unset(rows.rows, 2 * rows.cols);
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        std::copy_n(pose.row(i), rows.cols, both.row(i));
        std::fill_n(both.row(i) + rows.cols, rows.cols, 0.0);
        axpy(scale, velocity.row(i), both.row(i) + rows.cols, rows.cols);
        polls.did(2 * rows.cols);
    }
    return both;
}

} // namespace stltsa::phase
