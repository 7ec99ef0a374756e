// SPDX-License-Identifier: BSD-3-Clause
#include "clip/body/heading.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "clip/body/skeleton.hpp"
#include "clip/body/up_axis.hpp"

namespace stltsa::clip {
namespace {

Quaternion about(int axis, double w, double v) {
    return {w, axis == 0 ? v : 0, axis == 1 ? v : 0, axis == 2 ? v : 0};
}

/// Squared length of the twist: 1 for a rotation about the axis only, 0 upside down.
double twist_size(const Quaternion& q, int axis) {
    const double v = component(q, axis);
    return q.w * q.w + v * v;
}

/// Whether the root's axes are upside down most of the time.
bool is_inverted(const Clip& clip, std::size_t root, int up) {
    // Axes at right angles to the world's give 1, 1/2 or 0.
    constexpr double threshold = 0.25;
    double sum = 0;
    Pose pose;
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame) {
        pose.place(*clip.skeleton, clip.values.row(frame), root + 1);
        sum += twist_size(pose.world[root], up);
    }
    return sum < threshold * static_cast<double>(clip.frames());
}

/// A joint stands still if its channels change by no more than this: exporters round, and smooth.
constexpr double least_degrees = 0.01;
constexpr double least_share = 1e-4; // of the longest bone

bool is_constant(const Matrix& values, std::int64_t column, double tolerance) {
    for (std::int64_t frame = 1; frame < values.rows(); ++frame)
        if (!(std::abs(values(frame, column) - values(0, column)) <= tolerance))
            return false;
    return true;
}

double longest_bone(const std::vector<Joint>& joints) {
    double longest = 0;
    for (const Joint& joint : joints)
        longest = std::max(longest, norm(joint.offset));
    return longest;
}

} // namespace

std::size_t body_root(const Clip& clip) {
    const std::vector<Joint>& joints = clip.skeleton->joints;
    std::int64_t column = 0;
    std::optional<std::size_t> moving;
    const double shift = least_share * longest_bone(joints);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const auto children = std::count_if(joints.begin(), joints.end(), [j](const Joint& joint) {
            return joint.parent == static_cast<int>(j);
        });
        for (const Channel channel : joints[j].channels) {
            const bool turns = is_rotation(channel);
            if (is_constant(clip.values, column++, turns ? least_degrees : shift))
                continue;
            if (turns)
                return j;
            if (!moving)
                moving = j;
        }
        if (children != 1)
            break;
    }
    return moving.value_or(0);
}

Heading::Heading(const Clip& clip, std::size_t root, Axis up)
    : Heading(root, up, is_inverted(clip, root, static_cast<int>(up) - 1)) {}

Heading::Heading(std::size_t root, Axis up, bool inverted)
    : root_(root), up_(static_cast<int>(up) - 1) {
    if (inverted)
        correction_ = about((up_ + 1) % 3, 0, 1);
}

Quaternion Heading::next(const Pose& pose) {
    if (up_ < 0)
        return yaw_;
    const Quaternion q = pose.world[root_] * correction_;
    const double size = twist_size(q, up_);
    constexpr double undefined = 1e-6; // within a tenth of a degree of upside down
    if (size > undefined)
        yaw_ = about(up_, q.w / std::sqrt(size), component(q, up_) / std::sqrt(size));
    return yaw_;
}

} // namespace stltsa::clip
