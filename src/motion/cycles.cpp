// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/simd.hpp"

namespace stltsa::motion {
namespace {

constexpr std::int64_t phases = 32;

/// The poses of a cycle at equally spaced phases, interpolated linearly.
void poses_at_phases(const Cycle& cycle, ConstMatrixView samples, PacedPoll& poll, double* poses) {
    for (std::int64_t p = 0; p < phases; ++p) {
        const double at = cycle.begin + (cycle.end - cycle.begin) * static_cast<double>(p) / phases;
        const auto before = std::clamp(static_cast<std::int64_t>(at), std::int64_t{0},
                                       std::max<std::int64_t>(0, samples.rows - 2));
        const std::int64_t after = std::min(before + 1, samples.rows - 1);
        const double fraction = at - static_cast<double>(before);
        for (std::int64_t c = 0; c < samples.cols; ++c)
            poses[p * samples.cols + c] =
                (1 - fraction) * samples(before, c) + fraction * samples(after, c);
        poll.did(samples.cols);
    }
}

} // namespace

std::vector<Cycle> cycles_between(const std::vector<double>& margins) {
    std::vector<Cycle> cycles;
    for (std::size_t i = 0; i + 2 < margins.size(); i += 2)
        cycles.push_back({margins[i], margins[i + 2]});
    return cycles;
}

std::int64_t most_typical(const std::vector<Cycle>& cycles, ConstMatrixView samples,
                          const Progress& progress) {
    if (cycles.empty())
        return -1;
    const auto count = static_cast<std::int64_t>(cycles.size());
    PacedPoll poll(progress, Stage::units);
    // Keeps the poses of one cycle at a time: those of all may need more memory than the clip.
    std::vector<double> poses(checked_size(phases, samples.cols)), mean(poses.size());
    const std::int64_t size = phases * samples.cols;
    for (const Cycle& cycle : cycles) {
        poses_at_phases(cycle, samples, poll, poses.data());
        axpy(1 / static_cast<double>(count), poses.data(), mean.data(), size);
    }
    // The cycle nearest to the mean has the least sum of squared distances to all cycles.
    std::int64_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t i = 0; i < count; ++i) {
        poses_at_phases(cycles[static_cast<std::size_t>(i)], samples, poll, poses.data());
        const double distance = squared_distance(poses.data(), mean.data(), size);
        // Two cycles are equally far from their mean, except for rounding.
        if (distance < least * (1 - 1e-9)) {
            least = distance;
            best = i;
        }
    }
    return best;
}

} // namespace stltsa::motion
