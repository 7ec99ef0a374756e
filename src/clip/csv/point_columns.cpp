// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/point_columns.hpp"

#include <algorithm>
#include <iterator>

#include "clip/arrays/arrays.hpp"
#include "clip/features/point_names.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Points that are columns of a clip.
struct Columns {
    std::vector<std::int64_t> coordinates;
    std::vector<std::int64_t> confidence; ///< one per point, or none
    std::vector<std::string> quantities;  ///< names of triples of other quantities
    std::vector<std::string> others;      ///< names of columns that belong to no point
    std::int64_t points = 0;
    int space = 0;
    bool same_space = true;
    bool are_set_apart = true; ///< the axes in all names
};

Columns find_points(const std::vector<std::string>& names) {
    Columns found;
    for (std::size_t c = 0; c < names.size();) {
        const PointColumns next = point_at(names, c);
        if (next.space == 0) {
            found.others.push_back(names[c++]);
            continue;
        }
        const auto column = static_cast<std::int64_t>(c);
        c += static_cast<std::size_t>(next.space) + (next.has_confidence ? 1 : 0);
        if (next.other_quantity) {
            found.quantities.push_back(next.stem);
            continue;
        }
        found.same_space = found.same_space && (found.points == 0 || found.space == next.space);
        found.are_set_apart = found.are_set_apart && next.is_set_apart;
        found.space = next.space;
        for (int axis = 0; axis < next.space; ++axis)
            found.coordinates.push_back(column + axis);
        if (next.has_confidence)
            found.confidence.push_back(column + next.space);
        ++found.points;
    }
    return found;
}

std::vector<std::string> renamed(const std::vector<std::string>& names,
                                 std::string (*rename)(std::string_view)) {
    std::vector<std::string> result;
    std::ranges::transform(names, std::back_inserter(result), rename);
    return result;
}

/// Why columns that are named as points may be something else; empty: they are points. Fewer than
/// three points must have all columns, three or more must have most of the columns.
std::string doubt(const Columns& found) {
    const auto others = std::ssize(found.others);
    if (!found.same_space)
        return "some have 2 coordinates, and some 3";
    if (!found.confidence.empty() && std::ssize(found.confidence) != found.points)
        return "only some have a confidence";
    if (others > 0 && (found.points < least_points || others >= std::ssize(found.coordinates)))
        return "there are as many other columns, or fewer than 3 points: " +
               in_quotes(found.others[0]);
    if (!found.quantities.empty() && found.points < least_points)
        return "there are other quantities, and fewer than 3 points: " +
               in_quotes(found.quantities[0]);
    if (!found.are_set_apart && found.points < least_points)
        return "fewer than 3 points need names such as 'heel_x'";
    return {};
}

void note_left_out(const Columns& found, Clip& clip) {
    if (!found.quantities.empty())
        clip.notes.push_back(format_text("{} columns of other quantities than positions are left "
                                         "out, the first are those of {}",
                                         3 * found.quantities.size(), found.quantities.front()));
    const std::size_t count = found.others.size();
    if (count > 0)
        clip.notes.push_back(
            format_text("no coordinates of points, so left out: {} {}",
                        count == 1 ? "column" : format_text("{} columns, the first is", count),
                        in_quotes(found.others.front())));
}

Matrix columns_of(const Matrix& values, const std::vector<std::int64_t>& columns,
                  const Progress& progress) {
    Matrix result = Matrix::unset(values.rows(), std::ssize(columns));
    PacedPoll polls(progress, Stage::read, 1);
    for (std::int64_t i = 0; i < values.rows(); ++i) {
        std::transform(columns.begin(), columns.end(), result.row(i),
                       [row = values.row(i)](std::int64_t column) { return row[column]; });
        polls.did(result.cols());
    }
    return result;
}

} // namespace

void keep_columns(Clip& clip, const std::vector<std::int64_t>& columns, const Progress& progress) {
    clip.values = columns_of(clip.values, columns, progress);
    std::vector<std::string> names;
    for (const std::int64_t column : columns)
        names.push_back(clip.channel_names[static_cast<std::size_t>(column)]);
    clip.channel_names = std::move(names);
}

void take_points(Clip& clip, const ReadOptions& options) {
    std::vector<std::string> names = renamed(clip.channel_names, without_unit);
    Columns found = find_points(names);
    if (found.points == 0) {
        names = renamed(names, axis_last);
        found = find_points(names);
    }
    if (found.points == 0)
        return;
    if (const std::string why = doubt(found); !why.empty()) {
        clip.notes.push_back(format_text("{} columns are named as coordinates, but not taken as "
                                         "those of points: {}",
                                         found.coordinates.size(), why));
        return;
    }
    clip.channel_names = std::move(names);
    const Matrix confidence = columns_of(clip.values, found.confidence, options.progress);
    if (std::ssize(found.coordinates) < clip.values.cols())
        keep_columns(clip, found.coordinates, options.progress);
    clip.space = found.space;
    note_left_out(found, clip);
    if (found.confidence.empty())
        return;
    const std::int64_t dropped =
        drop_unsure(clip.values, clip.space, confidence.view(), options.least_confidence);
    clip.notes.push_back(format_text("columns of confidence: {} of {} positions are below {:g} and "
                                     "taken as missing",
                                     dropped, confidence.rows() * confidence.cols(),
                                     options.least_confidence));
}

} // namespace stltsa::clip
