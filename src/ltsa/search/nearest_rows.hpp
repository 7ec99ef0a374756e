// SPDX-License-Identifier: BSD-3-Clause
// The exact nearest rows of a matrix, and the nearest segments between rows, for one query.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/search/ball_tree.hpp"
#include "ltsa/search/best.hpp"
#include "ltsa/search/reduced_rows.hpp"

namespace stltsa::ltsa {

/// Rows [begin, end).
struct RowRange {
    std::int64_t begin = 0;
    std::int64_t end = std::numeric_limits<std::int64_t>::max();
};

/// A segment and its point nearest to a query.
struct NearSegment {
    double distance; ///< squared, of that point
    Segment segment;
    double share; ///< position of that point: 0 at the row, 1 at the next

    std::int32_t nearer_end() const { return share <= 0.5 ? segment.row : segment.next; }
    /// Nearer first, ties by row.
    bool operator<(const NearSegment& other) const {
        return distance < other.distance ||
               (distance == other.distance && segment.row < other.segment.row);
    }
};

/// Rows of a matrix in ball trees, with the segments that begin there. Any number of threads may
/// search at once.
class NearestRows {
  public:
    NearestRows() = default;
    /// `segments`: one from each row to index, ascending. The entries of x are not copied.
    NearestRows(ConstMatrixView x, const std::vector<Segment>& segments);
    // The trees refer to matrices of this object, which a move keeps in place.
    NearestRows(NearestRows&&) = default;
    NearestRows& operator=(NearestRows&&) = default;

    const std::vector<std::int32_t>& rows() const { return rows_; }
    bool contains(std::int64_t row) const {
        return std::binary_search(rows_.begin(), rows_.end(), row);
    }

    // The `count` nearest rows, or fewer if there are not enough, with squared distances: nearest
    // first, ties by row.
    std::vector<Candidate> nearest(const double* query, std::int64_t count) const {
        return nearest_outside(query, count, {0, 0});
    }
    std::vector<Candidate> nearest_within(const double* query, std::int64_t count,
                                          RowRange range) const;
    std::vector<Candidate> nearest_outside(const double* query, std::int64_t count,
                                           RowRange zone) const;
    // The same for segments. Within a range, segments end at its last row.
    std::vector<NearSegment> nearest_segments(const double* query, std::int64_t count) const;
    std::vector<NearSegment> nearest_segments_within(const double* query, std::int64_t count,
                                                     RowRange range) const;

  private:
    NearSegment nearest_point(const double* query, Segment segment) const;
    /// The `count` nearest of the elements that offer(i) offers. `bound`: at most the squared
    /// distance of element i; those beyond reach are skipped.
    template <class Found, class Bound, class Offer>
    std::vector<Found> search(const BallTree& tree, const double* query, std::int64_t count,
                              const Bound& bound, const Offer& offer) const;

    ConstMatrixView x_;
    std::vector<std::int32_t> rows_;
    std::vector<Segment> segments_; ///< of the rows, in the same order
    ReducedRows reduced_;           ///< the same
    ReducedSegments middles_;       ///< the same
    BallTree tree_;                 ///< of the reduced rows
    BallTree segment_tree_;         ///< of the middles
};

} // namespace stltsa::ltsa
