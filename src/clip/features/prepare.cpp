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

ConstMatrixView from_row(const Matrix& matrix, std::int64_t first) {
    return matrix.view().block(first, matrix.rows() - first);
}

/// Smoothed over time, but not over breaks of the clip. Row 0 is frame `first`.
Matrix smoothed_rows(const Clip& clip, ConstMatrixView rows, std::int64_t first, double sigma,
                     const std::function<void()>& poll) {
    if (clip.breaks.empty())
        return gaussian_smoothed(rows, sigma, Beyond::reflection, 1, poll);
    Matrix result = Matrix::unset(rows.rows, rows.cols);
    std::vector<std::int64_t> ends = clip.breaks;
    ends.push_back(first + rows.rows);
    std::int64_t begin = 0;
    for (const std::int64_t end : ends) {
        const std::int64_t count = end - first - begin;
        if (count <= 0)
            continue; // within the T-pose
        const Matrix run =
            gaussian_smoothed(rows.block(begin, count), sigma, Beyond::reflection, 1, poll);
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
    FeatureRows made =
        feature_rows(clip, prepared.features, options.up, options.gaps, options.poll);
    prepared.up = made.up;
    prepared.turned = made.turned;
    prepared.notes = std::move(made.notes);
    prepared.holes = std::move(made.holes);
    for (const std::int64_t frame : clip.breaks)
        prepared.holes.push_back({frame, frame});
    std::ranges::sort(prepared.holes, {}, &Frames::begin);
    Matrix& all = made.rows;
    prepared.first = dropped_frames(clip, all, options.drop_tpose);
    ConstMatrixView kept = from_row(all, prepared.first);
    if (const std::int64_t jump = find_jump(kept); jump > 0)
        prepared.jump = prepared.first + jump;
    // Decimation and smoothing are in seconds, so they need a frame rate.
    if (clip.fps > 0 && options.rate > 0)
        prepared.step = static_cast<std::int64_t>(
            std::clamp(std::round(clip.fps / options.rate), 1.0, static_cast<double>(all.rows())));
    prepared.fps = clip.fps / static_cast<double>(prepared.step);
    double sigma = options.smoothing * clip.fps;
    Matrix between_breaks;
    ConstMatrixView from = kept;
    if (!clip.breaks.empty() && sigma > 0) {
        between_breaks =
            smoothed_rows(clip, kept, prepared.first, std::exchange(sigma, 0), options.poll);
        from = between_breaks.view();
    }
    const bool is_copy = prepared.step > 1 || options.keep_rows || from.data != kept.data;
    if (is_copy)
        prepared.samples =
            gaussian_smoothed(from, sigma, Beyond::reflection, prepared.step, options.poll);
    Matrix rows = prepared.first == 0 ? std::move(all) : copied(kept);
    if (is_copy) {
        if (options.keep_rows)
            prepared.rows = std::move(rows);
        return prepared;
    }
    prepared.samples = std::move(rows);
    if (sigma > 0)
        smooth_in_place(prepared.samples, sigma, Beyond::reflection, options.poll);
    return prepared;
}

Matrix smoothed_features(const Clip& clip, Features kind, Axis up, double smoothing,
                         bool drop_tpose, const std::function<void()>& poll) {
    const Matrix all = features(clip, kind, up);
    const std::int64_t first = dropped_frames(clip, all, drop_tpose);
    const Matrix smoothed =
        smoothed_rows(clip, from_row(all, first), first, smoothing * clip.fps, poll);
    Matrix result = copied(all.view());
    std::copy_n(smoothed.data(), smoothed.rows() * smoothed.cols(), result.row(first));
    return result;
}

} // namespace stltsa::clip
