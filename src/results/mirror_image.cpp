// SPDX-License-Identifier: BSD-3-Clause
#include "results/mirror_image.hpp"

#include <algorithm>
#include <limits>

#include "base/progress.hpp"
#include "clip/arrays/mirror.hpp"
#include "clip/features/column_owners.hpp"
#include "clip/features/drift.hpp"
#include "clip/features/points.hpp"
#include "phase/compare.hpp"
#include "phase/lag.hpp"
#include "results/turning.hpp"

namespace stltsa::results {
namespace {

/// A row for each frame of the file, NaN for those that were dropped.
Matrix by_frame(const Matrix& rows, std::int64_t frames, std::int64_t first) {
    Matrix result(frames, rows.cols());
    std::fill_n(result.data(), first * rows.cols(), std::numeric_limits<double>::quiet_NaN());
    const std::int64_t count = std::min(rows.rows(), frames - first);
    std::copy_n(rows.data(), count * rows.cols(), result.row(first));
    return result;
}

/// Features of every frame of the mirror image.
struct Image {
    Matrix rows;
    bool turned = false; ///< see ClipSamples
};

Image image_of(const clip::Clip& clip, const Phased& phased, clip::PrepareOptions prepare) {
    if (phased.samples.up != clip::Axis::none)
        prepare.up = phased.samples.up;
    const clip::Clip image = clip::mirrored(clip, prepare.up);
    prepare.features = phased.samples.features;
    prepare.rate = 0;
    prepare.smoothing = 0;
    const clip::Clip* single = &image;
    ClipSamples prepared = prepare_clips({&single, 1}, prepare);
    clip::remove_drift(prepared.samples, image.fps);
    const std::int64_t first = prepared.source.clips.front().first;
    return {by_frame(prepared.samples, phased.clip.frames, first), prepared.turned};
}

/// The horizontal columns of points whose heading was removed; otherwise none.
Level level_of(const clip::Clip& clip, const Phased& phased, bool turned) {
    if (phased.samples.features != clip::Features::points || !turned)
        return {};
    const int width = clip::point_columns(clip);
    const auto up = static_cast<std::int64_t>(phased.samples.up);
    if (width == 2)
        return {0, 1, 2};
    return {up % 3, (up + 1) % 3, 3};
}

/// The mirror plane goes through the middle of the body, but the heading of points lies only
/// roughly in it. Therefore the mirror image is turned so that the sides differ least. Otherwise,
/// points of a symmetric walk seem 8 mm apart (headings that differ by 1 degree).
void turn_to_sides(const phase::Resampled& own, const phase::Resampled& image, const Level& level,
                   Matrix& signals) {
    const ConstMatrixView mean = phase::once_around(image.mean);
    const Matrix later = phase::later(mean, static_cast<double>(mean.rows) / 2);
    turn_to(phase::once_around(own.mean), later.view(), level, signals);
}

} // namespace

void check_same_clip(const clip::Clip& clip, const FrameRows& rows) {
    if (clip.frames() != rows.clip.frames || clip.fps != rows.clip.fps)
        fail(Status::argument,
             "the result belongs to another clip: it has {} frames, and this clip has {}",
             rows.clip.frames, clip.frames());
    const clip::Features features = rows.samples.features;
    const bool any = features == clip::Features::raw;
    const bool points = features == clip::Features::points;
    if (!(any || points != clip.skeleton.has_value()) ||
        clip::column_owners(clip, features) != rows.owners)
        fail(Status::argument,
             "the result belongs to another clip: one with other joints or points");
}

Matrix rows_by_frame(const Phased& phased) {
    return by_frame(phased.rows, phased.clip.frames, phased.clip.first);
}

Matrix mirror_image(const clip::Clip& clip, const Phased& phased, std::int64_t label,
                    std::int64_t samples, const clip::PrepareOptions& prepare) {
    auto [image, turned] = image_of(clip, phased, prepare);
    if (const Level level = level_of(clip, phased, turned); level.width > 0) {
        report_progress(Stage::features, 1);
        turn_to_sides(resample(phased, label, rows_by_frame(phased).view(), samples),
                      resample(phased, label, image.view(), samples), level, image);
    }
    return std::move(image);
}

} // namespace stltsa::results
