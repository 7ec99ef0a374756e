// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features.hpp"

#include <algorithm>
#include <cmath>

#include "clip/formats.hpp"
#include "clip/heading.hpp"
#include "clip/kinematics.hpp"

namespace stltsa::clip {
namespace {

void need_skeleton(const Clip& clip, std::string_view what) {
    if (!clip.skeleton)
        fail(Status::unsupported, "{} need a skeleton: this clip is a bare matrix (use raw)", what);
}

bool turns(const Joint& joint) {
    return std::any_of(joint.channels.begin(), joint.channels.end(), is_rotation);
}

/// Calls body(pose, back, row) for every frame, `back` undoing the yaw of the body root.
template <class Body>
void for_each_pose(const Clip& clip, std::size_t root, Axis up, Matrix& rows, const Body& body) {
    Heading heading(clip, root, up);
    Pose pose;
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame) {
        pose.place(*clip.skeleton, clip.values.row(frame));
        body(pose, conjugate(heading.next(pose)), rows.row(frame));
    }
}

/// Positions relative to the body root, as seen along its heading.
Matrix body_positions(const Clip& clip, Axis up) {
    const std::size_t root = body_root(clip);
    const std::size_t count = clip.skeleton->joints.size();
    Matrix result(clip.frames(), static_cast<std::int64_t>(3 * (count - root)));
    for_each_pose(clip, root, up, result,
                  [&](const Pose& pose, const Quaternion& back, double* out) {
                      for (std::size_t j = root; j < count; ++j) {
                          const Vec3 p = rotate(back, pose.position[j] - pose.position[root]);
                          out = std::copy(p.begin(), p.end(), out);
                      }
                  });
    return result;
}

/// First two columns of the rotation matrix: continuous where every set of angles jumps (Zhou et
/// al., "On the Continuity of Rotation Representations in Neural Networks", 2019).
double* put_6d(const Quaternion& q, double* out) {
    for (const Vec3& column : {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0})})
        out = std::copy(column.begin(), column.end(), out);
    return out;
}

std::vector<std::size_t> turning_joints(const Clip& clip, std::size_t first) {
    std::vector<std::size_t> joints;
    for (std::size_t j = first; j < clip.skeleton->joints.size(); ++j)
        if (turns(clip.skeleton->joints[j]))
            joints.push_back(j);
    return joints;
}

Matrix rotations6d(const Clip& clip, Axis up) {
    const std::size_t root = body_root(clip);
    const std::vector<std::size_t> joints = turning_joints(clip, root);
    Matrix result(clip.frames(), static_cast<std::int64_t>(6 * joints.size()));
    for_each_pose(clip, root, up, result,
                  [&](const Pose& pose, const Quaternion& back, double* out) {
                      for (const std::size_t j : joints)
                          out = put_6d(j == root ? back * pose.world[root] : pose.local[j], out);
                  });
    return result;
}

/// Columns of the rotation channels of all joints below the body root.
std::vector<std::int64_t> angle_columns(const Clip& clip) {
    std::vector<std::int64_t> columns;
    const std::size_t root = body_root(clip);
    std::int64_t column = 0;
    for (std::size_t j = 0; j < clip.skeleton->joints.size(); ++j)
        for (const Channel channel : clip.skeleton->joints[j].channels) {
            if (j > root && is_rotation(channel))
                columns.push_back(column);
            ++column;
        }
    return columns;
}

Matrix euler(const Clip& clip) {
    constexpr double turn = 2 * std::numbers::pi;
    const std::vector<std::int64_t> columns = angle_columns(clip);
    Matrix result(clip.frames(), static_cast<std::int64_t>(columns.size()));
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame)
        for (std::int64_t c = 0; c < result.cols(); ++c) {
            double angle = to_radians(clip.values(frame, columns[static_cast<std::size_t>(c)]));
            if (frame > 0)
                angle -= turn * std::round((angle - result(frame - 1, c)) / turn);
            result(frame, c) = angle;
        }
    return result;
}

Matrix compute(const Clip& clip, Features kind, Axis up) {
    switch (kind) {
    case Features::positions:
        return body_positions(clip, up);
    case Features::rotations6d:
        return rotations6d(clip, up);
    case Features::euler:
        return euler(clip);
    default:
        return clip.values;
    }
}

/// Numbers near the largest double can overflow on the way through the skeleton.
void check_finite(const Matrix& matrix) {
    for (std::int64_t i = 0; i < matrix.rows(); ++i)
        if (!std::all_of(matrix.row(i), matrix.row(i) + matrix.cols(),
                         [](double value) { return std::isfinite(value); }))
            fail(Status::not_finite, "the numbers of frame {} are too large for a pose", i);
}

} // namespace

Matrix positions(const Clip& clip) {
    need_skeleton(clip, "positions");
    Matrix result(clip.frames(), static_cast<std::int64_t>(3 * clip.skeleton->joints.size()));
    Pose pose;
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame) {
        pose.place(*clip.skeleton, clip.values.row(frame));
        double* out = result.row(frame);
        for (const Vec3& p : pose.position)
            out = std::copy(p.begin(), p.end(), out);
    }
    check_finite(result);
    return result;
}

Matrix rotations(const Clip& clip) {
    need_skeleton(clip, "rotations");
    const std::size_t count = clip.skeleton->joints.size();
    Matrix result(clip.frames(), static_cast<std::int64_t>(4 * count));
    std::vector<Quaternion> previous(count);
    Pose pose;
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame) {
        pose.place(*clip.skeleton, clip.values.row(frame));
        double* out = result.row(frame);
        for (std::size_t j = 0; j < count; ++j) {
            const double sign = dot(pose.local[j], previous[j]) < 0 ? -1 : 1;
            const Quaternion& q = pose.local[j];
            previous[j] = {sign * q.w, sign * q.x, sign * q.y, sign * q.z};
            for (const double value : {previous[j].w, previous[j].x, previous[j].y, previous[j].z})
                *out++ = value;
        }
    }
    return result;
}

Features feature_kind(const Clip& clip, Features requested) {
    if (requested == Features::automatic)
        return clip.skeleton ? Features::positions : Features::raw;
    if (requested != Features::raw)
        need_skeleton(clip, "these features");
    return requested;
}

Matrix features(const Clip& clip, Features kind, Axis up) {
    Matrix result = compute(clip, feature_kind(clip, kind), up_axis(clip, up));
    if (result.cols() == 0)
        fail(Status::unsupported, "no joint of this clip has rotations: use other features");
    check_finite(result);
    return result;
}

} // namespace stltsa::clip
