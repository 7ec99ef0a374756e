// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/blend.hpp"

#include <algorithm>

#include "clip/body/angles.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/body/skeleton.hpp"
#include "synthesis/root.hpp"

namespace stltsa::synthesis {
namespace {

void blend_joint(const clip::Joint& joint, bool fixed_axes, const double* a, const double* b,
                 double weight_of_b, double* values) {
    const auto& channels = joint.channels;
    for (std::size_t c = 0; c < channels.size(); ++c)
        if (!clip::is_rotation(channels[c]))
            values[c] = (1 - weight_of_b) * a[c] + weight_of_b * b[c];
    if (std::any_of(channels.begin(), channels.end(), clip::is_rotation))
        clip::put_rotation(joint, fixed_axes,
                           slerp(clip::joint_rotation(joint, fixed_axes, a),
                                 clip::joint_rotation(joint, fixed_axes, b), weight_of_b),
                           values);
}

} // namespace

void blend_poses(const clip::Skeleton& skeleton, std::size_t first, const double* a,
                 const double* b, double weight_of_b, double* row) {
    std::size_t column = 0;
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
        const clip::Joint& joint = skeleton.joints[j];
        if (j >= first)
            blend_joint(joint, skeleton.fixed_axes, a + column, b + column, weight_of_b,
                        row + column);
        column += joint.channels.size();
    }
}

} // namespace stltsa::synthesis
