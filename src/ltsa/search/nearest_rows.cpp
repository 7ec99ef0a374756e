// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/search/nearest_rows.hpp"

#include <cmath>

#include "linalg/simd.hpp"
#include "ltsa/search/best.hpp"

namespace stltsa::ltsa {

namespace {

std::vector<std::int32_t> beginnings(const std::vector<Segment>& segments) {
    std::vector<std::int32_t> rows;
    rows.reserve(segments.size());
    for (const Segment& segment : segments)
        rows.push_back(segment.row);
    return rows;
}

} // namespace

NearestRows::NearestRows(ConstMatrixView x, const std::vector<Segment>& segments)
    : x_(x), rows_(beginnings(segments)), segments_(segments), reduced_(x, rows_),
      middles_(x, segments_, reduced_.view()), tree_(reduced_.view(), BallTree::Parts::rows),
      segment_tree_(middles_.middles(), BallTree::Parts::rows, middles_.margins()) {}

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

template <class Found, class Bound, class Offer>
std::vector<Found> NearestRows::search(const BallTree& tree, const double* query,
                                       std::int64_t count, const Bound& bound,
                                       const Offer& offer) const {
    if (count < 1 || rows_.empty())
        return {};
    const ReducedRows::Query reduced = reduced_.reduce(query);
    Best<Found> best(std::min(static_cast<std::size_t>(count), rows_.size()));
    tree.search(
        reduced.reduced.data(), reduced.error, -1, [&] { return std::sqrt(best.reach()); },
        [&](std::int32_t leaf) {
            for (const std::int32_t i : tree.rows_of(leaf))
                if (!(bound(reduced, i, best.reach()) > best.reach()))
                    offer(static_cast<std::size_t>(i), best);
        });
    return best.sorted();
}

std::vector<Candidate> NearestRows::nearest_outside(const double* query, std::int64_t count,
                                                    RowRange zone) const {
    return search<Candidate>(
        tree_, query, count,
        [&](const auto& reduced, std::int32_t i, double) { return reduced_.bound(reduced, i); },
        [&](std::size_t i, Best<Candidate>& best) {
            const std::int32_t row = rows_[i];
            if (row < zone.begin || row >= zone.end)
                best.offer({squared_distance(query, x_.row(row), x_.cols), row});
        });
}

std::vector<NearSegment> NearestRows::nearest_segments(const double* query,
                                                       std::int64_t count) const {
    return search<NearSegment>(
        segment_tree_, query, count,
        [&](const auto& reduced, std::int32_t i, double reach) {
            return middles_.bound(reduced, i, reach);
        },
        [&](std::size_t i, Best<NearSegment>& best) {
            best.offer(nearest_point(query, segments_[i]));
        });
}

} // namespace stltsa::ltsa
