// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/points.hpp"

#include <algorithm>
#include <cmath>

#include "clip/features/point_gaps.hpp"
#include "clip/features/point_heading.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/slow_part.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Sigma in seconds of the Gaussian that separates a slope from a jump.
constexpr double height_s = 2;
/// Up is no axis along which the points travel further than this share of the body's extent, if
/// there is another.
constexpr double most_travel = 0.5;

/// Frames a second, if the clip does not give them.
constexpr double usual_rate = 100;

using Chosen = std::vector<std::int64_t>;

/// frames x 3.
Matrix means(const Matrix& points, const Chosen& chosen) {
    Matrix result(points.rows(), 3);
    for (std::int64_t i = 0; i < points.rows(); ++i)
        for (const std::int64_t p : chosen)
            for (std::int64_t axis = 0; axis < 3; ++axis)
                result(i, axis) += points(i, 3 * p + axis) / static_cast<double>(chosen.size());
    return result;
}

/// Distance along each axis between the ends of the path of the mean.
Vec3 travel(const Matrix& path) {
    Vec3 result{};
    for (std::int64_t axis = 0; axis < 3; ++axis) {
        double least = path(0, axis), most = least;
        for (std::int64_t i = 1; i < path.rows(); ++i) {
            least = std::min(least, path(i, axis));
            most = std::max(most, path(i, axis));
        }
        result[static_cast<std::size_t>(axis)] = most - least;
    }
    return result;
}

/// Size of the body along each axis, summed over some frames and divided by their number.
Vec3 extent(const Matrix& points, const Chosen& chosen) {
    constexpr std::int64_t most_frames = 200;
    const std::int64_t step = 1 + (points.rows() - 1) / most_frames;
    Vec3 sum{};
    std::int64_t frames = 0;
    for (std::int64_t i = 0; i < points.rows(); i += step, ++frames)
        for (std::int64_t axis = 0; axis < 3; ++axis) {
            const auto at = [&](std::int64_t p) { return points(i, 3 * p + axis); };
            const auto [low, high] = std::ranges::minmax(chosen, {}, at);
            sum[static_cast<std::size_t>(axis)] += at(high) - at(low);
        }
    return (1 / static_cast<double>(frames)) * sum;
}

/// Bodies travel along the ground and are taller than wide: of the axes along which the mean does
/// not travel, that of the largest extent; if it travels along all, the one with the least travel.
Axis guessed_up(const Matrix& points, const Chosen& chosen, const Matrix& path) {
    const Vec3 way = travel(path);
    const Vec3 size = extent(points, chosen);
    const double body = *std::ranges::max_element(size);
    Vec3 upright{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (way[axis] <= most_travel * body)
            upright[axis] = size[axis];
    if (upright == Vec3{})
        for (std::size_t axis = 0; axis < 3; ++axis)
            upright[axis] = 1 / way[axis];
    return largest(upright);
}

void subtract(Matrix& points, const Chosen& chosen, const Matrix& path) {
    for (std::int64_t i = 0; i < points.rows(); ++i)
        for (const std::int64_t p : chosen)
            for (std::int64_t axis = 0; axis < 3; ++axis)
                points(i, 3 * p + axis) -= path(i, axis);
}

/// Leaves the slow part of the path's height.
void keep_slow_height(Matrix& path, Axis up, double fps) {
    const std::int64_t axis = static_cast<std::int64_t>(up) - 1;
    Matrix height = Matrix::unset(path.rows(), 1);
    for (std::int64_t i = 0; i < path.rows(); ++i)
        height(i, 0) = path(i, axis);
    const Matrix slow = slow_part(height, height_s * fps);
    for (std::int64_t i = 0; i < path.rows(); ++i)
        path(i, axis) = slow(i, 0);
}

/// Its name, or its number from 1 if the columns have no such names.
std::string name_of(const Clip& clip, std::int64_t point) {
    const auto column = static_cast<std::size_t>(3 * point);
    if (!names_coordinate(clip.channel_names, column))
        return format_text("{}", point + 1);
    return quoted(point_name(clip.channel_names[column]));
}

/// The names of the first points, and the number of the others.
std::string listed(const Clip& clip, const Chosen& points) {
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, points.size()); ++i)
        text += (i == 0 ? "" : ", ") + name_of(clip, points[i]);
    if (points.size() > most)
        text += format_text(" and {} more", points.size() - most);
    return text;
}

void note_gaps(const Clip& clip, const Gaps& gaps, std::vector<std::string>& notes) {
    if (!gaps.filled.empty())
        notes.push_back(format_text("points missing in some frames, at (0, 0, 0) or without a "
                                    "value, filled linearly over time: {} ({} in all)",
                                    listed(clip, gaps.filled), gaps.frames));
    if (!gaps.dropped.empty())
        notes.push_back(
            format_text("points missing in more than half of the frames, left out (their features "
                        "are 0): {}",
                        listed(clip, gaps.dropped)));
}

} // namespace

Axis points_up(const Clip& clip) {
    Matrix filled = copied(clip.values.view());
    const Gaps gaps = fill_gaps(filled);
    if (std::ssize(gaps.seen) < least_points)
        return Axis::none;
    return guessed_up(filled, gaps.seen, means(filled, gaps.seen));
}

FeatureRows points(const Clip& clip, std::optional<Axis> up) {
    FeatureRows made{copied(clip.values.view()), Axis::none, {}};
    const Gaps gaps = fill_gaps(made.rows);
    note_gaps(clip, gaps, made.notes);
    if (std::ssize(gaps.seen) < least_points) {
        made.notes.push_back(format_text("path and heading of the points are kept: {} points have "
                                         "no shape, at least {} are needed",
                                         gaps.seen.size(), least_points));
        return made;
    }
    Matrix path = means(made.rows, gaps.seen);
    made.up = up ? *up : guessed_up(made.rows, gaps.seen, path);
    if (!up)
        made.notes.push_back(
            format_text("up axis guessed: {}; if it is another, set option up_axis",
                        "xyz"[static_cast<std::size_t>(made.up) - 1]));
    if (!(clip.fps > 0))
        made.notes.push_back(format_text(
            "frame rate unknown: {} a second taken, for the path and heading only", usual_rate));
    const double fps = clip.fps > 0 ? clip.fps : usual_rate;
    keep_slow_height(path, made.up, fps);
    subtract(made.rows, gaps.seen, path);
    const bool turned = remove_heading(made.rows, made.up, fps);
    made.notes.push_back(format_text(
        "columns taken as {} points in space: removed the horizontal path of their mean, slow "
        "changes of its height{}; for the file's numbers set option features to raw",
        gaps.seen.size(),
        turned ? " and the heading" : "; not the heading, as they spread along one line only"));
    return made;
}

} // namespace stltsa::clip
