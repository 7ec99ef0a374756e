// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/point_columns.hpp"

#include <algorithm>

#include "clip/arrays/arrays.hpp"
#include "clip/features/point_names.hpp"

namespace stltsa::clip {
namespace {

/// Points that are columns of a clip.
struct Columns {
    std::vector<std::int64_t> coordinates;
    std::vector<std::int64_t> confidence; ///< one per point, or none
    std::vector<std::string> left_out;    ///< names of other quantities
    int space = 0;                        ///< 0: the columns are no points
};

Columns find_points(const std::vector<std::string>& names) {
    Columns found;
    std::int64_t points = 0;
    for (std::size_t c = 0; c < names.size();) {
        const PointColumns next = point_at(names, c);
        if (next.space == 0)
            return {}; // some other column: nothing is taken for granted
        const auto column = static_cast<std::int64_t>(c);
        c += static_cast<std::size_t>(next.space) + (next.has_confidence ? 1 : 0);
        if (next.other_quantity) {
            found.left_out.push_back(next.stem);
            continue;
        }
        if (found.space != 0 && found.space != next.space)
            return {};
        found.space = next.space;
        for (int axis = 0; axis < next.space; ++axis)
            found.coordinates.push_back(column + axis);
        if (next.has_confidence)
            found.confidence.push_back(column + next.space);
        ++points;
    }
    const bool all_or_none = found.confidence.empty() || std::ssize(found.confidence) == points;
    return points >= least_points && all_or_none ? found : Columns();
}

Matrix columns_of(const Matrix& values, const std::vector<std::int64_t>& columns) {
    Matrix result = Matrix::unset(values.rows(), std::ssize(columns));
    for (std::int64_t i = 0; i < values.rows(); ++i)
        std::transform(columns.begin(), columns.end(), result.row(i),
                       [row = values.row(i)](std::int64_t column) { return row[column]; });
    return result;
}

} // namespace

void keep_columns(Clip& clip, const std::vector<std::int64_t>& columns) {
    clip.values = columns_of(clip.values, columns);
    std::vector<std::string> names;
    for (const std::int64_t column : columns)
        names.push_back(clip.channel_names[static_cast<std::size_t>(column)]);
    clip.channel_names = std::move(names);
}

void take_points(Clip& clip, const ReadOptions& options) {
    const Columns found = find_points(clip.channel_names);
    if (found.space == 0)
        return;
    const Matrix confidence = columns_of(clip.values, found.confidence);
    if (std::ssize(found.coordinates) < clip.values.cols())
        keep_columns(clip, found.coordinates);
    clip.space = found.space;
    if (!found.left_out.empty())
        clip.notes.push_back(format_text("{} columns of other quantities than positions are left "
                                         "out, the first are those of {}",
                                         3 * found.left_out.size(), found.left_out.front()));
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
