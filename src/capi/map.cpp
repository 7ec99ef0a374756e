// SPDX-License-Identifier: BSD-3-Clause
// Mapping both ways: stltsa_map, stltsa_unmap and the same for clips.
#include <memory>
#include <vector>

#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/options/reader.hpp"
#include "ltsa/frames.hpp"
#include "results/placed.hpp"

using namespace stltsa;
using capi::compute;
using capi::required;

namespace {

const ltsa::Mapping& mapping_of(const stltsa_model& model) {
    const ltsa::Mapping* mapping = capi::mapping_of(model);
    if (mapping == nullptr)
        fail(Status::unsupported, "the model kept no frames, so it cannot map: fit it with "
                                  "the option keep_frames");
    return *mapping;
}

/// Throws unless each row has `cols` numbers, all finite and not too large for distances.
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
    std::int64_t operator()(std::int64_t row) const {
        return rows_.empty() ? ltsa::no_hint : rows_[static_cast<std::size_t>(row)];
    }

  private:
    std::vector<std::int64_t> rows_;
};

/// The optional outputs of a mapping; NULL: not wanted.
struct PlacedOut {
    const stltsa_out* distance;
    const stltsa_out* nearest;

    void check(std::int64_t rows) const {
        if (distance != nullptr)
            capi::check_output(distance, "distance", rows, 1);
        if (nearest != nullptr)
            capi::check_integers(nearest, "nearest", rows);
    }
    void write(const results::Placed& placed) const {
        if (distance != nullptr)
            capi::write_column(distance, "distance", placed.distance);
        if (nearest != nullptr)
            capi::write_integers(nearest, "nearest", placed.nearest);
    }
};

std::int64_t component_of(const stltsa_model& model, const capi::OptionsReader& options) {
    const auto count = static_cast<std::int64_t>(model.model.components.size());
    const auto component = options.integer_if_set(STLTSA_OPT_COMPONENT);
    if (component && *component >= count)
        fail(Status::argument, "option component is {}; the model has {}", *component, count);
    if (!component && count > 1)
        fail(Status::disconnected,
             "the model has {} components, whose coordinates do not compare: say with the option "
             "component which the points are of",
             count);
    return component.value_or(0);
}

double rate_of_points(const stltsa_model& model, const capi::OptionsReader& options) {
    return options.real_if_set(STLTSA_OPT_FPS).value_or(model.source.samples.fps);
}

} // namespace

stltsa_status stltsa_map(const stltsa_model* model, const stltsa_in* frames, const stltsa_in* hints,
                         const stltsa_options* options, const stltsa_out* coords,
                         const stltsa_out* distance, const stltsa_out* nearest) noexcept {
    return compute(options, [&] {
        const ltsa::Mapping& mapping = mapping_of(required(model, "model"));
        const capi::OptionsReader reader(options);
        const capi::InputFrames input(frames, "frames");
        const std::int64_t rows = input.view().rows;
        check_points(input.view(), "frames", model->model.features, "features");
        Matrix mapped(rows, model->model.coords.cols());
        capi::check_output(coords, "coords", rows, mapped.cols());
        const PlacedOut out = {distance, nearest};
        out.check(rows);
        const auto placed =
            results::map_rows(*model, mapping, input.view(), Hints(hints, rows, *model),
                              reader.map_options(model->model.parameters), mapped.view());
        capi::write_output(coords, "coords", mapped.view());
        out.write(placed);
    });
}

stltsa_status stltsa_map_clip(const stltsa_model* model, const stltsa_clip* clip,
                              const stltsa_options* options, const stltsa_out* coords,
                              const stltsa_out* distance, const stltsa_out* nearest) noexcept {
    return compute(options, [&] {
        const ltsa::Mapping& mapping = mapping_of(required(model, "model"));
        const capi::OptionsReader reader(options);
        const std::int64_t rows = required(clip, "clip").clip.frames();
        Matrix mapped(rows, model->model.coords.cols());
        capi::check_output(coords, "coords", rows, mapped.cols());
        const PlacedOut out = {distance, nearest};
        out.check(rows);
        const Matrix features = results::clip_features(*model, clip->clip);
        const auto placed = results::map_rows(
            *model, mapping, features.view(),
            [&](std::int64_t r) { return results::own_row(*model, features, r); },
            reader.map_options(model->model.parameters), mapped.view());
        capi::write_output(coords, "coords", mapped.view());
        out.write(placed);
    });
}

stltsa_status stltsa_unmap(const stltsa_model* model, const stltsa_in* coords,
                           const stltsa_in* hints, const stltsa_options* options,
                           const stltsa_out* frames, const stltsa_out* distance,
                           const stltsa_out* nearest) noexcept {
    return compute(options, [&] {
        const ltsa::Mapping& mapping = mapping_of(required(model, "model"));
        const capi::OptionsReader reader(options);
        const capi::InputFrames input(coords, "coords");
        const std::int64_t rows = input.view().rows;
        check_points(input.view(), "coords", model->model.coords.cols(), "coordinates");
        Matrix unmapped(rows, model->model.features);
        capi::check_output(frames, "frames", rows, unmapped.cols());
        const PlacedOut out = {distance, nearest};
        out.check(rows);
        const auto placed = results::unmap_frames(
            *model, mapping, input.view(), component_of(*model, reader), Hints(hints, rows, *model),
            reader.map_options(model->model.parameters), unmapped.view());
        capi::write_output(frames, "frames", unmapped.view());
        out.write(placed);
    });
}

stltsa_status stltsa_unmap_clip(const stltsa_model* model, const stltsa_in* coords,
                                const stltsa_in* hints, const stltsa_options* options,
                                const stltsa_out* distance, const stltsa_out* nearest,
                                stltsa_clip** poses) noexcept {
    return compute(options, [&] {
        required(poses, "poses") = nullptr;
        const ltsa::Mapping& mapping = mapping_of(required(model, "model"));
        if (!model->kept.has_poses)
            fail(Status::unsupported, "the model was fitted to numbers without a skeleton, so "
                                      "it has no poses: unmap to frames (.csv or .npy)");
        const capi::OptionsReader reader(options);
        const capi::InputFrames input(coords, "coords");
        const std::int64_t rows = input.view().rows;
        check_points(input.view(), "coords", model->model.coords.cols(), "coordinates");
        if (rows == 0)
            fail(Status::shape, "coords has no rows; a clip has at least one frame");
        const PlacedOut out = {distance, nearest};
        out.check(rows);
        Matrix vectors(rows, model->kept.poses.cols());
        const auto placed = results::unmap_poses(
            *model, mapping, input.view(), component_of(*model, reader), Hints(hints, rows, *model),
            reader.map_options(model->model.parameters), vectors.view());
        auto made = std::make_unique<stltsa_clip>(
            clip::decode_poses(model->kept.code, vectors.view(), rate_of_points(*model, reader)));
        out.write(placed);
        *poses = made.release();
    });
}
