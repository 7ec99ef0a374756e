// SPDX-License-Identifier: BSD-3-Clause
// Where the body stands and which way it faces, against how it holds itself. Motion in the plane is
// kept as steps seen from the body, so that it goes on from wherever the body has come to.
#pragma once

#include <vector>

#include "clip/formats.hpp"
#include "clip/heading.hpp"

namespace stltsa::synthesis {

using clip::Quaternion;
using clip::Vec3;
using clip::operator+; // of Vec3, which is an array: its namespace is not searched
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
    double turn = 0; ///< radians about the up axis
    Vec3 way{};      ///< seen along the heading of the earlier frame; nothing along the up axis
};

/// The skeleton of the new clip and the joint that turns its body.
class Body {
  public:
    /// `root`: the joint that turns the body; those above it do not. `up`: not automatic.
    Body(const clip::Clip& clip, std::size_t root, clip::Axis up);

    const clip::Skeleton& skeleton() const { return skeleton_; }
    std::size_t root() const { return root_; }
    std::int64_t channels() const { return clip::channel_count(skeleton_); }
    /// Channels up to and with the root's: those that write() sets.
    std::int64_t root_channels() const;
    /// Whether a joint above the root turns in these frames.
    bool turns_above_root(const SharedMatrix& values) const;
    int up() const { return up_; }
    /// For a clip of its own: at its first frame.
    clip::Heading heading() const { return heading_; }

    RootState read(const clip::Pose& pose, const Quaternion& yaw) const;
    /// Puts the state into the channels of the root and of the joints above it, which are where
    /// they are in the first frame unless they carry the root. The root's numbers in `row` choose
    /// among angles that mean the same.
    void write(const RootState& state, double* row) const;

    RootState moved(const Placement& placement, const RootState& state) const;
    /// Which moves the body from one state to where another stands, facing the same way.
    Placement placement(const RootState& from, const RootState& to) const;
    Step step(const RootState& from, const RootState& to) const;
    /// Yaw and place in the plane after a step; height and tilt as they were.
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
            (1 - weight_of_b) * a.way + weight_of_b * b.way};
}

/// The shorter way round, at constant speed.
Quaternion slerp(const Quaternion& a, const Quaternion& b, double weight_of_b);

} // namespace stltsa::synthesis
