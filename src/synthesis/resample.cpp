// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/resample.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/blend.hpp"

namespace stltsa::synthesis {
namespace {

/// Share of a frame that counts as rounding of a time.
constexpr double time_rounding = 1e-6;

} // namespace

bool same_rate(double a, double b) {
    return std::abs(a - b) <= 1e-4 * std::max(a, b);
}

Matrix resampled(const clip::Clip& clip, double fps) {
    const double ratio = clip.fps / fps;
    const std::int64_t last = clip.frames() - 1;
    const double count = std::floor(static_cast<double>(last) / ratio + time_rounding) + 1;
    if (!(count < 2147483648.0))
        fail(Status::argument, "at {} frames a second the clip {} would have {} frames", fps,
             clip.path, count);
    Matrix result(static_cast<std::int64_t>(count), clip.values.cols());
    for (std::int64_t i = 0; i < result.rows(); ++i) {
        const double at = static_cast<double>(i) * ratio;
        const std::int64_t before =
            std::clamp<std::int64_t>(std::llround(std::floor(at + time_rounding)), 0, last);
        const double share = at - static_cast<double>(before);
        const double* source = clip.values.row(before);
        double* row = result.row(i);
        // Of equivalent angles, blend_poses chooses those nearest to the previous row.
        std::copy_n(i > 0 ? result.row(i - 1) : source, result.cols(), row);
        if (before == last || share < time_rounding)
            std::copy_n(source, result.cols(), row);
        else
            blend_poses(*clip.skeleton, 0, source, clip.values.row(before + 1), share, row);
    }
    return result;
}

} // namespace stltsa::synthesis
