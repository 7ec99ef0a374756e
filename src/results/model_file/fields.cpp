// SPDX-License-Identifier: BSD-3-Clause
#include "results/model_file/fields.hpp"

#include <algorithm>
#include <cmath>

#include "clip/body/quaternion.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/features.hpp"
#include "clip/formats.hpp"

namespace stltsa::results {
namespace {

void expect(bool right, const char* what) {
    if (!right)
        fail(Status::format, "the model is damaged: its {} cannot be", what);
}

template <class Enumeration>
bool in_range(Enumeration value, Enumeration first, Enumeration last) {
    return value >= first && value <= last;
}

bool finite(ConstMatrixView matrix) {
    return std::all_of(matrix.data, matrix.data + matrix.rows * matrix.cols,
                       [](double value) { return std::isfinite(value); });
}

bool finite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// A finite number that is not negative.
bool amount(double value) {
    return std::isfinite(value) && value >= 0;
}

bool sums_to(const std::vector<std::int64_t>& lengths, std::int64_t rows) {
    std::int64_t left = rows;
    for (const std::int64_t length : lengths) {
        if (length < 0 || length > left)
            return false;
        left -= length;
    }
    return left == 0;
}

void check_parameters(const ltsa::Parameters& p) {
    expect(p.dimension >= 1 && p.neighbors >= 1 && p.window >= 1 && p.links >= 0 &&
               p.exclusion >= 0 && in_range(p.mode, ltsa::Mode::temporal, ltsa::Mode::recurrent),
           "parameters");
}

void check_embedding(const ltsa::Model& model) {
    check_parameters(model.parameters);
    const std::int64_t rows = model.coords.rows();
    expect(rows >= 1 && model.coords.cols() == model.parameters.dimension &&
               finite(model.coords.view()),
           "coordinates");
    expect(model.features >= 1, "features");
    expect(sums_to(model.lengths, rows), "lengths");
    const auto components = static_cast<std::int64_t>(model.components.size());
    expect(static_cast<std::int64_t>(model.component_of.size()) == rows &&
               std::ranges::all_of(model.component_of,
                                   [&](std::int64_t c) { return c >= 0 && c < components; }),
           "components");
    for (const Warning& warning : model.warnings)
        expect(in_range(warning.code, WarningCode::follows_time, WarningCode::linear_phase),
               "warnings");
    for (const ltsa::Component& component : model.components)
        expect(static_cast<std::int64_t>(component.eigenvalues.size()) >=
                   model.parameters.dimension + 2,
               "eigenvalues");
}

void check_clip(const ClipFacts& clip, std::int64_t rows) {
    expect(clip::find_format(clip.format) != nullptr && amount(clip.fps), "clip");
    expect(clip.first >= 0 && clip.step >= 1 && clip.first < clip.frames &&
               rows - 1 <= (clip.frames - 1 - clip.first) / clip.step,
           "samples");
}

void check_source(const Source& source, const ltsa::Model& model,
                  const std::vector<std::int64_t>& lengths) {
    const std::int64_t rows = model.coords.rows();
    const SampleFacts& samples = source.samples;
    expect(source.clips.empty() || source.clips.size() == lengths.size(), "clips");
    for (std::size_t c = 0; c < source.clips.size(); ++c)
        check_clip(source.clips[c], lengths[c]);
    const ClipFacts first = source.clips.empty() ? ClipFacts() : source.clips.front();
    expect(samples.count == rows && samples.feature_count == model.features &&
               samples.first == first.first && samples.step == first.step && amount(samples.fps) &&
               amount(samples.smoothing) &&
               in_range(samples.features, clip::Features::positions, clip::Features::points) &&
               in_range(samples.up, clip::Axis::none, clip::Axis::z),
           "samples");
    expect(amount(source.period.period) &&
               source.period.period * samples.fps <= static_cast<double>(rows),
           "period");
}

bool is_unit(const clip::Quaternion& q) {
    return std::abs(clip::dot(q, q) - 1) < 1e-9;
}

void check_skeleton(const clip::Skeleton& skeleton) {
    const auto& joints = skeleton.joints;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const clip::Joint& joint = joints[j];
        expect(joint.parent >= -1 && joint.parent < static_cast<int>(j) &&
                   (j == 0) == (joint.parent == -1),
               "joints");
        expect(is_unit(joint.axis) &&
                   std::ranges::all_of(joint.offset, [](double o) { return std::isfinite(o); }) &&
                   std::ranges::all_of(joint.channels,
                                       [](clip::Channel c) {
                                           return in_range(c, clip::Channel::tx, clip::Channel::rz);
                                       }),
               "joints");
    }
}

void check_code(const clip::PoseCode& code) {
    expect(!code.skeleton.joints.empty(), "joints");
    check_skeleton(code.skeleton);
    const auto channels = static_cast<std::size_t>(clip::channel_count(code.skeleton));
    const auto is_column = [&](std::size_t c) { return c < channels; };
    expect(code.rest.size() == channels && finite(code.rest) &&
               code.channel_names.size() == channels,
           "channels");
    expect(clip::find_format(code.format) != nullptr &&
               (code.format != clip::Format::amc || !code.skeleton.asf.empty()) &&
               in_range(code.up, clip::Axis::x, clip::Axis::z) && amount(code.frame_time) &&
               code.root < code.skeleton.joints.size() &&
               code.means.size() == clip::turning_joints(code.skeleton, code.root).size() &&
               std::ranges::all_of(code.means, is_unit) &&
               std::ranges::all_of(code.moves, is_column),
           "pose code");
}

void check_kept(const Fitted& model) {
    const Kept& kept = model.kept;
    const std::int64_t rows = model.model.coords.rows();
    if (kept.frames.rows() > 0)
        expect(kept.frames.rows() == rows && kept.frames.cols() == model.model.features &&
                   finite(kept.frames.view()),
               "frames");
    if (!kept.has_poses)
        return;
    check_code(kept.code);
    expect(!model.source.clips.empty() && kept.frames.rows() == rows && kept.poses.rows() == rows &&
               kept.poses.cols() == kept.code.size() && finite(kept.poses.view()),
           "poses");
    const Matrix features = features_of_pose(model, kept.poses.view().block(0, 1));
    expect(features.cols() == model.model.features, "features");
}

void check_shape(const clip::Shape& shape, std::int64_t features) {
    const clip::ShapeRule& rule = shape.rule;
    expect(rule.width >= 1 && rule.width <= 3 && features % rule.width == 0 &&
               (!rule.travels || rule.width > 1) && (!rule.turns || rule.travels) &&
               (!rule.turns || rule.width == 2 || in_range(rule.up, clip::Axis::x, clip::Axis::z)),
           "shape");
    const auto directions = static_cast<std::int64_t>(shape.variances.size());
    expect(std::ssize(shape.used) * rule.width == features && std::ssize(shape.mean) == features &&
               shape.directions.rows() == directions && shape.directions.cols() == features &&
               std::ranges::all_of(shape.used, [](double u) { return u == 0 || u == 1; }) &&
               std::ranges::all_of(shape.variances, amount) && amount(shape.rest) &&
               finite(shape.mean) && finite(shape.directions.view()),
           "shape");
}

void check_body(const clip::Body& body, std::int64_t features) {
    expect(in_range(body.kind, clip::Features::positions, clip::Features::points) &&
               in_range(body.up, clip::Axis::none, clip::Axis::z),
           "body");
    if (body.skeleton.joints.empty()) {
        check_shape(body.shape, features);
        return;
    }
    check_skeleton(body.skeleton);
    expect(body.kind != clip::Features::points && body.root < body.skeleton.joints.size() &&
               std::ssize(body.usual) == features && finite(body.usual) &&
               clip::FrameFeatures(body).features() == features,
           "body");
}

void check_live(const Live& live, std::int64_t features) {
    if (!live.has_cycle)
        return;
    check_body(live.body, features);
    const phase::LiveCycle& c = live.cycle;
    const auto amounts = {c.rate, c.period, c.turns_per_second, c.variance, c.typical};
    expect(std::ranges::all_of(amounts, [](double v) { return amount(v) && v > 0; }) &&
               amount(c.usual_speed) && c.rate >= clip::lowest_fps && c.rate <= clip::highest_fps &&
               c.turns_per_second <= c.rate, // a cycle takes longer than a frame
           "mean cycle");
    const std::int64_t n = c.directions.rows();
    expect(c.features() == features && std::ssize(c.mean) == 2 * features &&
               c.directions.cols() == 2 * features && n >= 1 &&
               c.places.rows() == phase::place_count && c.places.cols() == n &&
               c.rests.rows() == phase::place_count && c.rests.cols() == n &&
               c.whitening.rows() == n && c.whitening.cols() == n,
           "mean cycle");
    expect(finite(c.weights) && finite(c.mean) && finite(c.directions.view()) &&
               finite(c.places.view()) && finite(c.rests.view()) && finite(c.whitening.view()),
           "mean cycle");
    expect(live.marks.size() <= phase::most_marks &&
               std::ranges::all_of(live.marks,
                                   [](const PhasedMark& mark) { return amount(mark.phase); }),
           "marks");
}

} // namespace

void check_model_fields(const Fitted& model) {
    check_embedding(model.model);
    expect(sums_to(model.lengths, model.model.coords.rows()), "lengths");
    check_source(model.source, model.model, model.lengths);
    check_kept(model);
    check_live(model.live, model.model.features);
}

} // namespace stltsa::results
