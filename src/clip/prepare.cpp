// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include "clip/features.hpp"

namespace stltsa::clip {
namespace {

/// Half of a symmetric kernel, its middle first, cut at four sigma; just 1 without smoothing.
std::vector<double> gaussian(double sigma, std::int64_t rows) {
    std::vector<double> weights{1};
    const double reach = std::min(4 * sigma, static_cast<double>(rows));
    for (int i = 1; i <= reach; ++i)
        weights.push_back(std::exp(-0.5 * (i / sigma) * (i / sigma)));
    return weights;
}

void add_scaled(double weight, const double* from, std::int64_t count, double* to) {
    for (std::int64_t c = 0; c < count; ++c)
        to[c] += weight * from[c];
}

/// Every step-th row from `first` on, smoothed over the rows from `first` on. At the ends, where
/// the kernel reaches out, what is left of it is scaled to sum to 1.
Matrix sample(const Matrix& rows, std::int64_t first, std::int64_t step,
              const std::vector<double>& kernel) {
    const std::int64_t count = (rows.rows() - first + step - 1) / step;
    const auto reach = static_cast<std::int64_t>(kernel.size()) - 1;
    Matrix result(count, rows.cols());
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t middle = first + i * step;
        const std::int64_t begin = std::max(first, middle - reach);
        const std::int64_t end = std::min(rows.rows(), middle + reach + 1);
        double total = 0;
        for (std::int64_t r = begin; r < end; ++r)
            total += kernel[static_cast<std::size_t>(std::abs(r - middle))];
        for (std::int64_t r = begin; r < end; ++r)
            add_scaled(kernel[static_cast<std::size_t>(std::abs(r - middle))] / total, rows.row(r),
                       rows.cols(), result.row(i));
    }
    return result;
}

} // namespace

Prepared prepare(const Clip& clip, const PrepareOptions& options) {
    Prepared prepared;
    prepared.features = feature_kind(clip, options.features);
    prepared.up = up_axis(clip, options.up);
    const Matrix all = features(clip, prepared.features, prepared.up);
    if (options.drop_tpose && clip.skeleton)
        prepared.first = tpose_frames(all.view());
    // Without a frame rate seconds mean nothing: neither decimated nor smoothed.
    if (clip.fps > 0 && options.rate > 0)
        prepared.step = static_cast<std::int64_t>(
            std::clamp(std::round(clip.fps / options.rate), 1.0, static_cast<double>(all.rows())));
    prepared.fps = clip.fps / static_cast<double>(prepared.step);
    prepared.samples = sample(all, prepared.first, prepared.step,
                              gaussian(options.smoothing * clip.fps, all.rows()));
    return prepared;
}

} // namespace stltsa::clip
