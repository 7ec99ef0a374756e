// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/jump.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "linalg/simd.hpp"

namespace stltsa::clip {
namespace {

/// Least jump relative to the standard deviation of all frames.
constexpr double far_against_all = 0.3;
/// Least jump relative to nearby steps, except the adjacent ones: one bad frame makes two jumps.
constexpr double far_against_near = 5;
constexpr std::int64_t nearest = 2;
constexpr std::int64_t farthest = 5;

double deviation(ConstMatrixView features) {
    std::vector<double> mean(static_cast<std::size_t>(features.cols));
    const auto rows = static_cast<double>(features.rows);
    for (std::int64_t i = 0; i < features.rows; ++i)
        axpy(1 / rows, features.row(i), mean.data(), features.cols);
    double squares = 0;
    for (std::int64_t i = 0; i < features.rows; ++i)
        squares += squared_distance(features.row(i), mean.data(), features.cols) / rows;
    return std::sqrt(squares);
}

} // namespace

std::int64_t find_jump(ConstMatrixView features) {
    const auto step = [&](std::int64_t i) {
        return i < 1 || i >= features.rows
                   ? 0
                   : std::sqrt(
                         squared_distance(features.row(i), features.row(i - 1), features.cols));
    };
    std::int64_t jump = 0;
    for (std::int64_t i = 1; i < features.rows; ++i)
        if (step(i) > step(jump))
            jump = i;
    double near = 0;
    for (std::int64_t away = nearest; away <= farthest; ++away)
        near = std::max({near, step(jump - away), step(jump + away)});
    const bool far =
        step(jump) > far_against_near * near && step(jump) > far_against_all * deviation(features);
    return far ? jump : 0;
}

} // namespace stltsa::clip
