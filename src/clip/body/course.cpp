// SPDX-License-Identifier: BSD-3-Clause
#include "clip/body/course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/checkpoint.hpp"
#include "clip/body/heading.hpp"

namespace stltsa::clip {
namespace {

enum Column : std::int64_t { along_column, across_column, way_column, turn_column, column_count };

/// Fewer points may lie on a line, which does not show a turn about itself.
constexpr std::int64_t fewest_points = 3;

double wrapped(double radians) {
    return std::remainder(radians, 2 * std::numbers::pi);
}

} // namespace

Course::Course(const Clip& clip, Axis up, int point_columns) {
    if (up == Axis::none || clip.frames() == 0)
        return;
    const std::int64_t axis = static_cast<std::int64_t>(up) - 1;
    plane_ = {(axis + 1) % 3, (axis + 2) % 3, point_columns};
    if (clip.skeleton) {
        course_ = Matrix(clip.frames(), column_count);
        follow_root(clip, up);
    } else if (point_columns > 0) {
        course_ = Matrix(clip.frames(), column_count);
        points_ = clip.values;
        follow_points(clip);
    }
}

void Course::advance(std::int64_t frame, const Motion& motion) {
    const double* before = course_.row(frame - 1);
    double* now = course_.row(frame);
    now[along_column] = before[along_column] + motion.along;
    now[across_column] = before[across_column] + motion.across;
    now[way_column] = before[way_column] + std::hypot(motion.along, motion.across);
    now[turn_column] = before[turn_column] + motion.turn;
}

void Course::follow_root(const Clip& clip, Axis up) {
    const std::size_t root = body_root(clip);
    Heading heading(clip, root, up);
    const int axis = static_cast<int>(up) - 1;
    Pose pose;
    Vec3 before{};
    double yaw_before = 0;
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        pose.place(*clip.skeleton, clip.values.row(i), root + 1);
        const Quaternion yaw = heading.next(pose);
        const double angle = 2 * std::atan2(component(yaw, axis), yaw.w);
        const Vec3& place = pose.position[root];
        const auto moved = [&](std::int64_t of) {
            return place[static_cast<std::size_t>(of)] - before[static_cast<std::size_t>(of)];
        };
        if (i > 0)
            advance(i, {moved(plane_.first), moved(plane_.second), wrapped(angle - yaw_before), 0});
        before = place;
        yaw_before = angle;
    }
}

/// Translation of the mean, and rotation by least squares, of the points that both frames have.
Course::Motion Course::motion_of_points(std::int64_t from, std::int64_t to) const {
    const double *a = points_.row(from), *b = points_.row(to);
    const std::int64_t step = plane_.columns;
    const auto seen = [&](std::int64_t p) {
        return !is_missing(a + p, plane_.columns) && !is_missing(b + p, plane_.columns);
    };
    double ax = 0, ay = 0, bx = 0, by = 0;
    Motion motion;
    for (std::int64_t p = 0; p < points_.cols(); p += step)
        if (seen(p)) {
            ax += a[p + plane_.first];
            ay += a[p + plane_.second];
            bx += b[p + plane_.first];
            by += b[p + plane_.second];
            ++motion.points;
        }
    if (motion.points == 0)
        return motion;
    const double count = static_cast<double>(motion.points);
    motion.along = (bx - ax) / count;
    motion.across = (by - ay) / count;
    double same = 0, turned = 0;
    for (std::int64_t p = 0; p < points_.cols(); p += step)
        if (seen(p)) {
            const double u = a[p + plane_.first] - ax / count,
                         v = a[p + plane_.second] - ay / count;
            const double x = b[p + plane_.first] - bx / count,
                         y = b[p + plane_.second] - by / count;
            same += u * x + v * y;
            turned += u * y - v * x;
        }
    motion.turn = std::atan2(turned, same);
    return motion;
}

void Course::follow_points(const Clip& clip) {
    std::int64_t last = 0; // where points were seen
    for (std::int64_t i = 1; i < clip.frames(); ++i) {
        const Motion motion = motion_of_points(last, i);
        checkpoint(2 * points_.cols());
        advance(i, motion);
        if (motion.points > 0 || motion_of_points(last, last).points == 0)
            last = i;
    }
}

double Course::at(double frame, std::int64_t column) const {
    const double inside = std::clamp(frame, 0.0, static_cast<double>(course_.rows() - 1));
    const auto before = static_cast<std::int64_t>(inside);
    const std::int64_t after = std::min(before + 1, course_.rows() - 1);
    return std::lerp(course_(before, column), course_(after, column),
                     inside - static_cast<double>(before));
}

double Course::turn_between(double begin, double end) const {
    const double followed = at(end, turn_column) - at(begin, turn_column);
    if (points_.rows() == 0)
        return followed;
    // Errors of the turn from frame to frame add up, but tell the number of full turns.
    const double last = static_cast<double>(course_.rows() - 1);
    const Motion whole = motion_of_points(std::llround(std::clamp(begin, 0.0, last)),
                                          std::llround(std::clamp(end, 0.0, last)));
    if (whole.points < fewest_points)
        return std::numeric_limits<double>::quiet_NaN();
    return followed + wrapped(whole.turn - followed);
}

Travel Course::between(double begin, double end) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    if (course_.rows() == 0)
        return {unknown, unknown, unknown};
    return {at(end, way_column) - at(begin, way_column),
            std::hypot(at(end, along_column) - at(begin, along_column),
                       at(end, across_column) - at(begin, across_column)),
            turn_between(begin, end) * (180 / std::numbers::pi)};
}

} // namespace stltsa::clip
