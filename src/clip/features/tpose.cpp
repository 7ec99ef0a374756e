// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/tpose.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stltsa::clip {
namespace {

/// Limit of dropped frames: smoothing and resampling spread the jump out of a T-pose over a few.
constexpr std::int64_t most_frames = 8;

double distance(const double* a, const double* b, std::int64_t count) {
    double sum = 0;
    for (std::int64_t i = 0; i < count; ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

/// The 95th percentile of the steps.
double usual_largest(std::vector<double> steps) {
    const std::size_t rank = (steps.size() - 1) * 95 / 100;
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(rank), steps.end());
    return steps[rank];
}

} // namespace

std::int64_t tpose_frames(ConstMatrixView features) {
    // Too few frames to distinguish a jump from the motion.
    if (features.rows < 3 * most_frames)
        return 0;
    std::vector<double> steps;
    for (std::int64_t i = 0; i + 1 < features.rows; ++i)
        steps.push_back(distance(features.row(i), features.row(i + 1), features.cols));
    const double usual = usual_largest({steps.begin() + most_frames, steps.end()});
    if (!(usual > 0) || steps[0] <= 4 * usual)
        return 0;
    std::int64_t count = 0;
    while (count < most_frames && steps[static_cast<std::size_t>(count)] > 1.5 * usual)
        ++count;
    return count;
}

} // namespace stltsa::clip
