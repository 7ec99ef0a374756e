// SPDX-License-Identifier: BSD-3-Clause
#include "motion/period/choose_neighbors.hpp"

#include <algorithm>
#include <cmath>

namespace stltsa::motion {
namespace {

std::int64_t wanted(const Period& period, double fps) {
    // With fewer neighbors a coordinate only follows time; with many more it stops oscillating.
    constexpr double cycles = 1.2;
    constexpr double seconds = 1.2;
    constexpr std::int64_t without_rate = 12;
    if (period.samples > 0)
        return std::llround(cycles * period.samples);
    return fps > 0 ? std::llround(std::min(seconds * fps, 1e15)) : without_rate;
}

} // namespace

std::int64_t choose_neighbors(const Period& period, double fps, const NeighborLimits& limits) {
    // d tangents need d + 2 neighbors; a clip shorter than that forms a single neighborhood.
    const std::int64_t enough =
        std::max<std::int64_t>(wanted(period, fps), limits.most_dimension + 2);
    return std::max<std::int64_t>(std::min(enough, limits.distinct - 1),
                                  limits.least_dimension + 2);
}

std::int64_t distinct_frames(ConstMatrixView frames) {
    std::int64_t distinct = 1;
    for (std::int64_t i = 1; i < frames.rows; ++i)
        if (!std::equal(frames.row(i), frames.row(i) + frames.cols, frames.row(i - 1)))
            ++distinct;
    return distinct;
}

} // namespace stltsa::motion
