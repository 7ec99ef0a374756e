// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "clip/features.hpp"
#include "clip/jump.hpp"
#include "linalg/gaussian.hpp"

namespace stltsa::clip {
namespace {

std::int64_t dropped_frames(const Clip& clip, const SharedMatrix& features, bool drop_tpose) {
    return drop_tpose && clip.skeleton ? tpose_frames(features.view()) : 0;
}

} // namespace

Prepared prepare(const Clip& clip, const PrepareOptions& options) {
    if (clip.frames() == 0)
        fail(Status::too_few_frames, "the clip has no frames");
    Prepared prepared;
    prepared.features = feature_kind(clip, options.features);
    prepared.up = clip.skeleton ? up_axis(clip, options.up) : Axis::automatic;
    const SharedMatrix all = features(clip, prepared.features, prepared.up);
    prepared.first = dropped_frames(clip, all, options.drop_tpose);
    const SharedMatrix kept = all.from_row(prepared.first);
    if (const std::int64_t jump = find_jump(kept.view()); jump > 0)
        prepared.jump = prepared.first + jump;
    // Without a frame rate seconds mean nothing: neither decimated nor smoothed.
    if (clip.fps > 0 && options.rate > 0)
        prepared.step = static_cast<std::int64_t>(
            std::clamp(std::round(clip.fps / options.rate), 1.0, static_cast<double>(all.rows())));
    prepared.fps = clip.fps / static_cast<double>(prepared.step);
    const double sigma = options.smoothing * clip.fps;
    const bool as_they_are = sigma == 0 && prepared.step == 1;
    prepared.samples = as_they_are ? kept : gaussian_smoothed(kept.view(), sigma, prepared.step);
    return prepared;
}

Matrix smoothed_features(const Clip& clip, Features kind, Axis up, double smoothing,
                         bool drop_tpose) {
    const SharedMatrix all = features(clip, kind, up);
    const std::int64_t first = dropped_frames(clip, all, drop_tpose);
    const Matrix smoothed = gaussian_smoothed(all.from_row(first).view(), smoothing * clip.fps);
    Matrix result = copied(all.view());
    std::copy_n(smoothed.data(), smoothed.rows() * smoothed.cols(), result.row(first));
    return result;
}

} // namespace stltsa::clip
