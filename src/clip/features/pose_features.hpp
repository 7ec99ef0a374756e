// SPDX-License-Identifier: BSD-3-Clause
// Features of a skeleton, frame by frame.
#pragma once

#include <span>
#include <vector>

#include "clip/body/heading.hpp"
#include "clip/features/features.hpp"

namespace stltsa::clip {

/// Allocates only when it is made.
class PoseFeatures {
  public:
    /// Of positions, rotations6d, euler or raw. Status::unsupported if there are none.
    PoseFeatures(Skeleton skeleton, Features kind, Heading heading);

    std::int64_t count() const { return count_; }
    const Skeleton& skeleton() const { return skeleton_; }
    /// Whether they depend on more than the rotations of the joints: on how a file writes them.
    bool of_channels() const { return kind_ == Features::euler || kind_ == Features::raw; }

    /// `row`: a value for each channel of the skeleton, or of another one with the same joints.
    void next(const double* row, double* features) { next(skeleton_, row, features); }
    void next(const Skeleton& skeleton, const double* row, double* features);
    /// Of local rotations, one for each joint, and the root's position. Not if of_channels().
    void next(std::span<const Quaternion> local, const Vec3& root, double* features);

    /// From here on angles are those nearest to these features, not to the frame before: a stream
    /// may have frames that are wrong.
    void stay_near(std::span<const double> features);

  private:
    void put(double* features);
    void put_angles(const double* row, double* features);

    Skeleton skeleton_;
    Features kind_;
    Heading heading_;
    Pose pose_;
    std::vector<std::size_t> turning_; ///< joints
    std::vector<std::size_t> angles_;  ///< columns of the channels that are features
    std::vector<double> near_; ///< angles of the frame before, none before the first; or usual ones
    bool stays_ = false;       ///< near_ does not follow the frames
    std::int64_t count_ = 0;
};

} // namespace stltsa::clip
