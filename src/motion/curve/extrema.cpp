// SPDX-License-Identifier: BSD-3-Clause
#include "motion/curve/extrema.hpp"

#include <algorithm>

namespace stltsa::motion {

std::vector<Extremum> alternating_extrema(std::span<const double> curve, double prominence) {
    enum class Direction { unknown, up, down };
    std::vector<Extremum> found;
    if (!(prominence > 0))
        return found;
    Direction direction = Direction::unknown;
    std::size_t highest = 0; // since the last valley
    std::size_t lowest = 0;  // since the last peak
    for (std::size_t i = 1; i < curve.size(); ++i) {
        if (curve[i] > curve[highest])
            highest = i;
        if (curve[i] < curve[lowest])
            lowest = i;
        if (direction != Direction::down && curve[highest] - curve[i] >= prominence) {
            found.push_back({static_cast<std::int64_t>(highest), true});
            direction = Direction::down;
            lowest = i;
        } else if (direction != Direction::up && curve[i] - curve[lowest] >= prominence) {
            found.push_back({static_cast<std::int64_t>(lowest), false});
            direction = Direction::up;
            highest = i;
        }
    }
    if (direction != Direction::unknown) {
        const bool up = direction == Direction::up;
        found.push_back({static_cast<std::int64_t>(up ? highest : lowest), up});
    }
    return found;
}

double parabola_vertex(double left, double middle, double right) {
    const double bend = left - 2 * middle + right;
    return bend == 0 ? 0 : std::clamp(0.5 * (left - right) / bend, -0.5, 0.5);
}

} // namespace stltsa::motion
