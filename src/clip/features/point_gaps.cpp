// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/point_gaps.hpp"

#include <algorithm>
#include <cmath>

namespace stltsa::clip {
namespace {

bool is_missing(const double* point) {
    return (point[0] == 0 && point[1] == 0 && point[2] == 0) || std::isnan(point[0]) ||
           std::isnan(point[1]) || std::isnan(point[2]);
}

/// Fills the rows between `before` and `after`, of which one may lie beyond its end.
void fill_between(Matrix& points, std::int64_t column, std::int64_t before, std::int64_t after) {
    const std::int64_t from = before < 0 ? after : before;
    const std::int64_t to = after < points.rows() ? after : from;
    for (std::int64_t i = before + 1; i < after; ++i) {
        const double share =
            from == to ? 0 : static_cast<double>(i - from) / static_cast<double>(to - from);
        for (std::int64_t c = column; c < column + 3; ++c)
            points(i, c) = (1 - share) * points(from, c) + share * points(to, c);
    }
}

/// Frames in which each point is missing.
std::vector<std::int64_t> count_missing(const Matrix& points) {
    std::vector<std::int64_t> count(static_cast<std::size_t>(points.cols() / 3));
    for (std::int64_t i = 0; i < points.rows(); ++i)
        for (std::size_t p = 0; p < count.size(); ++p)
            count[p] += is_missing(points.row(i) + 3 * p) ? 1 : 0;
    return count;
}

void fill_point(Matrix& points, std::int64_t column) {
    std::int64_t before = -1;
    for (std::int64_t i = 0; i < points.rows(); ++i)
        if (!is_missing(points.row(i) + column)) {
            fill_between(points, column, before, i);
            before = i;
        }
    fill_between(points, column, before, points.rows());
}

} // namespace

Gaps fill_gaps(Matrix& points) {
    Gaps gaps;
    const std::vector<std::int64_t> missing = count_missing(points);
    for (std::int64_t p = 0; p < std::ssize(missing); ++p) {
        const std::int64_t count = missing[static_cast<std::size_t>(p)];
        if (2 * count > points.rows()) {
            gaps.dropped.push_back(p);
            for (std::int64_t i = 0; i < points.rows(); ++i)
                std::fill_n(points.row(i) + 3 * p, 3, 0.0);
            continue;
        }
        gaps.seen.push_back(p);
        if (count > 0) {
            gaps.filled.push_back(p);
            gaps.frames += count;
            fill_point(points, 3 * p);
        }
    }
    return gaps;
}

} // namespace stltsa::clip
