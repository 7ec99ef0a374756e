// SPDX-License-Identifier: BSD-3-Clause
// A ball tree over the rows of a matrix: an exact search skips most rows by the distance to the
// centers of their balls.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "linalg/simd.hpp"

namespace stltsa::ltsa {

/// Each half of a ball's rows is a ball again. Nodes are split in time or along the column in which
/// their parts differ most, whichever gives smaller halves.
class BallTree {
  public:
    /// What is never split: rows, or, if the rows are in order of time, pieces of motion as long as
    /// a leaf. The rows of a piece have much the same neighbors, so a search for all rows at once
    /// uses pieces; a search for one row takes a fifth of the time in a tree of rows.
    enum class Parts { rows, pieces };

    /// Rows of a leaf; the last one may have fewer.
    static constexpr std::int32_t leaf_size = 8;

    /// Rows [begin, end) of the order, with what extends from them, lie within the radius.
    struct Node {
        std::int32_t begin, end;
        double radius = 0;
        std::int32_t left = 0; ///< the right child is next; 0: this node is a leaf
    };

    BallTree() = default;
    /// Of all rows of x, whose entries are not copied. `margins`: how far something extends from
    /// each row; none: nothing does.
    BallTree(ConstMatrixView x, Parts parts, std::span<const double> margins = {});

    const std::vector<Node>& nodes() const { return nodes_; }
    const double* center(std::int32_t node) const { return centers_.row(node); }
    std::span<const std::int32_t> rows_of(std::int32_t index) const {
        const Node& node = nodes_[static_cast<std::size_t>(index)];
        return std::span(order_).subspan(static_cast<std::size_t>(node.begin),
                                         static_cast<std::size_t>(node.end - node.begin));
    }

    /// Whether points of two balls can be close enough, by the triangle inequality: `squared` is
    /// the squared distance of the centers, and `reach` includes the radii. Allows for rounding and
    /// for squares that underflow.
    bool within(double squared, double reach) const {
        const double bound = reach + 1e-150;
        return !(squared > bound * bound * (1 + rounding_));
    }

    /// Calls visit(leaf) for each leaf that may contain a point within reach() of the ball with
    /// this center and radius: beginning with the leaf of row `start` of the order, or, if that is
    /// -1, with the nearest.
    template <class Reach, class Visit>
    void search(const double* center, double radius, std::int32_t start, const Reach& reach,
                const Visit& visit) const {
        if (nodes_.empty())
            return;
        std::vector<Unvisited> stack{unvisited(center, 0)};
        while (!stack.empty()) {
            const Unvisited next = stack.back();
            stack.pop_back();
            const Node& node = nodes_[static_cast<std::size_t>(next.node)];
            if (!within(next.distance, reach() + radius + node.radius))
                continue;
            if (node.left == 0) {
                visit(next.node);
                continue;
            }
            const Unvisited left = unvisited(center, node.left);
            const Unvisited right = unvisited(center, node.left + 1);
            const std::int32_t middle = nodes_[static_cast<std::size_t>(right.node)].begin;
            const bool holds_start = start >= node.begin && start < node.end;
            const bool left_first = holds_start ? start < middle : left.distance <= right.distance;
            stack.push_back(left_first ? right : left);
            stack.push_back(left_first ? left : right);
        }
    }

  private:
    /// A node that a search has not visited yet.
    struct Unvisited {
        double distance; ///< squared, of its center
        std::int32_t node;
    };

    Unvisited unvisited(const double* from, std::int32_t node) const {
        const double* to = center(node);
        return {x_.cols == lanes ? squared_distance_of_lanes(from, to)
                                 : squared_distance(from, to, x_.cols),
                node};
    }
    void enclose_rows(std::int32_t index, std::span<const double> margins);
    void enclose_leaves(std::int32_t index, std::span<const std::int32_t> leaves);

    ConstMatrixView x_;
    double rounding_ = 0;
    std::vector<std::int32_t> order_; ///< the rows of a node are adjacent
    std::vector<Node> nodes_;         ///< the root first
    Matrix centers_;
};

} // namespace stltsa::ltsa
