// SPDX-License-Identifier: BSD-3-Clause
// Consecutive rows have nearly the same neighbors, so the rows of a leaf search the ball tree
// together.
#include "ltsa/search/all_nearest.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "ltsa/search/ball_tree.hpp"
#include "ltsa/search/best.hpp"
#include "ltsa/search/leaf_distances.hpp"

namespace stltsa::ltsa {
namespace {

constexpr std::size_t leaf_rows = BallTree::leaf_size;
static_assert(leaf_rows == lanes);

/// The tree, and its rows leaf by leaf, laid out for LeafDistances.
struct Leaves {
    ConstMatrixView x;
    BallTree tree;
    std::vector<std::int32_t> nodes;  ///< the leaves
    std::vector<std::int32_t> number; ///< of each node among the leaves
    AlignedVector<double> columns;

    explicit Leaves(ConstMatrixView rows);

    std::span<const std::int32_t> rows_of(std::int32_t node) const { return tree.rows_of(node); }
    const double* columns_of(std::int32_t node) const {
        return columns.data() + number[static_cast<std::size_t>(node)] * x.cols * lanes;
    }
};

Leaves::Leaves(ConstMatrixView rows) : x(rows), tree(x, BallTree::Parts::pieces) {
    for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
        number.push_back(static_cast<std::int32_t>(nodes.size()));
        if (tree.nodes()[i].left == 0)
            nodes.push_back(static_cast<std::int32_t>(i));
    }
    columns.resize(checked_size(static_cast<std::int64_t>(nodes.size()) * lanes, x.cols));
    std::array<const double*, leaf_rows> row;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::int64_t count = 0;
        for (const std::int32_t r : rows_of(nodes[i]))
            row[static_cast<std::size_t>(count++)] = x.row(r);
        fill_leaf(row.data(), count, x.cols,
                  columns.data() + static_cast<std::int64_t>(i) * x.cols * lanes);
    }
}

/// A joint search for the neighbors of all rows of a leaf.
class Group {
  public:
    Group(const Leaves& leaves, const NearestOfAll& wanted) : leaves_(leaves), wanted_(wanted) {}

    void search(std::int32_t node) {
        begin(node);
        const auto& own = leaves_.tree.nodes()[static_cast<std::size_t>(node)];
        leaves_.tree.search(
            leaves_.tree.center(node), own.radius, own.begin, [this] { return largest_reach_; },
            [this](std::int32_t leaf) { visit(leaf); });
        for (std::size_t q = 0; q < rows_.size(); ++q)
            wanted_.store(rows_[q], best_[q].sorted());
    }

  private:
    void begin(std::int32_t node) {
        rows_ = leaves_.rows_of(node);
        columns_ = leaves_.columns_of(node);
        best_.clear();
        for (std::size_t q = 0; q < rows_.size(); ++q) {
            best_.emplace_back(static_cast<std::size_t>(std::min(wanted_.count, leaves_.x.rows)));
            zones_[q] = wanted_.zone_of(rows_[q]);
            reach_[q] = best_[q].reach();
        }
        largest_reach_ = best_.front().reach();
    }

    /// Offers the rows of a leaf to those rows of the group that are within reach of its ball.
    void visit(std::int32_t leaf) {
        std::array<double, leaf_rows> to_center;
        const double* center = leaves_.tree.center(leaf);
        measure(columns_, &center, 1, to_center.data());
        const double radius = leaves_.tree.nodes()[static_cast<std::size_t>(leaf)].radius;
        std::array<const double*, leaf_rows> points;
        std::array<std::size_t, leaf_rows> queries;
        std::size_t count = 0;
        for (std::size_t q = 0; q < rows_.size(); ++q)
            if (leaves_.tree.within(to_center[q], reach_[q] + radius)) {
                points[count] = leaves_.x.row(rows_[q]);
                queries[count++] = q;
            }
        std::array<double, leaf_rows * leaf_rows> distances;
        measure(leaves_.columns_of(leaf), points.data(), count, distances.data());
        for (std::size_t i = 0; i < count; ++i)
            offer(queries[i], leaves_.rows_of(leaf), distances.data() + i * leaf_rows);
        largest_reach_ = *std::max_element(reach_.begin(), reach_.begin() + rows_.size());
    }

    void measure(const double* columns, const double* const* points, std::size_t count,
                 double* out) const {
        run_simd(wanted_.simd, LeafDistances{columns, points, static_cast<std::int64_t>(count),
                                             leaves_.x.cols, out});
    }

    void offer(std::size_t query, std::span<const std::int32_t> rows, const double* distances) {
        const RowRange zone = zones_[query];
        Best<Candidate>& best = best_[query];
        double limit = best.reach();
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (distances[i] <= limit && (rows[i] < zone.begin || rows[i] >= zone.end)) {
                best.offer({distances[i], rows[i]});
                limit = best.reach();
            }
        reach_[query] = std::sqrt(limit);
    }

    const Leaves& leaves_;
    const NearestOfAll& wanted_;
    std::span<const std::int32_t> rows_;
    const double* columns_ = nullptr;
    std::vector<Best<Candidate>> best_;
    std::array<RowRange, leaf_rows> zones_;
    std::array<double, leaf_rows> reach_; ///< rows farther away are not among the nearest
    double largest_reach_ = 0;
};

} // namespace

void find_nearest_of_all(ConstMatrixView x, const NearestOfAll& wanted) {
    constexpr std::int64_t leaves_per_block = 8; // of a block of the parallel loop
    const Leaves leaves(x);
    const auto count = static_cast<std::int64_t>(leaves.nodes.size());
    const std::int64_t blocks = (count + leaves_per_block - 1) / leaves_per_block;
    parallel_blocks(
        blocks, wanted.threads,
        [&](std::int64_t block) {
            Group group(leaves, wanted);
            for (std::int64_t i = block * leaves_per_block;
                 i < std::min((block + 1) * leaves_per_block, count); ++i)
                group.search(leaves.nodes[static_cast<std::size_t>(i)]);
        },
        Stage::neighbors);
}

} // namespace stltsa::ltsa
