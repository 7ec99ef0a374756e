// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/jump.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "clip/clip.hpp"
#include "linalg/simd.hpp"

namespace stltsa::clip {
namespace {

/// Least jump relative to nearby steps, except the adjacent ones: one bad frame makes two jumps.
constexpr double far_against_near = 5;
constexpr std::int64_t nearest = 2;
constexpr std::int64_t farthest = 5;
/// Least jump relative to the root mean square of the steps that move: a switch, and the last digit
/// of a slow column, stand still between equal steps.
constexpr double far_against_usual = 2;

/// From each row to the next, by the groups that both have. Step 0 is none.
std::vector<double> steps_of(ConstMatrixView rows, int width) {
    std::vector<double> steps(static_cast<std::size_t>(rows.rows));
    for (std::int64_t i = 1; i < rows.rows; ++i) {
        double squares = 0;
        for (std::int64_t c = 0; c < rows.cols; c += width) {
            const double *before = rows.row(i - 1) + c, *now = rows.row(i) + c;
            if (!is_missing(before, width) && !is_missing(now, width))
                squares += squared_distance(now, before, width);
        }
        steps[static_cast<std::size_t>(i)] = std::sqrt(squares);
    }
    return steps;
}

double usual_step(const std::vector<double>& steps) {
    double squares = 0, moving = 0;
    for (const double step : steps) {
        squares += step * step;
        moving += step > 0 ? 1 : 0;
    }
    return moving > 0 ? std::sqrt(squares / moving) : 0;
}

} // namespace

std::int64_t find_jump(ConstMatrixView rows, int width) {
    const std::vector<double> steps = steps_of(rows, width);
    const std::int64_t jump = std::ranges::max_element(steps) - steps.begin();
    const auto step = [&](std::int64_t i) {
        return i < 0 || i >= rows.rows ? 0 : steps[static_cast<std::size_t>(i)];
    };
    double near = 0;
    for (std::int64_t away = nearest; away <= farthest; ++away)
        near = std::max({near, step(jump - away), step(jump + away)});
    const bool far =
        step(jump) > far_against_near * near && step(jump) > far_against_usual * usual_step(steps);
    return far ? jump : 0;
}

} // namespace stltsa::clip
