// SPDX-License-Identifier: BSD-3-Clause
// Mapping both ways: stltsa_map, stltsa_unmap and the same for clips.
#include <algorithm>
#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "capi/arrays.hpp"
#include "capi/guard.hpp"
#include "capi/mapping.hpp"
#include "capi/options.hpp"
#include "clip/features.hpp"
#include "clip/prepare.hpp"
#include "linalg/blas_threads.hpp"
#include "ltsa/frames.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

constexpr std::int64_t rows_per_block = 16;

const ltsa::Mapping& mapping_of(const stltsa_model& model) {
    const ltsa::Mapping* mapping = capi::mapping_of(model);
    if (mapping == nullptr)
        fail(Status::unsupported, "the model kept no frames, so that it cannot map: fit it with "
                                  "the option keep_frames");
    return *mapping;
}

ltsa::MapParameters map_parameters(const stltsa_model& model, const capi::OptionsReader& options) {
    const ltsa::Parameters& fitted = model.model.parameters;
    ltsa::MapParameters p;
    p.neighbors = options.integer(STLTSA_OPT_MAP_NEIGHBORS);
    if (p.neighbors == 0)
        p.neighbors = std::max<std::int64_t>(fitted.dimension + 5, 10);
    p.blend = options.integer(STLTSA_OPT_MAP_BLEND);
    p.hint_window = options.integer(STLTSA_OPT_HINT_WINDOW);
    if (p.hint_window == 0)
        p.hint_window = std::max<std::int64_t>(fitted.neighbors / 5, 1);
    return p;
}

/// Throws unless there are `cols` numbers in each row that distances can be taken of.
void check_points(ConstMatrixView points, const char* name, std::int64_t cols, const char* what) {
    if (points.cols != cols)
        fail(Status::shape, "{} has {} columns; the model has {} {}", name, points.cols, cols,
             what);
    ltsa::check_numbers(points, name);
}

/// The caller's hints, or none.
class Hints {
  public:
    Hints(const stltsa_in* hints, std::int64_t rows, const stltsa_model& model) {
        if (hints == nullptr)
            return;
        if (hints->rows != rows)
            fail(Status::shape, "hints has {} rows; {} are needed", hints->rows, rows);
        rows_ = capi::input_integers(hints, "hints");
        const std::int64_t count = model.model.coords.rows();
        for (std::size_t r = 0; r < rows_.size(); ++r)
            if (rows_[r] < ltsa::no_hint || rows_[r] >= count)
                fail(Status::argument,
                     "hint {} is {}; it must be a row of the model, 0 to {}, or -1 for none", r,
                     rows_[r], count - 1);
    }
    std::int64_t operator[](std::int64_t row) const {
        return rows_.empty() ? ltsa::no_hint : rows_[static_cast<std::size_t>(row)];
    }

  private:
    std::vector<std::int64_t> rows_;
};

/// Where points lie on the model.
struct Placed {
    std::vector<double> distance;
    std::vector<std::int64_t> nearest;

    explicit Placed(std::int64_t rows)
        : distance(static_cast<std::size_t>(rows)), nearest(static_cast<std::size_t>(rows)) {}

    /// NULL where the caller does not ask.
    static void check(const stltsa_out* distance, const stltsa_out* nearest, std::int64_t rows) {
        if (distance != nullptr)
            capi::check_output(distance, "distance", rows, 1);
        if (nearest != nullptr)
            capi::check_integers(nearest, "nearest", rows);
    }
    void write(const stltsa_out* distance_out, const stltsa_out* nearest_out) const {
        if (distance_out != nullptr)
            capi::write_column(distance_out, "distance", distance);
        if (nearest_out != nullptr)
            capi::write_integers(nearest_out, "nearest", nearest);
    }
};

/// Finds the place of each row, on all threads, and hands it to `put`.
template <class Find, class Put>
Placed place_rows(std::int64_t rows, const capi::OptionsReader& options, const Find& find,
                  const Put& put) {
    const SingleThreadedBlas single;
    Placed placed(rows);
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
    parallel_blocks(blocks, options.threads(), place_block, [&](std::int64_t done) {
        options.progress().report(Stage::map,
                                  static_cast<double>(done) / static_cast<double>(blocks));
    });
    return placed;
}

