// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/checkpoint.hpp"
#include "clip/features/gap_notes.hpp"
#include "clip/features/point_heading.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/point_sides.hpp"
#include "clip/features/slow_part.hpp"
#include "clip/features/strays.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Sigma in seconds of the Gaussian that separates a slope from a jump.
constexpr double height_s = 2;
/// Up is no axis along which the points travel further than this share of the body's extent, if
/// there is another.
constexpr double most_travel = 0.5;

/// Repetitions of the prediction of gaps, each with a better path of the mean.
constexpr int path_rounds = 2;

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

/// Distance of left from right along each axis, of all frames and of all pairs that were chosen:
/// the mean.
Vec3 distance_of_sides(const Matrix& points, const Chosen& chosen,
                       const std::vector<SidePair>& pairs) {
    Vec3 sum{};
    std::int64_t count = 0;
    const auto is_chosen = [&](std::size_t point) {
        return std::ranges::binary_search(chosen, static_cast<std::int64_t>(point));
    };
    for (const auto& [one, other] : pairs) {
        if (!is_chosen(one) || !is_chosen(other))
            continue;
        for (std::int64_t i = 0; i < points.rows(); ++i, ++count)
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] +=
                    std::abs(points.row(i)[3 * one + axis] - points.row(i)[3 * other + axis]);
    }
    return (1 / std::max(static_cast<double>(count), 1.0)) * sum;
}

/// Bodies travel along the ground, are taller than wide, and have their sides beside each other: of
/// the axes along which the mean does not travel, that of the largest extent, less twice the
/// distance of the sides, as feet alone are longer and wider than high. If it travels along all,
/// the one with the least travel.
Axis guessed_up(const Matrix& points, const Chosen& chosen, const std::vector<SidePair>& pairs,
                const Matrix& path) {
    const Vec3 way = travel(path);
    const Vec3 size = extent(points, chosen), apart = distance_of_sides(points, chosen, pairs);
    const double body = *std::ranges::max_element(size);
    const double widest = *std::ranges::max_element(apart);
    Vec3 upright{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (way[axis] <= most_travel * body)
            upright[axis] = size[axis] + 2 * (widest - apart[axis]);
    if (upright == Vec3{})
        upright = {1 / way[0], 1 / way[1], 1 / way[2]};
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

/// Points in a plane as points in space, at height 0, or back.
Matrix with_columns(const Matrix& rows, int from, int to) {
    Matrix result(rows.rows(), rows.cols() / from * to);
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        for (std::int64_t p = 0; p < rows.cols() / from; ++p)
            std::copy_n(rows.row(i) + from * p, std::min(from, to), result.row(i) + to * p);
    return result;
}

/// Where a gap was filled over time, the path was that of other points than now.
void center(Matrix& points, const Chosen& chosen, Axis up) {
    if (up == Axis::none)
        return;
    Matrix path = means(points, chosen);
    for (std::int64_t i = 0; i < path.rows(); ++i)
        path(i, static_cast<std::int64_t>(up) - 1) = 0;
    subtract(points, chosen, path);
}

std::string removed(bool in_plane, bool turned) {
    const std::string path = in_plane ? "the path of their mean"
                                      : "the horizontal path of their mean, slow changes of its "
                                        "height";
    if (turned)
        return path + " and the heading";
    return path + (in_plane ? "; not the heading, which does not turn by a right angle"
                            : "; not the heading, as they spread along one line only");
}

/// Turns points in a plane only if they are seen from above: a body that is seen from the side
/// leans, but does not turn.
bool remove_heading_in_plane(Matrix& points, const Chosen& seen) {
    Matrix turned = copied(points.view());
    if (!remove_heading(turned, seen, Axis::z) ||
        !(turned_range(points, turned, seen, Axis::z) > std::numbers::pi / 2))
        return false;
    points = std::move(turned);
    return true;
}

/// Removes path and heading from points in space without gaps, and says so.
void remove_way(const Clip& clip, const Chosen& seen, bool in_plane, Axis up, FeatureRows& made) {
    if (std::ssize(seen) < least_points) {
        made.notes.push_back(format_text("path and heading of the points are kept: {} points have "
                                         "no shape, at least {} are needed",
                                         seen.size(), least_points));
        return;
    }
    const std::int64_t values = made.rows.rows() * made.rows.cols();
    Matrix path = means(made.rows, seen);
    checkpoint(values);
    const bool is_guess = up == Axis::none && !in_plane;
    made.up = in_plane   ? Axis::z
              : is_guess ? guessed_up(made.rows, seen, side_pairs(clip), path)
                         : up;
    if (is_guess)
        made.notes.push_back(
            format_text("up axis guessed: {}; if it is another, set option up_axis",
                        "xyz"[static_cast<std::size_t>(made.up) - 1]));
    if (!in_plane && !(clip.fps > 0))
        made.notes.push_back(format_text(
            "frame rate unknown: {} a second assumed, only to remove the slow height", usual_rate));
    if (!in_plane)
        keep_slow_height(path, made.up, clip.fps > 0 ? clip.fps : usual_rate);
    subtract(made.rows, seen, path);
    checkpoint(values);
    made.turned = in_plane ? remove_heading_in_plane(made.rows, seen)
                           : remove_heading(made.rows, seen, made.up);
    made.notes.push_back(
        format_text("columns taken as {} points in {}: removed {}; for the file's numbers set "
                    "option features to raw",
                    seen.size(), in_plane ? "a plane" : "space", removed(in_plane, made.turned)));
}

} // namespace

int point_columns(const Clip& clip) {
    return clip.space > 0 ? clip.space : 3;
}

Axis points_up(const Clip& clip) {
    if (point_columns(clip) != 3)
        return Axis::z;
    if (clip.up != Axis::none)
        return clip.up;
    Matrix filled = copied(clip.values.view());
    const Gaps gaps = fill_gaps(filled, 3, GapRule::fill, clip.fps);
    if (std::ssize(gaps.seen) < least_points)
        return Axis::none;
    return guessed_up(filled, gaps.seen, side_pairs(clip), means(filled, gaps.seen));
}

FeatureRows points(const Clip& clip, std::optional<Axis> up, GapRule rule) {
    const std::int64_t values = clip.frames() * clip.values.cols();
    const int width = point_columns(clip);
    FeatureRows made{copied(clip.values.view()), Axis::none, false, {}, {}};
    checkpoint(values);
    if (rule != GapRule::refuse)
        note_strays(clip, width, drop_strays(made.rows, width, clip.fps), made.notes);
    checkpoint(values);
    const Gaps gaps = fill_gaps(made.rows, width, rule, clip.fps);
    note_gaps(clip, width, rule, gaps, made.notes);
    made.holes = gaps.holes;
    if (width == 2)
        made.rows = with_columns(made.rows, 2, 3);
    remove_way(clip, gaps.seen, width == 2, up.value_or(clip.up), made);
    checkpoint(values);
    for (int round = 0; round < path_rounds && !gaps.predicted.empty(); ++round) {
        predict_gaps(made.rows, 3, gaps);
        center(made.rows, gaps.seen, made.up);
        checkpoint(values);
    }
    if (width == 2)
        made.rows = with_columns(made.rows, 3, 2);
    made.rows = with_all_frames(std::move(made.rows), gaps.kept, clip.frames());
    return made;
}

} // namespace stltsa::clip
