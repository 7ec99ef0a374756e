// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/features.hpp"

#include <algorithm>
#include <cmath>

#include "clip/body/heading.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/gap_notes.hpp"
#include "clip/features/points.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

void need_skeleton(const Clip& clip, std::string_view what) {
    if (!clip.skeleton)
        fail(Status::unsupported, "{} need a skeleton, and this clip is a bare matrix", what);
}

void need_points(const Clip& clip) {
    if (clip.skeleton)
        fail(Status::unsupported, "points are features of clips without a skeleton: use positions");
    if (clip.values.cols() % point_columns(clip) != 0)
        fail(Status::unsupported,
             "points have three columns each, and this clip has {} columns: remove those that are "
             "no coordinates",
             clip.values.cols());
}

/// Calls body(pose, back, row) for every frame; `back` reverses the yaw of the body root.
template <class Body>
void for_each_pose(const Clip& clip, Heading heading, Matrix& rows, const Body& body) {
    Pose pose;
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame) {
        pose.place(*clip.skeleton, clip.values.row(frame));
        body(pose, conjugate(heading.next(pose)), rows.row(frame));
    }
}

/// Positions relative to the body root and its heading.
Matrix body_positions(const Clip& clip, Heading heading) {
    const std::size_t root = heading.root();
    const std::size_t count = clip.skeleton->joints.size();
    Matrix result(clip.frames(), static_cast<std::int64_t>(3 * (count - root)));
    for_each_pose(clip, heading, result,
                  [&](const Pose& pose, const Quaternion& back, double* out) {
                      for (std::size_t j = root; j < count; ++j) {
                          const Vec3 p = rotate(back, pose.position[j] - pose.position[root]);
                          out = std::copy(p.begin(), p.end(), out);
                      }
                  });
    return result;
}

/// First two columns of the rotation matrix, which are continuous, unlike any set of angles (Zhou
/// et al., "On the Continuity of Rotation Representations in Neural Networks", 2019).
double* put_6d(const Quaternion& q, double* out) {
    for (const Vec3& column : {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0})})
        out = std::copy(column.begin(), column.end(), out);
    return out;
}

Matrix rotations6d(const Clip& clip, Heading heading) {
    const std::size_t root = heading.root();
    const std::vector<std::size_t> joints = turning_joints(*clip.skeleton, root);
    Matrix result(clip.frames(), static_cast<std::int64_t>(6 * joints.size()));
    for_each_pose(clip, heading, result,
                  [&](const Pose& pose, const Quaternion& back, double* out) {
                      for (const std::size_t j : joints)
                          out = put_6d(j == root ? back * pose.world[root] : pose.local[j], out);
                  });
    return result;
}

/// Columns of the rotation channels of all joints below the body root.
std::vector<std::int64_t> angle_columns(const Clip& clip, std::size_t root) {
    std::vector<std::int64_t> columns;
    std::int64_t column = 0;
    for (std::size_t j = 0; j < clip.skeleton->joints.size(); ++j)
        for (const Channel channel : clip.skeleton->joints[j].channels) {
            if (j > root && is_rotation(channel))
                columns.push_back(column);
            ++column;
        }
    return columns;
}

Matrix euler(const Clip& clip, std::size_t root) {
    constexpr double turn = 2 * std::numbers::pi;
    const std::vector<std::int64_t> columns = angle_columns(clip, root);
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

/// Values near the largest double can overflow in the forward kinematics.
void check_finite(const Matrix& matrix) {
    for (std::int64_t i = 0; i < matrix.rows(); ++i)
        if (!std::all_of(matrix.row(i), matrix.row(i) + matrix.cols(),
                         [](double value) { return std::isfinite(value); }))
            fail(Status::not_finite,
                 "the values in frame {} are too large: the features are not finite", i);
}

/// The values of a bare matrix, with its gaps filled.
FeatureRows raw_rows(const Clip& clip, GapRule rule) {
    FeatureRows made{copied(clip.values.view()), Axis::none, {}, {}};
    const Gaps gaps = fill_gaps(made.rows, 1, rule, clip.fps);
    if (gaps.filled.empty() && gaps.dropped.empty())
        return made;
    note_gaps(clip, 1, rule, gaps, made.notes);
    predict_gaps(made.rows, 1, gaps);
    made.holes = gaps.holes;
    return made;
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

Features feature_kind(const Clip& clip, std::optional<Features> requested) {
    if (!requested && clip.skeleton)
        return Features::positions;
    if (!requested)
        return clip.space > 0 ? Features::points : Features::raw;
    if (*requested == Features::points)
        need_points(clip);
    else if (*requested != Features::raw)
        need_skeleton(clip, "features other than raw and points");
    return *requested;
}

std::int64_t feature_count(const Clip& clip, std::optional<Features> requested) {
    const Features kind = feature_kind(clip, requested);
    const bool of_joints = kind != Features::raw && kind != Features::points;
    const std::size_t root = of_joints ? body_root(clip) : 0;
    std::int64_t count = clip.values.cols();
    if (kind == Features::positions)
        count = 3 * static_cast<std::int64_t>(clip.skeleton->joints.size() - root);
    else if (kind == Features::rotations6d)
        count = 6 * std::ssize(turning_joints(*clip.skeleton, root));
    else if (kind == Features::euler)
        count = std::ssize(angle_columns(clip, root));
    if (count == 0)
        fail(Status::unsupported, "no joint of this clip has rotations: use other features");
    return count;
}

Matrix body_features(const Clip& clip, Features kind, Heading heading) {
    switch (kind) {
    case Features::positions:
        return body_positions(clip, heading);
    case Features::rotations6d:
        return rotations6d(clip, heading);
    case Features::euler:
        return euler(clip, heading.root());
    default:
        return clip.values;
    }
}

FeatureRows feature_rows(const Clip& clip, std::optional<Features> requested,
                         std::optional<Axis> up, GapRule rule) {
    feature_count(clip, requested); // fails if there are none
    const Features kind = feature_kind(clip, requested);
    FeatureRows made;
    if (kind == Features::points) {
        made = points(clip, up, rule);
    } else if (!clip.skeleton) {
        made = raw_rows(clip, rule);
    } else {
        made.up = up_axis(clip, up);
        made.rows = kind == Features::raw
                        ? clip.values
                        : body_features(clip, kind, Heading(clip, body_root(clip), made.up));
    }
    check_finite(made.rows);
    return made;
}

Matrix features(const Clip& clip, std::optional<Features> requested, std::optional<Axis> up) {
    return feature_rows(clip, requested, up).rows;
}

} // namespace stltsa::clip