template <class HintOf>
Placed map_rows(const stltsa_model& model, ConstMatrixView frames, const HintOf& hint_of,
                const capi::OptionsReader& options, Matrix& coords) {
    const ltsa::Mapping& mapping = mapping_of(model);
    const auto p = map_parameters(model, options);
    coords = Matrix(frames.rows, model.model.coords.cols());
    return place_rows(
        frames.rows, options,
        [&](std::int64_t r) { return mapping.find_frame(frames.row(r), hint_of(r), p); },
        [&](std::int64_t r, const ltsa::Placement& place) {
            place.apply(model.model.coords.view(), coords.row(r));
        });
}

std::int64_t component_of(const stltsa_model& model, const capi::OptionsReader& options) {
    const auto count = static_cast<std::int64_t>(model.model.components.size());
    const std::int64_t component = options.integer(STLTSA_OPT_COMPONENT);
    if (component >= count)
        fail(Status::argument, "option component is {}; the model has {}", component, count);
    if (component < 0 && count > 1)
        fail(Status::disconnected,
             "the model has {} components, whose coordinates do not compare: say with the option "
             "component which the points are of",
             count);
    return std::max<std::int64_t>(component, 0);
}

double rate_of_points(const stltsa_model& model, const capi::OptionsReader& options) {
    const double fps = options.real(STLTSA_OPT_FPS);
    return fps > 0 ? fps : model.source.samples.fps;
}

template <class Put>
Placed unmap_rows(const stltsa_model& model, ConstMatrixView coords, const Hints& hints,
                  const capi::OptionsReader& options, const Put& put) {
    const ltsa::Mapping& mapping = mapping_of(model);
    const auto p = map_parameters(model, options);
    const std::int64_t component = component_of(model, options);
    return place_rows(
        coords.rows, options,
        [&](std::int64_t r) { return mapping.find_point(coords.row(r), component, hints[r], p); },
        put);
}

/// The features of a pose, which is taken for itself, so that a row does not depend on the others.
void put_pose_features(const stltsa_model& model, const ltsa::Placement& place, double* out) {
    Matrix vector(1, model.kept.poses.cols());
    place.apply(model.kept.poses.view(), vector.row(0));
    const Matrix features = capi::features_of_pose(model, vector.view());
    std::copy_n(features.row(0), features.cols(), out);
}

Matrix clip_features(const stltsa_model& model, const clip::Clip& clip) {
    if (model.source.clips.empty())
        fail(Status::unsupported, "the model was fitted to a matrix: map features (stltsa_map)");
    const auto& samples = model.source.samples;
    if (samples.features != clip::Features::raw && !clip.skeleton)
        fail(Status::shape, "the model was fitted to poses, and this clip is bare numbers");
    Matrix frames = clip::smoothed_features(clip, samples.features, samples.up, samples.smoothing,
                                            model.kept.drop_tpose);
    if (frames.cols() != model.model.features)
        fail(Status::shape, "the clip has {} features; the model was fitted to {}", frames.cols(),
             model.model.features);
    ltsa::check_numbers(frames.view(), "features of the clip");
    return frames;
}

/// The row that was fitted to this very frame of the clip, or none.
std::int64_t own_row(const stltsa_model& model, const Matrix& frames, std::int64_t frame) {
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < model.source.clips.size(); ++c) {
        const capi::ClipFacts& clip = model.source.clips[c];
        const std::int64_t rows = model.model.lengths[c];
        const std::int64_t row = (frame - clip.first) / clip.step;
        if (frame >= clip.first && (frame - clip.first) % clip.step == 0 && row < rows) {
            const double* fitted = model.kept.frames.row(begin + row);
            if (std::equal(fitted, fitted + frames.cols(), frames.row(frame)))
                return begin + row;
        }
        begin += rows;
    }
    return ltsa::no_hint;
}

} // namespace

