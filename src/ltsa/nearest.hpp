// SPDX-License-Identifier: BSD-3-Clause
// The exact nearest rows of a matrix, for one query at a time.
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

/// Some rows of a matrix, in a tree of balls: each half of a ball's rows is a ball again, and most
/// of the tree is passed over for the distance of its centers alone. (Blocks of rows that follow
/// each other in time need more than twice the distances at 30 frames a second, where such a block
/// is a good part of a cycle.) Any number of threads may search at once.
class NearestRows {
  public:
    NearestRows() = default;
    /// `rows` of x, ascending. The entries of x are not copied.
    NearestRows(ConstMatrixView x, std::vector<std::int32_t> rows);

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

  private:
    /// Rows [begin, end) of order_ lie within the radius of the center, which is the row of
    /// centers_ with the node's number.
    struct Node {
        std::int32_t begin, end;
        double radius = 0;
        std::int32_t left = 0, right = 0; ///< nodes; 0: this one is a leaf
    };

    std::span<const std::int32_t> rows_of(const Node& node) const {
        return std::span(order_).subspan(static_cast<std::size_t>(node.begin),
                                         static_cast<std::size_t>(node.end - node.begin));
    }
    std::int32_t add_node(std::int32_t begin, std::int32_t end);
    void split(std::int32_t node);
    /// No row of the node is nearer than the root of this.
    double lower_bound(const double* query, std::int32_t node) const;

    ConstMatrixView x_;
    std::vector<std::int32_t> rows_;
    std::vector<std::int32_t> order_; ///< the same rows, those of a node side by side
    std::vector<Node> nodes_;         ///< the root first
    Matrix centers_;
};

} // namespace stltsa::ltsa
