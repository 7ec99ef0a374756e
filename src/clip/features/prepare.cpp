// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "clip/features/features.hpp"
#include "clip/features/jump.hpp"
#include "clip/features/tpose.hpp"
#include "linalg/gaussian.hpp"

namespace stltsa::clip {
namespace {

std::int64_t dropped_frames(const Clip& clip, const Matrix& features, bool drop_tpose) {
    return drop_tpose && clip.skeleton ? tpose_frames(features.view()) : 0;
}

/// The frames of which samples are taken: neither a T-pose nor those before the body comes or after
/// it has left.
Frames used_frames(const Clip& clip, const FeatureRows& made, bool drop_tpose) {
    Frames used = between_end_holes(made.holes, made.rows.rows());
    used.begin = std::max(used.begin, dropped_frames(clip, made.rows, drop_tpose));
    return used;
}

ConstMatrixView block(const Matrix& matrix, const Frames& frames) {
    return matrix.view().block(frames.begin, frames.count());
}

/// Smoothed over time, but not over breaks of the clip. Row 0 is frame `first`.
Matrix smoothed_rows(const Clip& clip, ConstMatrixView rows, std::int64_t first, double sigma) {
    if (clip.breaks.empty())
        return gaussian_smoothed(rows, sigma, Beyond::reflection, 1);
    Matrix result = Matrix::unset(rows.rows, rows.cols);
    std::vector<std::int64_t> ends = clip.breaks;
    ends.push_back(first + rows.rows);
    std::int64_t begin = 0;
    for (const std::int64_t end : ends) {
        const std::int64_t count = std::min(end - first, rows.rows) - begin;
        if (count <= 0)
            continue; // before the first row
        const Matrix run =
            gaussian_smoothed(rows.block(begin, count), sigma, Beyond::reflection, 1);
        std::copy_n(run.data(), count * rows.cols, result.row(begin));
        begin += count;
    }
    return result;
}

} // namespace

Prepared prepare(const Clip& clip, const PrepareOptions& options) {
    if (clip.frames() == 0)
        fail(Status::too_few_frames, "the clip has no frames");
    Prepared prepared;
    prepared.features = feature_kind(clip, options.features);
    FeatureRows made = feature_rows(clip, prepared.features, options.up, options.gaps);
    prepared.up = made.up;
    prepared.turned = made.turned;
    prepared.notes = std::move(made.notes);
    const Frames used = used_frames(clip, made, options.drop_tpose);
    prepared.first = used.begin;
    prepared.holes = std::move(made.holes);
    for (const std::int64_t frame : clip.breaks)
        prepared.holes.push_back({frame, frame});
    std::ranges::sort(prepared.holes, {}, &Frames::begin);
    Matrix& all = made.rows;
    ConstMatrixView kept = block(all, used);
    if (const std::int64_t jump = find_jump(kept, 1); jump > 0)
        prepared.jump = prepared.first + jump;
    // Decimation and smoothing are in seconds, so they need a frame rate.
    if (clip.fps > 0 && options.rate > 0)
        prepared.step = static_cast<std::int64_t>(
            std::clamp(std::round(clip.fps / options.rate), 1.0, static_cast<double>(kept.rows)));
    prepared.fps = clip.fps / static_cast<double>(prepared.step);
    double sigma = options.smoothing * clip.fps;
    Matrix between_breaks;
    ConstMatrixView from = kept;
    if (!clip.breaks.empty() && sigma > 0) {
        between_breaks = smoothed_rows(clip, kept, prepared.first, std::exchange(sigma, 0));
        from = between_breaks.view();
    }
    const bool is_copy = prepared.step > 1 || options.keep_rows || from.data != kept.data;
    if (is_copy)
        prepared.samples = gaussian_smoothed(from, sigma, Beyond::reflection, prepared.step);
    Matrix rows = kept.rows == all.rows() ? std::move(all) : copied(kept);
    if (is_copy) {
        if (options.keep_rows)
            prepared.rows = std::move(rows);
        return prepared;
    }
    prepared.samples = std::move(rows);
    if (sigma > 0)
        smooth_in_place(prepared.samples, sigma, Beyond::reflection);
    return prepared;
}

Matrix smoothed_features(const Clip& clip, Features kind, Axis up, double smoothing,
                         bool drop_tpose) {
    FeatureRows made = feature_rows(clip, kind, up);
    const Frames used = used_frames(clip, made, drop_tpose);
    const Matrix smoothed =
        smoothed_rows(clip, block(made.rows, used), used.begin, smoothing * clip.fps);
    std::copy_n(smoothed.data(), smoothed.rows() * smoothed.cols(), made.rows.row(used.begin));
    return std::move(made.rows);
}

} // namespace stltsa::clip
