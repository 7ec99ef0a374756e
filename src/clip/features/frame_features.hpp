// SPDX-License-Identifier: BSD-3-Clause
// Features of single frames, as a stream brings them: no frame depends on those after it.
#pragma once

#include <optional>
#include <span>

#include "clip/features/pose_features.hpp"
#include "clip/features/shape.hpp"

namespace stltsa::clip {

/// What is known of the body before a frame comes.
struct Body {
    Features kind = Features::raw;
    Axis up = Axis::none;
    Skeleton skeleton;    ///< no joints: there is none
    std::size_t root = 0; ///< the body root (heading.hpp)
    bool inverted = false;
    std::vector<double> usual; ///< of a skeleton: the mean of its features
    Shape shape;               ///< without a skeleton
};

/// Of a clip, but for what learn() adds. `turned`: see FeatureRows.
Body body_of(const Clip& clip, Features kind, Axis up, bool turned);

/// Learns from features of the clip, finite. `chosen`: the frames that count; `drifting`: columns
/// to leave out.
void learn(Body& body, ConstMatrixView rows, std::span<const Frames> chosen,
           std::span<const std::int64_t> drifting);

/// Allocates when it is made, and never again.
class FrameFeatures {
  public:
    explicit FrameFeatures(const Body& body);

    bool has_skeleton() const { return poses_.has_value(); }
    bool of_channels() const { return !poses_ || poses_->of_channels(); }
    /// Of the clip; only if has_skeleton().
    const Skeleton& skeleton() const { return poses_->skeleton(); }
    /// Numbers of a frame: channels of the skeleton, or columns.
    std::int64_t values() const { return values_; }
    std::int64_t features() const { return poses_ ? poses_->count() : shape_->count(); }
    int space() const { return space_; } ///< coordinates of a point; 0: there are no points

    /// `values`: a row of a clip. False if too little is known of the frame.
    bool next(const double* values, double* features);
    /// The same of a frame of a clip with the same joints or columns; Status::shape for another
    /// one.
    bool next(const Clip& clip, std::int64_t frame, double* features);
    /// The same of local rotations and the root's position; not if of_channels().
    bool next(std::span<const Quaternion> local, const Vec3& root, double* features);

  private:
    void check_like(const Clip& clip) const;

    std::optional<PoseFeatures> poses_;
    std::optional<ShapeFeatures> shape_;
    std::int64_t values_ = 0;
    int space_ = 0;
};

} // namespace stltsa::clip
