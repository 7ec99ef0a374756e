// SPDX-License-Identifier: BSD-3-Clause
// Position and heading of the body, which are removed from the poses.
#pragma once

#include "clip/body/kinematics.hpp"
#include "clip/body/up_axis.hpp"

namespace stltsa::clip {

/// The joint that turns the body: from the root down to the first branch, the first joint that
/// rotates, or, if none does, the first that moves, or else the root. It is not the root if an
/// exporter has put joints above the body's own root that only shift, or that stand still, within
/// 0.01 degrees and 1e-4 of the longest bone. Joints before it are its ancestors, joints after it
/// its descendants.
std::size_t body_root(const Clip& clip);

/// The yaw of the body root, frame by frame: the twist about the up axis in the swing-twist
/// decomposition of its world rotation. Does not depend on joint names.
class Heading {
  public:
    Heading(const Clip& clip, std::size_t root, Axis up);

    /// Of another clip with the same root: `inverted` as found there.
    Heading(std::size_t root, Axis up, bool inverted);

    /// For poses whose yaw has been removed.
    explicit Heading(std::size_t root) : root_(root) {}

    /// Yaw of the next frame; if it is undefined (upside down), that of the previous one.
    Quaternion next(const Pose& pose);

    std::size_t root() const { return root_; }
    /// Whether the root's axes are upside down while the body is upright.
    bool inverted() const { return correction_.w == 0; }

  private:
    std::size_t root_;
    int up_ = -1; ///< index of the up axis; -1: there is no yaw
    /// Rotates the root's own axes if they are upside down while the body is upright, because the
    /// twist would be undefined.
    Quaternion correction_;
    Quaternion yaw_;
};

} // namespace stltsa::clip
