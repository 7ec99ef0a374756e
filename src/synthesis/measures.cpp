// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/measures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "linalg/simd.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::synthesis {
namespace {

constexpr double near_s = 0.125;
constexpr double usual = 0.95;
/// Steps below this share of the size of a posture are rounding.
constexpr double rounding = 1e-6;

struct Differences {
    std::vector<double> steps;
    std::vector<double> accelerations;
};

/// Steps and second differences entirely within frames [begin, end).
Differences differences(const Matrix& x, std::int64_t begin, std::int64_t end) {
    Differences result;
    for (std::int64_t t = begin + 1; t < end; ++t)
        result.steps.push_back(
            std::sqrt(stltsa::squared_distance(x.row(t), x.row(t - 1), x.cols())));
    for (std::int64_t t = begin + 1; t + 1 < end; ++t) {
        double sum = 0;
        for (std::int64_t c = 0; c < x.cols(); ++c) {
            const double d = x(t + 1, c) - 2 * x(t, c) + x(t - 1, c);
            sum += d * d;
        }
        result.accelerations.push_back(std::sqrt(sum));
    }
    return result;
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

} // namespace

Roughness usual_roughness(const Track& track, std::int64_t begin, std::int64_t end) {
    const Differences found = differences(track.postures, begin, end);
    const double least = rounding * posture_size(track, begin);
    return {std::max(motion::quantile(found.steps, usual), least),
            std::max(motion::quantile(found.accelerations, usual), least)};
}

Roughness roughness_near(const Track& track, std::int64_t seam) {
    const auto reach = std::max<std::int64_t>(1, std::llround(near_s * track.fps));
    // The step into the seam starts at the frame before it.
    const Differences found =
        differences(track.postures, std::max<std::int64_t>(0, seam - 1 - reach),
                    std::min(track.frames(), seam + reach + 1));
    return {largest(found.steps), largest(found.accelerations)};
}

} // namespace stltsa::synthesis
