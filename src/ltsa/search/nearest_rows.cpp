// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/search/nearest_rows.hpp"

#include <cmath>

#include "linalg/simd.hpp"
#include "ltsa/search/best.hpp"

namespace stltsa::ltsa {

NearestRows::NearestRows(ConstMatrixView x, const std::vector<Segment>& segments)
    : x_(x), segments_(segments), tree_(x, segments) {
    rows_.reserve(segments.size());
    for (const Segment& segment : segments)
        rows_.push_back(segment.row);
}

/// The foot of the perpendicular, computed from the lengths of the three sides, or an end.
NearSegment NearestRows::nearest_point(const double* query, Segment segment) const {
    const double* row = x_.row(segment.row);
    const double* next = x_.row(segment.next);
    const double to_row = squared_distance(query, row, x_.cols);
    if (segment.row == segment.next)
        return {to_row, segment, 0};
    const double to_next = squared_distance(query, next, x_.cols);
    const double length = squared_distance(row, next, x_.cols);
    const double share = 0.5 + 0.5 * (to_row - to_next) / length;
    if (share >= 1)
        return {to_next, segment, 1};
    if (!(share > 0)) // includes NaN, if squares overflow
        return {to_row, segment, 0};
    return {std::max(to_row - share * share * length, 0.0), segment, share};
}

std::vector<Candidate> NearestRows::nearest_within(const double* query, std::int64_t count,
                                                   RowRange range) const {
    const auto begin = std::lower_bound(rows_.begin(), rows_.end(), range.begin);
    const auto end = std::lower_bound(begin, rows_.end(), range.end);
    Best<Candidate> best(static_cast<std::size_t>(std::min<std::int64_t>(count, end - begin)));
    if (count > 0)
        for (auto row = begin; row < end; ++row)
            best.offer({squared_distance(query, x_.row(*row), x_.cols), *row});
    return best.sorted();
}

std::vector<NearSegment> NearestRows::nearest_segments_within(const double* query,
                                                              std::int64_t count,
                                                              RowRange range) const {
    const auto begin = std::lower_bound(rows_.begin(), rows_.end(), range.begin) - rows_.begin();
    const auto end = std::lower_bound(rows_.begin(), rows_.end(), range.end) - rows_.begin();
    Best<NearSegment> best(
        static_cast<std::size_t>(std::clamp<std::int64_t>(end - begin, 0, count)));
    for (auto i = begin; count > 0 && i < end; ++i) {
        const Segment& segment = segments_[static_cast<std::size_t>(i)];
        const bool leaves = segment.next >= range.end;
        best.offer(nearest_point(query, {segment.row, leaves ? segment.row : segment.next}));
    }
    return best.sorted();
}

template <class Found, class OfferLeaf>
std::vector<Found> NearestRows::search(const double* query, std::int64_t count,
                                       const OfferLeaf& offer_leaf) const {
    if (count < 1 || rows_.empty())
        return {};
    Best<Found> best(std::min(static_cast<std::size_t>(count), rows_.size()));
    tree_.search(
        query, 0, -1, [&] { return std::sqrt(best.reach()); },
        [&](std::int32_t leaf) { offer_leaf(tree_.segments_of(leaf), best); });
    return best.sorted();
}

std::vector<Candidate> NearestRows::nearest_outside(const double* query, std::int64_t count,
                                                    RowRange zone) const {
    return search<Candidate>(query, count, [&](std::span<const Segment> leaf, auto& best) {
        for (const Segment& segment : leaf)
            if (segment.row < zone.begin || segment.row >= zone.end)
                best.offer({squared_distance(query, x_.row(segment.row), x_.cols), segment.row});
    });
}

std::vector<NearSegment> NearestRows::nearest_segments(const double* query,
                                                       std::int64_t count) const {
    return search<NearSegment>(query, count, [&](std::span<const Segment> leaf, auto& best) {
        for (const Segment& segment : leaf)
            best.offer(nearest_point(query, segment));
    });
}

} // namespace stltsa::ltsa
