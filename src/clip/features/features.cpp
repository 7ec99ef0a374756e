// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/features.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/checkpoint.hpp"
#include "base/numbers.hpp"
#include "clip/body/heading.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/gap_notes.hpp"
#include "clip/features/points.hpp"
#include "clip/features/pose_features.hpp"
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

/// Called before gaps are predicted and before smoothing, which turn larger numbers into NaN.
/// `gaps`: NaN is a missing value.
void check_magnitude(const Matrix& matrix, bool gaps = false) {
    for (std::int64_t i = 0; i < matrix.rows(); ++i) {
        checkpoint(matrix.cols());
        const double* row = matrix.row(i);
        const double* found = std::find_if_not(row, row + matrix.cols(), [gaps](double value) {
            return std::abs(value) <= largest_number || (gaps && std::isnan(value));
        });
        if (found != row + matrix.cols())
            fail(Status::not_finite,
                 "the features of frame {} are too large: column {} is {}; beyond {} distances are "
                 "infinite; use another unit",
                 i, found - row, *found, largest_number);
    }
}

/// The values of a bare matrix, with its gaps filled.
FeatureRows raw_rows(const Clip& clip, GapRule rule) {
    FeatureRows made;
    made.rows = Matrix::unset(clip.frames(), clip.values.cols());
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        std::copy_n(clip.values.row(i), clip.values.cols(), made.rows.row(i));
        checkpoint(clip.values.cols());
    }
    const Gaps gaps = fill_gaps(made.rows, 1, rule, clip.fps);
    note_gaps(clip, 1, rule, gaps, made.notes);
    predict_gaps(made.rows, 1, gaps);
    made.holes = gaps.holes;
    made.rows = with_all_frames(std::move(made.rows), gaps.kept, clip.frames());
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
    check_magnitude(result);
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
    if (!clip.skeleton)
        return clip.values.cols();
    return PoseFeatures(*clip.skeleton, kind, Heading(body_root(clip))).count();
}

Matrix body_features(const Clip& clip, Features kind, Heading heading) {
    if (kind == Features::raw)
        return clip.values;
    PoseFeatures features(*clip.skeleton, kind, heading);
    Matrix rows = Matrix::unset(clip.frames(), features.count());
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame) {
        features.next(clip.values.row(frame), rows.row(frame));
        checkpoint(work_of_channel * clip.values.cols());
    }
    return rows;
}

FeatureRows feature_rows(const Clip& clip, std::optional<Features> requested,
                         std::optional<Axis> up, GapRule rule) {
    feature_count(clip, requested); // fails if there are none
    const Features kind = feature_kind(clip, requested);
    if (!clip.skeleton)
        check_magnitude(clip.values, true);
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
    check_magnitude(made.rows, false);
    return made;
}

Matrix features(const Clip& clip, std::optional<Features> requested, std::optional<Axis> up) {
    return feature_rows(clip, requested, up).rows;
}

} // namespace stltsa::clip