stltsa_status stltsa_map(const stltsa_model* model, const stltsa_in* frames, const stltsa_in* hints,
                         const stltsa_options* options, const stltsa_out* coords,
                         const stltsa_out* distance, const stltsa_out* nearest) noexcept {
    return guard([&] {
        mapping_of(required(model, "model"));
        const capi::OptionsReader reader(options);
        const capi::InputFrames input(frames, "frames");
        const std::int64_t rows = input.view().rows;
        check_points(input.view(), "frames", model->model.features, "features");
        capi::check_output(coords, "coords", rows, model->model.coords.cols());
        Placed::check(distance, nearest, rows);
        const Hints checked(hints, rows, *model);
        Matrix mapped;
        const Placed placed = map_rows(
            *model, input.view(), [&](std::int64_t r) { return checked[r]; }, reader, mapped);
        capi::write_output(coords, "coords", mapped.view());
        placed.write(distance, nearest);
    });
}

stltsa_status stltsa_map_clip(const stltsa_model* model, const stltsa_clip* clip,
                              const stltsa_options* options, const stltsa_out* coords,
                              const stltsa_out* distance, const stltsa_out* nearest) noexcept {
    return guard([&] {
        mapping_of(required(model, "model"));
        const capi::OptionsReader reader(options);
        const std::int64_t rows = required(clip, "clip").clip.frames();
        capi::check_output(coords, "coords", rows, model->model.coords.cols());
        Placed::check(distance, nearest, rows);
        const Matrix frames = clip_features(*model, clip->clip);
        Matrix mapped;
        const Placed placed = map_rows(
            *model, frames.view(), [&](std::int64_t r) { return own_row(*model, frames, r); },
            reader, mapped);
        capi::write_output(coords, "coords", mapped.view());
        placed.write(distance, nearest);
    });
}

stltsa_status stltsa_unmap(const stltsa_model* model, const stltsa_in* coords,
                           const stltsa_in* hints, const stltsa_options* options,
                           const stltsa_out* frames, const stltsa_out* distance,
                           const stltsa_out* nearest) noexcept {
    return guard([&] {
        mapping_of(required(model, "model"));
        const capi::OptionsReader reader(options);
        const capi::InputFrames input(coords, "coords");
        const std::int64_t rows = input.view().rows;
        check_points(input.view(), "coords", model->model.coords.cols(), "coordinates");
        capi::check_output(frames, "frames", rows, model->model.features);
        Placed::check(distance, nearest, rows);
        const Hints checked(hints, rows, *model);
        Matrix unmapped(rows, model->model.features);
        const Placed placed =
            unmap_rows(*model, input.view(), checked, reader,
                       [&](std::int64_t r, const ltsa::Placement& place) {
                           if (model->kept.has_poses)
                               put_pose_features(*model, place, unmapped.row(r));
                           else
                               place.apply(model->kept.frames.view(), unmapped.row(r));
                       });
        capi::write_output(frames, "frames", unmapped.view());
        placed.write(distance, nearest);
    });
}

stltsa_status stltsa_unmap_clip(const stltsa_model* model, const stltsa_in* coords,
                                const stltsa_in* hints, const stltsa_options* options,
                                const stltsa_out* distance, const stltsa_out* nearest,
                                stltsa_clip** poses) noexcept {
    return guard([&] {
        required(poses, "poses") = nullptr;
        mapping_of(required(model, "model"));
        if (!model->kept.has_poses)
            fail(Status::unsupported, "the model was fitted to bare numbers, which are no poses: "
                                      "unmap to frames, which are numbers too (.csv or .npy)");
        const capi::OptionsReader reader(options);
        const capi::InputFrames input(coords, "coords");
        const std::int64_t rows = input.view().rows;
        check_points(input.view(), "coords", model->model.coords.cols(), "coordinates");
        if (rows == 0)
            fail(Status::shape, "coords has no rows; a clip has at least one frame");
        Placed::check(distance, nearest, rows);
        const Hints checked(hints, rows, *model);
        Matrix vectors(rows, model->kept.poses.cols());
        const Placed placed = unmap_rows(*model, input.view(), checked, reader,
                                         [&](std::int64_t r, const ltsa::Placement& place) {
                                             place.apply(model->kept.poses.view(), vectors.row(r));
                                         });
        auto made = std::make_unique<stltsa_clip>(stltsa_clip{
            clip::decode_poses(model->kept.code, vectors.view(), rate_of_points(*model, reader))});
        placed.write(distance, nearest);
        *poses = made.release();
    });
}
