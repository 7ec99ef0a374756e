// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/pose_features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "clip/body/kinematics.hpp"
#include "clip/body/skeleton.hpp"

namespace stltsa::clip {
namespace {

/// First two columns of the rotation matrix, which are continuous, unlike any set of angles (Zhou
/// et al., "On the Continuity of Rotation Representations in Neural Networks", 2019).
double* put_6d(const Quaternion& q, double* out) {
    for (const Vec3& column : {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0})})
        out = std::copy(column.begin(), column.end(), out);
    return out;
}

/// Columns of the rotation channels of all joints below the body root.
std::vector<std::size_t> angle_columns(const Skeleton& skeleton, std::size_t root) {
    std::vector<std::size_t> columns;
    std::size_t column = 0;
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j)
        for (const Channel channel : skeleton.joints[j].channels) {
            if (j > root && is_rotation(channel))
                columns.push_back(column);
            ++column;
        }
    return columns;
}

} // namespace

PoseFeatures::PoseFeatures(Skeleton skeleton, Features kind, Heading heading)
    : skeleton_(std::move(skeleton)), kind_(kind), heading_(heading),
      turning_(turning_joints(skeleton_, heading.root())),
      angles_(angle_columns(skeleton_, heading.root())) {
    count_ = channel_count(skeleton_);
    if (kind == Features::positions)
        count_ = 3 * (std::ssize(skeleton_.joints) - static_cast<std::int64_t>(heading.root()));
    else if (kind == Features::rotations6d)
        count_ = 6 * std::ssize(turning_);
    else if (kind == Features::euler)
        count_ = std::ssize(angles_);
    if (count_ == 0)
        fail(Status::unsupported, "no joint of this clip has rotations: use other features");
    near_.reserve(angles_.size());
    const std::size_t joints = skeleton_.joints.size();
    pose_.local.resize(joints);
    pose_.world.resize(joints);
    pose_.position.resize(joints);
}

void PoseFeatures::next(const Skeleton& skeleton, const double* row, double* features) {
    if (kind_ == Features::raw)
        std::copy_n(row, count_, features);
    else if (kind_ == Features::euler)
        put_angles(row, features);
    else {
        pose_.place(skeleton, row);
        put(features);
    }
}

void PoseFeatures::next(std::span<const Quaternion> local, const Vec3& root, double* features) {
    pose_.local.assign(local.begin(), local.end());
    pose_.place(skeleton_, root);
    put(features);
}

void PoseFeatures::stay_near(std::span<const double> features) {
    stays_ = true;
    if (kind_ == Features::euler)
        near_.assign(features.begin(), features.end());
}

/// Relative to the body root and its heading.
void PoseFeatures::put(double* features) {
    const std::size_t root = heading_.root();
    const Quaternion back = conjugate(heading_.next(pose_));
    if (kind_ == Features::positions) {
        for (std::size_t j = root; j < skeleton_.joints.size(); ++j) {
            const Vec3 p = rotate(back, pose_.position[j] - pose_.position[root]);
            features = std::copy(p.begin(), p.end(), features);
        }
        return;
    }
    for (const std::size_t j : turning_)
        features = put_6d(j == root ? back * pose_.world[root] : pose_.local[j], features);
}

void PoseFeatures::put_angles(const double* row, double* features) {
    constexpr double turn = 2 * std::numbers::pi;
    for (std::size_t c = 0; c < angles_.size(); ++c) {
        features[c] = to_radians(row[angles_[c]]);
        if (!near_.empty())
            features[c] -= turn * std::round((features[c] - near_[c]) / turn);
    }
    if (!stays_)
        near_.assign(features, features + angles_.size());
}

} // namespace stltsa::clip
