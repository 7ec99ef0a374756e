// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/frame_features.hpp"

#include <algorithm>
#include <cmath>

#include "clip/body/skeleton.hpp"
#include "clip/features/points.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

bool all_finite(const double* values, std::int64_t count) {
    return std::all_of(values, values + count, [](double v) { return std::isfinite(v); });
}

} // namespace

Body body_of(const Clip& clip, Features kind, Axis up, bool turned) {
    Body body;
    body.kind = kind;
    body.up = up;
    if (clip.skeleton) {
        body.skeleton = *clip.skeleton;
        body.skeleton.asf.clear(); // a text for writing files
        body.root = body_root(clip);
        body.inverted =
            kind != Features::raw && up != Axis::none && Heading(clip, body.root, up).inverted();
    } else if (kind == Features::points) {
        body.shape.rule = {point_columns(clip), up != Axis::none, turned, up};
    }
    return body;
}

void learn(Body& body, ConstMatrixView rows, std::span<const Frames> chosen,
           std::span<const std::int64_t> drifting) {
    if (body.skeleton.joints.empty()) {
        body.shape = learn_shape(rows, chosen, body.shape.rule, drifting);
        return;
    }
    body.usual.assign(static_cast<std::size_t>(rows.cols), 0);
    double count = 0;
    for (const Frames& frames : chosen)
        for (std::int64_t i = frames.begin; i < frames.end; ++i, ++count)
            for (std::size_t c = 0; c < body.usual.size(); ++c)
                body.usual[c] += rows(i, static_cast<std::int64_t>(c));
    for (double& value : body.usual)
        value /= count;
}

FrameFeatures::FrameFeatures(const Body& body) {
    if (body.skeleton.joints.empty()) {
        shape_.emplace(body.shape);
        values_ = shape_->count();
        space_ = body.shape.rule.width > 1 ? body.shape.rule.width : 0;
        return;
    }
    poses_.emplace(body.skeleton, body.kind, Heading(body.root, body.up, body.inverted));
    poses_->stay_near(body.usual);
    values_ = channel_count(body.skeleton);
}

bool FrameFeatures::next(const double* values, double* features) {
    if (shape_)
        return shape_->next(values, features);
    if (!all_finite(values, values_))
        return false;
    poses_->next(values, features);
    return true;
}

bool FrameFeatures::next(const Clip& clip, std::int64_t frame, double* features) {
    check_like(clip);
    const double* row = clip.values.row(frame);
    if (shape_)
        return shape_->next(row, features);
    if (!all_finite(row, clip.values.cols()))
        return false;
    poses_->next(*clip.skeleton, row, features);
    return true;
}

/// Joints must be the same, lengths of bones need not.
void FrameFeatures::check_like(const Clip& clip) const {
    if (clip.skeleton.has_value() != poses_.has_value())
        fail(Status::shape,
             "the model is of a clip {} a skeleton, this clip has {}: their features "
             "cannot be compared",
             poses_ ? "with" : "without", poses_ ? "none" : "one");
    if (shape_ && clip.values.cols() != values_)
        fail(Status::shape, "the clip has {} columns, that of the model {}", clip.values.cols(),
             values_);
    if (shape_)
        return;
    const auto& joints = clip.skeleton->joints;
    const auto& own = poses_->skeleton().joints;
    if (joints.size() != own.size())
        fail(Status::shape,
             "the clip has {} joints, that of the model {}: their features cannot be "
             "compared",
             joints.size(), own.size());
    for (std::size_t j = 0; j < own.size(); ++j)
        if (joints[j].parent != own[j].parent ||
            (of_channels() && joints[j].channels != own[j].channels))
            fail(Status::shape,
                 "joint {} ({}) has another parent or other channels than in the "
                 "clip of the model",
                 j, in_quotes(joints[j].name));
}

bool FrameFeatures::next(std::span<const Quaternion> local, const Vec3& root, double* features) {
    poses_->next(local, root, features);
    return all_finite(features, poses_->count());
}

} // namespace stltsa::clip
