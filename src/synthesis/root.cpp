// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/root.hpp"

#include <algorithm>
#include <cmath>

#include "clip/body/angles.hpp"

namespace stltsa::synthesis {
namespace {

Quaternion normalized(const Quaternion& q) {
    const double size = std::sqrt(dot(q, q));
    return {q.w / size, q.x / size, q.y / size, q.z / size};
}

} // namespace

Body::Body(const clip::Clip& clip, std::size_t root, clip::Axis up)
    : skeleton_(*clip.skeleton), root_(root), up_(static_cast<int>(up) - 1),
      heading_(clip, root_, up) {
    const std::size_t columns = clip::channel_begins(skeleton_)[root_];
    above_.assign(clip.values.row(0), clip.values.row(0) + columns);
    if (root_ == 0)
        return;
    clip::Pose pose;
    pose.place(skeleton_, above_.data(), root_);
    const auto parent = static_cast<std::size_t>(skeleton_.joints[root_].parent);
    parent_rotation_ = pose.world[parent];
}

std::int64_t Body::root_channels() const {
    return static_cast<std::int64_t>(above_.size() + skeleton_.joints[root_].channels.size());
}

bool Body::turns_above_root(const Matrix& values) const {
    std::int64_t column = 0;
    for (std::size_t j = 0; j < root_; ++j)
        for (const clip::Channel channel : skeleton_.joints[j].channels) {
            if (clip::is_rotation(channel))
                for (std::int64_t frame = 1; frame < values.rows(); ++frame)
                    if (values(frame, column) != values(0, column))
                        return true;
            ++column;
        }
    return false;
}

RootState Body::read(const clip::Pose& pose, const Quaternion& yaw) const {
    return {pose.position[root_], yaw, conjugate(yaw) * pose.world[root_]};
}

void Body::write(const RootState& state, double* row) const {
    double* values = std::copy(above_.begin(), above_.end(), row);
    const clip::Joint& joint = skeleton_.joints[root_];
    clip::put_world_position(skeleton_, root_, state.position, row);
    clip::put_rotation(joint, skeleton_.fixed_axes,
                       conjugate(parent_rotation_) * state.yaw * state.tilt, values);
}

Vec3 Body::planar(Vec3 v) const {
    v[static_cast<std::size_t>(up_)] = 0;
    return v;
}

RootState Body::moved(const Placement& placement, const RootState& state) const {
    const auto up = static_cast<std::size_t>(up_);
    RootState result = state;
    result.position = rotate(placement.turn, state.position) + placement.shift;
    result.position[up] = state.position[up];
    result.yaw = placement.turn * state.yaw;
    return result;
}

Placement Body::placement(const RootState& from, const RootState& to) const {
    Placement result;
    result.turn = normalized(to.yaw * conjugate(from.yaw));
    result.shift = planar(to.position - rotate(result.turn, from.position));
    return result;
}

Step Body::step(const RootState& from, const RootState& to) const {
    const Quaternion turn = to.yaw * conjugate(from.yaw);
    Step result;
    result.turn =
        std::remainder(2 * std::atan2(component(turn, up_), turn.w), 2 * std::numbers::pi);
    result.displacement = planar(rotate(conjugate(from.yaw), to.position - from.position));
    return result;
}

RootState Body::after(const RootState& state, const Step& step) const {
    RootState result = state;
    result.position = state.position + planar(rotate(state.yaw, step.displacement));
    result.yaw = normalized(clip::axis_rotation(up_, step.turn) * state.yaw);
    return result;
}

Quaternion slerp(const Quaternion& a, const Quaternion& b, double weight_of_b) {
    return a * clip::rotation_by(weight_of_b * clip::rotation_vector(conjugate(a) * b));
}

} // namespace stltsa::synthesis
