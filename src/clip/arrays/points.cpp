// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "clip/arrays/arrays.hpp"
#include "clip/arrays/even_times.hpp"
#include "clip/arrays/missing_codes.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

void check_shapes(const PointArrays& arrays) {
    const ConstMatrixView& given = arrays.positions;
    if (arrays.space != 2 && arrays.space != 3)
        fail(Status::argument, "space is {}: points have 2 or 3 coordinates", arrays.space);
    if (given.rows < 1 || given.cols < 1 || given.cols % arrays.space != 0)
        fail(Status::shape,
             "positions have {} rows and {} columns: expected a row for each frame and {} columns "
             "for each point",
             given.rows, given.cols, arrays.space);
    const std::int64_t count = given.cols / arrays.space;
    if (!arrays.names.empty() && std::ssize(arrays.names) != count)
        fail(Status::shape, "{} names for {} points", arrays.names.size(), count);
    if (arrays.confidence.rows > 0 &&
        (arrays.confidence.rows != given.rows || arrays.confidence.cols != count))
        fail(Status::shape, "confidence has {} rows and {} columns: expected {} x {}",
             arrays.confidence.rows, arrays.confidence.cols, given.rows, count);
    if (arrays.times.rows > 0 && (arrays.times.rows != given.rows || arrays.times.cols != 1))
        fail(Status::shape, "times have {} rows and {} columns: expected {} x 1", arrays.times.rows,
             arrays.times.cols, given.rows);
}

void check_numbers(const PointArrays& arrays) {
    for (std::int64_t i = 0; i < arrays.positions.rows; ++i)
        for (std::int64_t c = 0; c < arrays.positions.cols; ++c)
            if (std::isinf(arrays.positions(i, c)))
                fail(Status::not_finite,
                     "positions: frame {}, column {} is {}: a missing point is "
                     "NaN",
                     i, c, arrays.positions(i, c));
    for (std::int64_t i = 0; i + 1 < arrays.times.rows; ++i)
        if (!(arrays.times(i + 1, 0) > arrays.times(i, 0)) || !std::isfinite(arrays.times(i, 0)) ||
            !std::isfinite(arrays.times(i + 1, 0)))
            fail(Status::argument, "times do not increase from frame {} ({}) to {} ({})", i,
                 arrays.times(i, 0), i + 1, arrays.times(i + 1, 0));
}

/// A point with one missing coordinate is missing.
void complete_gaps(Matrix& positions, int space) {
    for (std::int64_t i = 0; i < positions.rows(); ++i)
        for (double* point = positions.row(i); point < positions.row(i) + positions.cols();
             point += space)
            if (std::any_of(point, point + space, [](double x) { return std::isnan(x); }))
                std::fill_n(point, space, std::numeric_limits<double>::quiet_NaN());
}

void set_rate(const PointArrays& arrays, Clip& clip) {
    clip.fps = arrays.fps;
    if (arrays.times.rows < 2)
        return;
    std::vector<double> times;
    for (std::int64_t i = 0; i < arrays.times.rows; ++i)
        times.push_back(arrays.times(i, 0));
    EvenRows even =
        even_rows(std::move(clip.values), {times, {}, arrays.fps, arrays.space}, "times");
    if (arrays.fps > 0 && std::abs(even.fps - arrays.fps) > same_rate * arrays.fps)
        fail(Status::argument,
             "fps is {:g}, but the times are {:g} a second: give one of them, or correct the other",
             arrays.fps, even.fps);
    if (even.fps < lowest_fps || even.fps > highest_fps)
        fail(Status::argument, "the times are {:g} frames a second; this must be from {:g} to {:g}",
             even.fps, lowest_fps, highest_fps);
    clip.values = std::move(even.rows);
    clip.fps = even.fps;
    if (!even.note.empty())
        clip.notes.push_back(std::move(even.note));
}

} // namespace

std::int64_t drop_unsure(Matrix& positions, int space, ConstMatrixView confidence,
                         double min_confidence) {
    std::int64_t dropped = 0;
    for (std::int64_t i = 0; i < confidence.rows; ++i)
        for (std::int64_t p = 0; p < confidence.cols; ++p) {
            double* point = positions.row(i) + space * p;
            const double sure = confidence(i, p);
            if (std::isnan(point[0]) || (sure > 0 && sure >= min_confidence))
                continue;
            std::fill_n(point, space, std::numeric_limits<double>::quiet_NaN());
            ++dropped;
        }
    return dropped;
}

std::vector<std::string> coordinate_names(const std::vector<std::string>& points, int space) {
    std::vector<std::string> names;
    for (const std::string& point : points)
        for (int axis = 0; axis < space; ++axis)
            names.push_back(point + '_' + "xyz"[axis]);
    return names;
}

Clip clip_from_points(const PointArrays& arrays) {
    check_shapes(arrays);
    check_numbers(arrays);
    if (!(arrays.fps > 0) && arrays.times.rows < 2)
        fail(Status::argument, "fps is {}, and there are no times: give one of them", arrays.fps);
    Clip clip;
    clip.format = Format::points;
    clip.space = arrays.space;
    clip.values = copied(arrays.positions);
    clip.channel_names = coordinate_names(arrays.names, arrays.space);
    drop_missing_codes(clip.values, clip.channel_names, clip.notes);
    complete_gaps(clip.values, arrays.space);
    const std::int64_t dropped =
        drop_unsure(clip.values, arrays.space, arrays.confidence, arrays.min_confidence);
    if (dropped > 0)
        clip.notes.push_back(format_text(
            "{} of {} positions have a confidence of 0 or below {:g}: taken as missing", dropped,
            arrays.confidence.rows * arrays.confidence.cols, arrays.min_confidence));
    set_rate(arrays, clip);
    return clip;
}

} // namespace stltsa::clip
