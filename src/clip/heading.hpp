// SPDX-License-Identifier: BSD-3-Clause
// What is removed from the poses: where the body stands and which way it faces.
#pragma once

#include "clip/features.hpp"
#include "clip/kinematics.hpp"

namespace stltsa::clip {

/// The joint that turns the body: the root, or, where an exporter put joints above the body's own
/// root that rest or only move along, the first below them that turns; where none turns, the first
/// that moves. Joints before it are its ancestors, joints after it its descendants.
std::size_t body_root(const Clip& clip);

/// The yaw of the body root: the twist about the up axis in the swing-twist decomposition of its
/// world rotation, frame by frame. Needs no names of joints.
class Heading {
  public:
    Heading(const Clip& clip, std::size_t root, Axis up);

    /// Of poses whose yaw has been taken away.
    explicit Heading(std::size_t root) : root_(root) {}

    /// Yaw of the next frame. Where it is undefined (upside down) the last one holds.
    Quaternion next(const Pose& pose);

    std::size_t root() const { return root_; }

  private:
    std::size_t root_;
    int up_ = -1; ///< index of the up axis; none: there is no yaw
    /// Turns the root's own axes, where they stand upside down while the body stands upright:
    /// there the twist is undefined.
    Quaternion correction_;
    Quaternion yaw_;
};

/// Features of a clip whose body root and heading are known; not Features::automatic.
Matrix body_features(const Clip& clip, Features kind, Heading heading);

} // namespace stltsa::clip
