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

/// The segment from a row to the next, or a single row, which is its own next.
struct Stretch {
    std::int32_t row, next;
};

/// Each half of a ball's rows is a ball again. A leaf of rows in order of time is a short piece of
/// motion, which is smaller than what cuts across the features leave side by side. What is larger
/// is halved in time or along the column in which the pieces differ most, whichever keeps them
/// nearer together.
class BallTree {
  public:
    /// Most rows of a leaf; all but the last one have as many.
    static constexpr std::int32_t leaf_size = 8;

    /// Stretches [begin, end) of the order lie within the radius of the center.
    struct Node {
        std::int32_t begin, end;
        double radius = 0;
        std::int32_t left = 0; ///< the right one follows; 0: this one is a leaf
    };

    BallTree() = default;
    /// Stretches between rows of x, ascending, one from each row that is to be found. The entries
    /// of x are not copied.
    BallTree(ConstMatrixView x, const std::vector<Stretch>& stretches);

    const std::vector<Node>& nodes() const { return nodes_; }
    const double* center(std::int32_t node) const { return centers_.row(node); }
    std::span<const Stretch> stretches_of(std::int32_t index) const {
        const Node& node = nodes_[static_cast<std::size_t>(index)];
        return std::span(order_).subspan(static_cast<std::size_t>(node.begin),
                                         static_cast<std::size_t>(node.end - node.begin));
    }

    /// Whether points may be within `reach` of each other in spite of the squared distance of the
    /// centers of their balls: the triangle inequality, where `reach` has the radii in it, with
    /// room for what rounding and squares that underflow take from either side.
    bool within(double squared, double reach) const {
        const double bound = reach + 1e-150;
        return !(squared > bound * bound * (1 + rounding_));
    }

    /// Calls visit(leaf) for each leaf that may hold a point within reach() of one in a ball, from
    /// that which holds the stretch at `start` of the order outwards, or the nearest first without
    /// one (-1).
    template <class Reach, class Visit>
    void search(const double* center, double radius, std::int32_t start, const Reach& reach,
                const Visit& visit) const {
        if (nodes_.empty())
            return;
        std::vector<Open> open{opened(center, 0)};
        while (!open.empty()) {
            const Open next = open.back();
            open.pop_back();
            const Node& node = nodes_[static_cast<std::size_t>(next.node)];
            if (!within(next.distance, reach() + radius + node.radius))
                continue;
            if (node.left == 0) {
                visit(next.node);
                continue;
            }
            const Open left = opened(center, node.left);
            const Open right = opened(center, node.left + 1);
            const std::int32_t middle = nodes_[static_cast<std::size_t>(right.node)].begin;
            const bool holds_start = start >= node.begin && start < node.end;
            const bool left_first = holds_start ? start < middle : left.distance <= right.distance;
            open.push_back(left_first ? right : left);
            open.push_back(left_first ? left : right);
        }
    }

  private:
    /// A node that a search has not visited yet.
    struct Open {
        double distance; ///< squared, of its center
        std::int32_t node;
    };

    Open opened(const double* from, std::int32_t node) const {
        return {squared_distance(from, center(node), x_.cols), node};
    }
    void enclose_rows(std::int32_t index);
    void enclose_leaves(std::int32_t index, std::span<const std::int32_t> leaves);

    ConstMatrixView x_;
    double rounding_ = 0;
    std::vector<Stretch> order_; ///< those of a node side by side
    std::vector<Node> nodes_;    ///< the root first
    Matrix centers_;
};

} // namespace stltsa::ltsa
