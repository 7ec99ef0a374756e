// SPDX-License-Identifier: BSD-3-Clause
// The exact nearest rows of a matrix, and the nearest stretches between them, for one query at a
// time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/search/ball_tree.hpp"
#include "ltsa/search/best.hpp"

namespace stltsa::ltsa {

/// Rows [begin, end).
struct RowRange {
    std::int64_t begin = 0;
    std::int64_t end = std::numeric_limits<std::int64_t>::max();
};

/// A stretch, and the point of it that is nearest to a query.
struct NearStretch {
    double distance; ///< squared, of that point
    Stretch stretch;
    double share; ///< of the way from the row to the next, at that point

    std::int32_t nearer_end() const { return share <= 0.5 ? stretch.row : stretch.next; }
    /// Nearer first, ties by row.
    bool operator<(const NearStretch& other) const {
        return distance < other.distance ||
               (distance == other.distance && stretch.row < other.stretch.row);
    }
};

/// Some rows of a matrix, in a tree of balls, which hold the stretches that begin at their rows.
/// Any number of threads may search at once.
class NearestRows {
  public:
    NearestRows() = default;
    /// Stretches between rows of x, ascending, one from each row that is to be found. The entries
    /// of x are not copied.
    NearestRows(ConstMatrixView x, const std::vector<Stretch>& stretches);

    const std::vector<std::int32_t>& rows() const { return rows_; }
    bool holds(std::int64_t row) const {
        return std::binary_search(rows_.begin(), rows_.end(), row);
    }

    // Squared distances to the `count` nearest rows, or to as many as there are: nearest first,
    // ties by row.
    std::vector<Candidate> nearest(const double* query, std::int64_t count) const {
        return nearest_outside(query, count, {0, 0});
    }
    std::vector<Candidate> nearest_within(const double* query, std::int64_t count,
                                          RowRange range) const;
    std::vector<Candidate> nearest_outside(const double* query, std::int64_t count,
                                           RowRange zone) const;
    // The same for stretches. Within a range they end at its last row.
    std::vector<NearStretch> nearest_stretches(const double* query, std::int64_t count) const;
    std::vector<NearStretch> nearest_stretches_within(const double* query, std::int64_t count,
                                                      RowRange range) const;

  private:
    NearStretch nearest_point(const double* query, Stretch stretch) const;
    /// The `count` nearest of what `offer_leaf` offers from the leaves.
    template <class Found, class OfferLeaf>
    std::vector<Found> search(const double* query, std::int64_t count,
                              const OfferLeaf& offer_leaf) const;

    ConstMatrixView x_;
    std::vector<std::int32_t> rows_;
    std::vector<Stretch> stretches_; ///< of the rows, in the same order
    BallTree tree_;
};

} // namespace stltsa::ltsa
