// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/search/nearest_rows.hpp"

#include <cmath>

#include "linalg/simd.hpp"
#include "ltsa/search/best.hpp"

namespace stltsa::ltsa {

NearestRows::NearestRows(ConstMatrixView x, const std::vector<Stretch>& stretches)
    : x_(x), stretches_(stretches), tree_(x, stretches) {
    rows_.reserve(stretches.size());
    for (const Stretch& stretch : stretches)
        rows_.push_back(stretch.row);
}

/// The foot of the perpendicular, from the lengths of the three sides, or an end.
NearStretch NearestRows::nearest_point(const double* query, Stretch stretch) const {
    const double* row = x_.row(stretch.row);
    const double* next = x_.row(stretch.next);
    const double to_row = squared_distance(query, row, x_.cols);
    if (stretch.row == stretch.next)
        return {to_row, stretch, 0};
    const double to_next = squared_distance(query, next, x_.cols);
    const double length = squared_distance(row, next, x_.cols);
    const double share = 0.5 + 0.5 * (to_row - to_next) / length;
    if (share >= 1)
        return {to_next, stretch, 1};
    if (!(share > 0)) // nor a number, where squares overflow
        return {to_row, stretch, 0};
    return {std::max(to_row - share * share * length, 0.0), stretch, share};
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

std::vector<NearStretch> NearestRows::nearest_stretches_within(const double* query,
                                                               std::int64_t count,
                                                               RowRange range) const {
    const auto begin = std::lower_bound(rows_.begin(), rows_.end(), range.begin) - rows_.begin();
    const auto end = std::lower_bound(rows_.begin(), rows_.end(), range.end) - rows_.begin();
    Best<NearStretch> best(
        static_cast<std::size_t>(std::clamp<std::int64_t>(end - begin, 0, count)));
    for (auto i = begin; count > 0 && i < end; ++i) {
        const Stretch& stretch = stretches_[static_cast<std::size_t>(i)];
        const bool leaves = stretch.next >= range.end;
        best.offer(nearest_point(query, {stretch.row, leaves ? stretch.row : stretch.next}));
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
        [&](std::int32_t leaf) { offer_leaf(tree_.stretches_of(leaf), best); });
    return best.sorted();
}

std::vector<Candidate> NearestRows::nearest_outside(const double* query, std::int64_t count,
                                                    RowRange zone) const {
    return search<Candidate>(query, count, [&](std::span<const Stretch> leaf, auto& best) {
        for (const Stretch& stretch : leaf)
            if (stretch.row < zone.begin || stretch.row >= zone.end)
                best.offer({squared_distance(query, x_.row(stretch.row), x_.cols), stretch.row});
    });
}

std::vector<NearStretch> NearestRows::nearest_stretches(const double* query,
                                                        std::int64_t count) const {
    return search<NearStretch>(query, count, [&](std::span<const Stretch> leaf, auto& best) {
        for (const Stretch& stretch : leaf)
            best.offer(nearest_point(query, stretch));
    });
}

} // namespace stltsa::ltsa
