// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/rests.hpp"

#include <algorithm>
#include <cstddef>

#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// Highest speed of a standing body, from the speeds of a rest, which are all below the limit.
double standing_speed(std::span<const double> speed, const Standing& standing) {
    const double middle = median(speed);
    // The lower quartile is 0.67 standard deviations below the median; the upper one would include
    // the first motion.
    const double two_deviations = 3 * (middle - quantile(speed, 0.25));
    return std::min(std::max(middle + two_deviations, standing.still), standing.below);
}

/// Interpolated position between two samples at which the speed is `limit`.
double crossing(std::size_t low, std::size_t high, std::span<const double> speed, double limit) {
    const double fraction = (limit - speed[low]) / (speed[high] - speed[low]);
    return static_cast<double>(low) +
           fraction * (static_cast<double>(high) - static_cast<double>(low));
}

/// The samples [first, last), which are below the limit, without the motion at both ends.
Rest trimmed(std::span<const double> speed, std::size_t first, std::size_t last,
             const Standing& standing) {
    const double limit = standing_speed(speed.subspan(first, last - first), standing);
    Rest rest{static_cast<double>(first), static_cast<double>(last)};
    if (first > 0) {
        std::size_t i = first;
        while (i + 1 < last && speed[i] >= limit)
            ++i;
        rest.begin = speed[i] < limit ? crossing(i, i - 1, speed, limit) : static_cast<double>(i);
    }
    if (last < speed.size()) {
        std::size_t i = last - 1;
        while (i > first && speed[i] >= limit)
            --i;
        rest.end = speed[i] < limit ? crossing(i, i + 1, speed, limit) : static_cast<double>(i);
    }
    return rest;
}

} // namespace

std::vector<Rest> find_rests(std::span<const double> speed, const Standing& standing) {
    std::vector<Rest> rests;
    std::size_t first = 0;
    while (first < speed.size()) {
        if (speed[first] >= standing.below) {
            ++first;
            continue;
        }
        std::size_t last = first;
        while (last < speed.size() && speed[last] < standing.below)
            ++last;
        if (static_cast<double>(last - first) >= standing.hold) {
            const Rest rest = trimmed(speed, first, last, standing);
            if (rest.begin < rest.end)
                rests.push_back(rest);
        }
        first = last;
    }
    return rests;
}

} // namespace stltsa::motion
