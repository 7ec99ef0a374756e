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
#include "ltsa/neighbors.hpp"

namespace stltsa::ltsa {

/// Rows [begin, end).
struct RowRange {
    std::int64_t begin = 0;
    std::int64_t end = std::numeric_limits<std::int64_t>::max();
};

/// The straight way from a row to the one that follows it, or a row alone, which follows itself.
struct Stretch {
    std::int32_t row, next;
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

/// Some rows of a matrix, in a tree of balls: each half of a ball's rows is a ball again, and most
/// of the tree is passed over for the distance of its centers alone. (Blocks of rows that follow
/// each other in time need more than twice the distances at 30 frames a second, where such a block
/// is a good part of a cycle.) A ball holds the stretches that begin at its rows. Any number of
/// threads may search at once.
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
    /// Stretches [begin, end) of order_ lie within the radius of the center, which is the row of
    /// centers_ with the node's number.
    struct Node {
        std::int32_t begin, end;
        double radius = 0;
        std::int32_t left = 0, right = 0; ///< nodes; 0: this one is a leaf
    };

    std::span<const Stretch> stretches_of(const Node& node) const {
        return std::span(order_).subspan(static_cast<std::size_t>(node.begin),
                                         static_cast<std::size_t>(node.end - node.begin));
    }
    std::int32_t add_node(std::int32_t begin, std::int32_t end);
    void split(std::int32_t node);
    /// Nothing of the node is nearer than the root of this.
    double lower_bound(const double* query, std::int32_t node) const;
    NearStretch nearest_point(const double* query, Stretch stretch) const;
    /// The `count` nearest of what `offer_leaf` offers from the leaves.
    template <class Found, class OfferLeaf>
    std::vector<Found> search(const double* query, std::int64_t count,
                              const OfferLeaf& offer_leaf) const;

    ConstMatrixView x_;
    std::vector<std::int32_t> rows_;
    std::vector<Stretch> stretches_; ///< of the rows, in the same order
    std::vector<Stretch> order_;     ///< the same, those of a node side by side
    std::vector<Node> nodes_;        ///< the root first
    Matrix centers_;
};

} // namespace stltsa::ltsa
