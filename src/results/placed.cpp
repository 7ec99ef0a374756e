// SPDX-License-Identifier: BSD-3-Clause
#include "results/placed.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "clip/features/prepare.hpp"
#include "ltsa/frames.hpp"

namespace stltsa::results {
namespace {

constexpr std::int64_t rows_per_block = 16;

/// Finds the place of each row, on all threads, and passes it to `put`.
template <class Find, class Put>
Placed place_rows(std::int64_t rows, const MapOptions& options, const Find& find, const Put& put) {
    Placed placed{std::vector<double>(static_cast<std::size_t>(rows)),
                  std::vector<std::int64_t>(static_cast<std::size_t>(rows))};
    const std::int64_t blocks = (rows + rows_per_block - 1) / rows_per_block;
    const auto place_block = [&](std::int64_t block) {
        const std::int64_t begin = block * rows_per_block;
        for (std::int64_t r = begin; r < std::min(begin + rows_per_block, rows); ++r) {
            const ltsa::Placement place = find(r);
            placed.distance[static_cast<std::size_t>(r)] = place.distance;
            placed.nearest[static_cast<std::size_t>(r)] = place.nearest;
            put(r, place);
        }
    };
    parallel_blocks(blocks, options.threads, place_block, Stage::map);
    return placed;
}

/// The features of one pose, computed alone, so that a row does not depend on the others.
void put_pose_features(const Fitted& fitted, const ltsa::Placement& place, double* out) {
    Matrix vector(1, fitted.kept.poses.cols());
    place.apply(fitted.kept.poses.view(), vector.row(0));
    const Matrix features = features_of_pose(fitted, vector.view());
    std::copy_n(features.row(0), features.cols(), out);
}

} // namespace

Placed map_rows(const Fitted& fitted, const ltsa::Mapping& mapping, ConstMatrixView frames,
                const HintOf& hint_of, const MapOptions& options, MatrixView coords) {
    return place_rows(
        frames.rows, options,
        [&](std::int64_t r) { return mapping.find_frame(frames.row(r), hint_of(r), options.maps); },
        [&](std::int64_t r, const ltsa::Placement& place) {
            place.apply(fitted.model.coords.view(), coords.row(r));
        });
}

Placed unmap_frames(const Fitted& fitted, const ltsa::Mapping& mapping, ConstMatrixView coords,
                    std::int64_t component, const HintOf& hint_of, const MapOptions& options,
                    MatrixView frames) {
    return place_rows(
        coords.rows, options,
        [&](std::int64_t r) {
            return mapping.find_point(coords.row(r), component, hint_of(r), options.maps);
        },
        [&](std::int64_t r, const ltsa::Placement& place) {
            if (fitted.kept.has_poses)
                put_pose_features(fitted, place, frames.row(r));
            else
                place.apply(fitted.kept.frames.view(), frames.row(r));
        });
}

Placed unmap_poses(const Fitted& fitted, const ltsa::Mapping& mapping, ConstMatrixView coords,
                   std::int64_t component, const HintOf& hint_of, const MapOptions& options,
                   MatrixView vectors) {
    return place_rows(
        coords.rows, options,
        [&](std::int64_t r) {
            return mapping.find_point(coords.row(r), component, hint_of(r), options.maps);
        },
        [&](std::int64_t r, const ltsa::Placement& place) {
            place.apply(fitted.kept.poses.view(), vectors.row(r));
        });
}

Matrix clip_features(const Fitted& fitted, const clip::Clip& clip) {
    if (fitted.source.clips.empty())
        fail(Status::unsupported, "the model was fitted to a matrix: map features (stltsa_map)");
    const auto& samples = fitted.source.samples;
    const bool of_points = samples.features == clip::Features::points;
    if (of_points && clip.skeleton)
        fail(Status::shape, "the model was fitted to points, but this clip has a skeleton");
    if (samples.features != clip::Features::raw && !of_points && !clip.skeleton)
        fail(Status::shape, "the model was fitted to poses, but this clip has no skeleton");
    report_progress(Stage::features, 0);
    Matrix frames = clip::smoothed_features(clip, samples.features, samples.up, samples.smoothing,
                                            fitted.kept.drop_tpose);
    if (frames.cols() != fitted.model.features)
        fail(Status::shape, "the clip has {} features; the model was fitted to {}", frames.cols(),
             fitted.model.features);
    ltsa::check_numbers(frames.view(), "features of the clip");
    return frames;
}

std::int64_t own_row(const Fitted& fitted, const Matrix& features, std::int64_t frame) {
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < fitted.source.clips.size(); ++c) {
        const ClipFacts& clip = fitted.source.clips[c];
        const std::int64_t rows = fitted.lengths[c];
        const std::int64_t row = (frame - clip.first) / clip.step;
        if (frame >= clip.first && (frame - clip.first) % clip.step == 0 && row < rows) {
            const double* own = fitted.kept.frames.row(begin + row);
            if (std::equal(own, own + features.cols(), features.row(frame)))
                return begin + row;
        }
        begin += rows;
    }
    return ltsa::no_hint;
}

} // namespace stltsa::results
