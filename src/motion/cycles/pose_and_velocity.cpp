// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/pose_and_velocity.hpp"

#include <algorithm>
#include <numbers>

#include "base/checkpoint.hpp"
#include "linalg/gaussian.hpp"
#include "linalg/simd.hpp"

namespace stltsa::motion {
namespace {

/// Sigma in seconds; from 10 to 50 ms events scatter alike in phase.
constexpr double smoothing_s = 0.02;
constexpr double velocity_weight = 2;

/// Per row, from the row before to the row after.
void difference(ConstMatrixView rows, std::int64_t i, double* out) {
    const std::int64_t before = std::max<std::int64_t>(0, i - 1);
    const std::int64_t after = std::min(rows.rows - 1, i + 1);
    const double scale = 1 / static_cast<double>(after - before);
    std::fill_n(out, rows.cols, 0.0);
    axpy(scale, rows.row(after), out, rows.cols);
    axpy(-scale, rows.row(before), out, rows.cols);
}

} // namespace

Matrix differences(ConstMatrixView rows) {
    Matrix result = Matrix::unset(rows.rows, rows.cols);
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        difference(rows, i, result.row(i));
        checkpoint(2 * rows.cols);
    }
    return result;
}

Matrix pose_and_velocity(ConstMatrixView rows, double rate, double period) {
    Matrix both = Matrix::unset(rows.rows, 2 * rows.cols);
    const MatrixView pose{both.data(), rows.rows, rows.cols, both.cols()};
    const MatrixView velocity{both.data() + rows.cols, rows.rows, rows.cols, both.cols()};
    smooth_to(pose, rows, smoothing_s * rate, Beyond::reflection);
    const double scale = velocity_weight * period / (2 * std::numbers::pi);
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        difference(pose, i, velocity.row(i));
        for (std::int64_t c = 0; c < rows.cols; ++c)
            velocity(i, c) *= scale;
        checkpoint(3 * rows.cols);
    }
    return both;
}

} // namespace stltsa::motion
