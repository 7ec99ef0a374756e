// SPDX-License-Identifier: BSD-3-Clause
#include "clip/bvh/form.hpp"

#include <algorithm>

#include "base/checkpoint.hpp"
#include "clip/body/angles.hpp"
#include "clip/body/heading.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/body/skeleton.hpp"

namespace stltsa::clip {
namespace {

/// The usual channels of BVH files of ASF skeletons: three rotations for every joint, preceded by
/// three positions for the root (no other joint of an ASF skeleton translates).
Skeleton bvh_skeleton(const Skeleton& from) {
    Skeleton skeleton;
    skeleton.joints = from.joints;
    for (Joint& joint : skeleton.joints) {
        joint.axis = {};
        joint.adds = false;
        joint.channels.clear();
        if (!joint.end_site)
            joint.channels = {Channel::rz, Channel::ry, Channel::rx};
    }
    std::vector<Channel>& root = skeleton.joints[0].channels;
    root.insert(root.begin(), {Channel::tx, Channel::ty, Channel::tz});
    return skeleton;
}

/// Writes a pose into a row, which contains the previous row.
void put_pose(const Skeleton& skeleton, const Pose& pose, double* row) {
    put_position(skeleton.joints[0], pose.position[0], row);
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
        put_rotation(skeleton.joints[j], skeleton.fixed_axes, pose.local[j], row);
        row += skeleton.joints[j].channels.size();
    }
}

void convert_rotations(Clip& clip) {
    const Skeleton from = *clip.skeleton;
    clip.skeleton = bvh_skeleton(from);
    Matrix values(clip.frames(), channel_count(*clip.skeleton));
    Pose pose;
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        checkpoint(work_of_channel * values.cols());
        pose.place(from, clip.values.row(i));
        if (i > 0)
            std::copy_n(values.row(i - 1), values.cols(), values.row(i));
        put_pose(*clip.skeleton, pose, values.row(i));
    }
    clip.values = std::move(values);
    clip.channel_names = channel_names(*clip.skeleton);
}

/// Indices of the joints in depth-first order, children in the order of the list.
std::vector<std::size_t> depth_first(const std::vector<Joint>& joints) {
    std::vector<std::vector<std::size_t>> children(joints.size());
    for (std::size_t j = joints.size(); j-- > 1;)
        children[static_cast<std::size_t>(joints[j].parent)].push_back(j);
    std::vector<std::size_t> order;
    for (std::vector<std::size_t> open{0}; !open.empty();) {
        const std::size_t next = open.back();
        open.pop_back();
        order.push_back(next);
        open.insert(open.end(), children[next].begin(), children[next].end());
    }
    return order;
}

/// Puts joints and their columns into the order of a BVH file; arrays may come in another.
void reorder(Clip& clip) {
    const std::vector<Joint> joints = clip.skeleton->joints;
    const std::vector<std::size_t> order = depth_first(joints);
    if (std::ranges::is_sorted(order))
        return;
    std::vector<int> place(order.size());
    std::vector<std::int64_t> columns;
    const std::vector<std::size_t> begins = channel_begins(*clip.skeleton);
    for (std::size_t to = 0; to < order.size(); ++to) {
        const Joint& joint = joints[order[to]];
        place[order[to]] = static_cast<int>(to);
        clip.skeleton->joints[to] = joint;
        if (joint.parent >= 0)
            clip.skeleton->joints[to].parent = place[static_cast<std::size_t>(joint.parent)];
        for (std::size_t c = 0; c < joint.channels.size(); ++c)
            columns.push_back(static_cast<std::int64_t>(begins[order[to]] + c));
    }
    const Matrix from = std::move(clip.values);
    clip.values = Matrix(from.rows(), from.cols());
    for (std::int64_t i = 0; i < from.rows(); ++i)
        for (std::int64_t c = 0; c < from.cols(); ++c)
            clip.values(i, c) = from(i, columns[static_cast<std::size_t>(c)]);
    clip.channel_names = channel_names(*clip.skeleton);
}

/// Converts positions to the meaning that the joints of `to` give them.
void convert_positions(Clip& clip, Skeleton to) {
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        double* values = clip.values.row(i);
        for (std::size_t j = 0; j < to.joints.size(); ++j) {
            const Joint& from = clip.skeleton->joints[j];
            if (from.adds != to.joints[j].adds)
                put_position(to.joints[j], joint_translation(from, values), values);
            values += from.channels.size();
        }
    }
    clip.skeleton = std::move(to);
}

/// 1: the joint's positions lie nearer to zero than to its OFFSET; -1: farther; 0: neither.
int vote(const Joint& joint, const Matrix& values, std::int64_t column) {
    double from_zero = 0;
    double from_offset = 0;
    for (const Channel channel : joint.channels) {
        const double offset = joint.offset[static_cast<std::size_t>(channel_axis(channel))];
        for (std::int64_t i = 0; i < values.rows() && !is_rotation(channel); ++i) {
            const double value = values(i, column);
            from_zero += value * value;
            from_offset += (value - offset) * (value - offset);
        }
        ++column;
    }
    return (from_zero < from_offset ? 1 : 0) - (from_offset < from_zero ? 1 : 0);
}

} // namespace

Skeleton with_positions(Skeleton skeleton, bool below) {
    for (Joint& joint : skeleton.joints)
        joint.adds = below && joint.parent >= 0;
    return skeleton;
}

/// In the original description of the format, positions add to OFFSET. In existing files they
/// replace it: the OFFSET of a root is a copy of its first position, joints with position channels
/// repeat their OFFSETs, and the common importers replace. So positions add only if more joints
/// stay nearer to zero than to their OFFSETs.
///
/// Each joint has one vote, except those that carry the body through space: how far they travel
/// says nothing about the others. Of 48 clips with a static root, hips that travel and 20 joints
/// that repeat their OFFSETs, one sum of squares over all joints misreads 34, and this rule none.
/// With the exception alone, a prop that travels below the hips would be misread; with the votes
/// alone, hips that are the only joint with positions below a static root.
bool positions_add_to_offsets(const Clip& clip) {
    const std::vector<Joint>& joints = clip.skeleton->joints;
    const std::vector<std::size_t> begins = channel_begins(*clip.skeleton);
    int votes = 0;
    for (std::size_t j = body_root(clip) + 1; j < joints.size(); ++j)
        votes += vote(joints[j], clip.values, static_cast<std::int64_t>(begins[j]));
    return votes > 0;
}

Clip in_bvh_form(const Clip& clip) {
    Clip result = clip;
    reorder(result);
    if (clip.skeleton->fixed_axes)
        convert_rotations(result);
    convert_positions(result, with_positions(*result.skeleton, false));
    // If most joints would be misread one way, most are read correctly the other way.
    if (positions_add_to_offsets(result))
        convert_positions(result, with_positions(*result.skeleton, true));
    return result;
}

} // namespace stltsa::clip
