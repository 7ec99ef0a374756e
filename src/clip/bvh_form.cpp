// SPDX-License-Identifier: BSD-3-Clause
#include "clip/bvh_form.hpp"

#include <algorithm>

#include "clip/angles.hpp"
#include "clip/formats.hpp"
#include "clip/kinematics.hpp"

namespace stltsa::clip {
namespace {

/// As the common BVH files of such skeletons are: every joint has three rotations, the root
/// (nothing else moves in an ASF skeleton) three positions before them.
Skeleton bvh_skeleton(const Skeleton& from) {
    Skeleton skeleton;
    skeleton.joints = from.joints;
    for (Joint& joint : skeleton.joints) {
        joint.axis = {};
        joint.channels.clear();
        if (!joint.end_site)
            joint.channels = {Channel::rz, Channel::ry, Channel::rx};
    }
    std::vector<Channel>& root = skeleton.joints[0].channels;
    root.insert(root.begin(), {Channel::tx, Channel::ty, Channel::tz});
    return skeleton;
}

/// Puts a pose into a row, which holds the row before.
void put_pose(const Skeleton& skeleton, const Pose& pose, double* row) {
    put_position(skeleton.joints[0], skeleton.translations_add, pose.position[0], row);
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
        pose.place(from, clip.values.row(i));
        if (i > 0)
            std::copy_n(values.row(i - 1), values.cols(), values.row(i));
        put_pose(*clip.skeleton, pose, values.row(i));
    }
    clip.values = std::move(values);
    clip.channel_names = channel_names(*clip.skeleton);
}

/// From positions that add to OFFSET to such that replace it, or back. This leaves the answer of
/// the rule as it was: it is the sign of the sum of o (2 v - o) over values v and offsets o, and v
/// + o in the place of v adds to a sum that is not negative, v - o takes from one that is.
void convert_positions(Clip& clip) {
    Skeleton& skeleton = *clip.skeleton;
    const double sign = skeleton.translations_add ? 1 : -1;
    Matrix& values = clip.values.edit();
    for (std::int64_t i = 0; i < values.rows(); ++i) {
        double* value = values.row(i);
        for (const Joint& joint : skeleton.joints)
            for (const Channel channel : joint.channels) {
                if (!is_rotation(channel) && joint.parent >= 0)
                    *value += sign * joint.offset[static_cast<std::size_t>(channel_axis(channel))];
                ++value;
            }
    }
    skeleton.translations_add = !skeleton.translations_add;
}

} // namespace

/// The original description of the format has translation channels add to OFFSET. In the files
/// that exist they replace it: the OFFSET of a root is a copy of its first position, and where
/// every joint has translations these repeat the OFFSETs (and the common importers replace). Only
/// where the translations below the root stay nearer to zero than to the OFFSETs do they add.
bool positions_add_to_offsets(const Skeleton& skeleton, const SharedMatrix& values) {
    double from_zero = 0;
    double from_offset = 0;
    for (std::int64_t frame = 0; frame < values.rows(); ++frame) {
        const double* value = values.row(frame);
        for (const Joint& joint : skeleton.joints)
            for (const Channel channel : joint.channels) {
                const double t = *value++;
                if (joint.parent < 0 || is_rotation(channel))
                    continue;
                const double o = joint.offset[static_cast<std::size_t>(channel_axis(channel))];
                from_zero += t * t;
                from_offset += (t - o) * (t - o);
            }
    }
    return from_zero < from_offset;
}

Clip in_bvh_form(const Clip& clip) {
    Clip result = clip;
    if (clip.skeleton->fixed_axes)
        convert_rotations(result);
    if (positions_add_to_offsets(*result.skeleton, result.values) !=
        result.skeleton->translations_add)
        convert_positions(result);
    return result;
}

} // namespace stltsa::clip
