// SPDX-License-Identifier: BSD-3-Clause
// Position and heading of the body, separate from its posture. Motion in the plane is represented
// by steps relative to the body, so that it can continue from any position and heading.
#pragma once

#include <vector>

#include "clip/body/heading.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/body/up_axis.hpp"

namespace stltsa::synthesis {

using clip::Quaternion;
using clip::Vec3;
using clip::operator+; // Vec3 is a std::array, so argument-dependent lookup does not find them
using clip::operator-;
using clip::operator*;

/// The body root in the world: its rotation is yaw * tilt.
struct RootState {
    Vec3 position{};
    Quaternion yaw;  ///< about the up axis
    Quaternion tilt; ///< free of yaw
};

/// A turn about the up axis and a shift in the plane.
struct Placement {
    Quaternion turn;
    Vec3 shift{};
};

/// The motion in the plane from one frame to the next.
struct Step {
    double turn = 0;     ///< radians about the up axis
    Vec3 displacement{}; ///< relative to the heading of the earlier frame; 0 along the up axis
};

/// The skeleton of the new clip and the joint that turns its body.
class Body {
  public:
    /// `root`: the joint that turns the body; joints above it do not.
    Body(const clip::Clip& clip, std::size_t root, clip::Axis up);

    const clip::Skeleton& skeleton() const { return skeleton_; }
    std::size_t root() const { return root_; }
    std::int64_t channels() const { return clip::channel_count(skeleton_); }
    /// Number of channels up to and including the root's: those that write() sets.
    std::int64_t root_channels() const;
    /// Whether a joint above the root turns in these frames.
    bool turns_above_root(const Matrix& values) const;
    int up() const { return up_; }
    /// Heading at the first frame of the body's own clip.
    clip::Heading heading() const { return heading_; }

    RootState read(const clip::Pose& pose, const Quaternion& yaw) const;
    /// Writes the state into the channels of the root and of the joints above it; the latter keep
    /// their values of the first frame unless they carry the root. Of equivalent angles it chooses
    /// those nearest to the previous contents of `row`.
    void write(const RootState& state, double* row) const;

    RootState moved(const Placement& placement, const RootState& state) const;
    /// The rigid motion in the plane that takes one state to the position and heading of another.
    Placement placement(const RootState& from, const RootState& to) const;
    Step step(const RootState& from, const RootState& to) const;
    /// The state after a step: yaw and position in the plane change, height and tilt do not.
    RootState after(const RootState& state, const Step& step) const;

  private:
    Vec3 planar(Vec3 v) const;

    clip::Skeleton skeleton_;
    std::size_t root_;
    int up_;
    clip::Heading heading_;
    std::vector<double> above_; ///< channels of the joints above the root
    Quaternion parent_rotation_;
};

inline Step mix(const Step& a, const Step& b, double weight_of_b) {
    return {(1 - weight_of_b) * a.turn + weight_of_b * b.turn,
            (1 - weight_of_b) * a.displacement + weight_of_b * b.displacement};
}

/// Along the shorter arc, at constant speed.
Quaternion slerp(const Quaternion& a, const Quaternion& b, double weight_of_b);

} // namespace stltsa::synthesis
