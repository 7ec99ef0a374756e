// SPDX-License-Identifier: BSD-3-Clause
#include "results/turning.hpp"

#include <cmath>
#include <numbers>

namespace stltsa::results {
namespace {

/// Sums of the dot products and of the cross products of horizontal positions.
struct Sums {
    double along = 0, across = 0;
};

Sums sums_of(ConstMatrixView to, ConstMatrixView mean, const Level& level) {
    double along = 0, across = 0;
    for (std::int64_t c = 0; c + level.width <= to.cols; c += level.width)
        for (std::int64_t s = 0; s < to.rows; ++s) {
            const double a = to(s, c + level.first), b = to(s, c + level.second);
            const double x = mean(s, c + level.first), y = mean(s, c + level.second);
            const double dot = a * x + b * y, cross = b * x - a * y;
            along += std::isnan(dot) ? 0 : dot;
            across += std::isnan(cross) ? 0 : cross;
        }
    return {along, across};
}

} // namespace

double likeness_if_turned(ConstMatrixView to, ConstMatrixView mean, const Level& level) {
    const auto [along, across] = sums_of(to, mean, level);
    double upright = 0;
    const std::int64_t up = 3 - level.first - level.second;
    for (std::int64_t s = 0; s < to.rows; ++s)
        for (std::int64_t c = up; c < to.cols; c += 3)
            upright += to(s, c) * mean(s, c);
    return std::hypot(along, across) + upright;
}

double turn_to(ConstMatrixView to, ConstMatrixView mean, const Level& level, Matrix& signals) {
    const auto [along, across] = sums_of(to, mean, level);
    const double length = std::hypot(along, across);
    if (!(length > 0))
        return 0;
    for (std::int64_t i = 0; i < signals.rows(); ++i)
        for (std::int64_t c = 0; c + level.width <= signals.cols(); c += level.width) {
            double &first = signals(i, c + level.first), &second = signals(i, c + level.second);
            const double turned = (along * first - across * second) / length;
            second = (across * first + along * second) / length;
            first = turned;
        }
    return std::atan2(across, along) * 180 / std::numbers::pi;
}

} // namespace stltsa::results
