// SPDX-License-Identifier: BSD-3-Clause
#include "clip/body/kinematics.hpp"

#include "clip/body/skeleton.hpp"

namespace stltsa::clip {

namespace {

bool is_one(const Quaternion& q) {
    return q.w == 1 && q.x == 0 && q.y == 0 && q.z == 0;
}

} // namespace

Quaternion joint_rotation(const Joint& joint, bool fixed_axes, const double* values) {
    Quaternion product;
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
        if (!is_rotation(joint.channels[c]))
            continue;
        const Quaternion turn =
            axis_rotation(channel_axis(joint.channels[c]), to_radians(values[c]));
        product = is_one(product) ? turn : fixed_axes ? turn * product : product * turn;
    }
    return is_one(joint.axis) ? product : joint.axis * product * conjugate(joint.axis);
}

Vec3 joint_translation(const Joint& joint, const double* values) {
    Vec3 offset = joint.offset;
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
        if (is_rotation(joint.channels[c]))
            continue;
        const auto axis = static_cast<std::size_t>(channel_axis(joint.channels[c]));
        offset[axis] = values[c] + (joint.adds ? joint.offset[axis] : 0);
    }
    return offset;
}

void Pose::place(const Skeleton& skeleton, const double* row, std::size_t count) {
    local.resize(count);
    world.resize(count);
    position.resize(count);
    for (std::size_t j = 0; j < count; ++j) {
        const Joint& joint = skeleton.joints[j];
        local[j] = joint_rotation(joint, skeleton.fixed_axes, row);
        const Vec3 offset = joint_translation(joint, row);
        row += joint.channels.size();
        place_joint(joint, j, offset);
    }
}

void Pose::place(const Skeleton& skeleton, const Vec3& root) {
    const std::size_t count = skeleton.joints.size();
    world.resize(count);
    position.resize(count);
    for (std::size_t j = 0; j < count; ++j)
        place_joint(skeleton.joints[j], j, j == 0 ? root : skeleton.joints[j].offset);
}

void Pose::place_joint(const Joint& joint, std::size_t j, const Vec3& offset) {
    if (joint.parent < 0) {
        world[j] = local[j];
        position[j] = offset;
    } else {
        const auto parent = static_cast<std::size_t>(joint.parent);
        world[j] = world[parent] * local[j];
        position[j] = position[parent] + rotate(world[parent], offset);
    }
}

} // namespace stltsa::clip
