// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/search/ball_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "ltsa/frames.hpp"

namespace stltsa::ltsa {
namespace {

/// Whether consecutive rows are much nearer to each other than other pairs of rows.
bool in_order(ConstMatrixView x) {
    double steps = 0, jumps = 0;
    for (std::int64_t i = 0; i + 1 < x.rows; ++i) {
        steps += squared_distance(x.row(i), x.row(i + 1), x.cols);
        jumps += squared_distance(x.row(i), x.row((i + x.rows / 2) % x.rows), x.cols);
    }
    return steps <= jumps / 4;
}

/// Rows of the first child of a node: a multiple of the leaf size.
std::int32_t first_half(std::int32_t rows) {
    constexpr std::int32_t size = BallTree::leaf_size;
    return (rows / 2 + size - 1) / size * size;
}

/// Nodes of a tree of this many rows.
std::int64_t node_count(std::int32_t rows) {
    return 2 * ((static_cast<std::int64_t>(rows) + BallTree::leaf_size - 1) / BallTree::leaf_size) -
           1;
}

/// A node is split in time order unless its halves would vary by this factor more, because a search
/// begins with nearby times. The fastest of 1 to 2 for 9000 recorded frames and for 30 000
/// synthetic frames with many repetitions.
constexpr double time_order_bonus = 1.1;

/// Arranges rows in the order of the tree. Its units are pieces of motion as long as a leaf, each
/// represented by its middle row, or single rows.
class Arrangement {
  public:
    Arrangement(ConstMatrixView x, BallTree::Parts parts)
        : x_(x), rows_(static_cast<std::size_t>(x.rows)),
          length_(parts == BallTree::Parts::pieces && in_order(x) ? BallTree::leaf_size : 1),
          pieces_((rows_ + length_ - 1) / length_) {
        std::iota(pieces_.begin(), pieces_.end(), std::size_t{0});
    }

    /// Partitions the pieces of a node at `middle`: by time, or by the column in which they differ
    /// most if that makes the halves vary less.
    void halve(std::int32_t begin, std::int32_t middle, std::int32_t end) {
        const auto first = piece_at(begin);
        const auto half = piece_at(middle);
        const auto last = piece_at(end + static_cast<std::int32_t>(length_) - 1);
        const auto variation = [&] {
            return variation_of(std::span(first, half)) + variation_of(std::span(half, last));
        };
        const auto in_time = [&] { std::nth_element(first, half, last); };
        in_time();
        const double of_time = variation();
        order_by_column(first, half, last);
        if (of_time < time_order_bonus * variation())
            in_time();
    }

    std::vector<std::int32_t> arranged() const {
        std::vector<std::int32_t> order;
        order.reserve(rows_);
        for (const std::size_t piece : pieces_)
            for (std::size_t i = piece * length_; i < std::min((piece + 1) * length_, rows_); ++i)
                order.push_back(static_cast<std::int32_t>(i));
        return order;
    }

  private:
    using Piece = std::vector<std::size_t>::iterator;
    struct Key {
        bool is_short;
        double value;
        std::size_t piece;
        bool operator<(const Key& other) const {
            return std::tie(is_short, value, piece) <
                   std::tie(other.is_short, other.value, other.piece);
        }
    };

    Piece piece_at(std::int32_t place) {
        return pieces_.begin() + place / static_cast<std::int32_t>(length_);
    }
    bool is_short(std::size_t piece) const { return (piece + 1) * length_ > rows_; }
    const double* row_of(std::size_t piece) const {
        return x_.row(
            static_cast<std::int64_t>(std::min(piece * length_ + length_ / 2, rows_ - 1)));
    }

    /// By the column in which they differ most; the incomplete piece stays at the end, because the
    /// others are whole leaves.
    void order_by_column(Piece first, Piece half, Piece last) {
        const std::int64_t column = widest_column(std::span(first, last));
        // Reads values once: if another thread changes x, the order must stay consistent.
        std::vector<Key> keys;
        for (auto piece = first; piece < last; ++piece) {
            const double value = row_of(*piece)[column];
            if (std::isnan(value))
                fail_changed(static_cast<std::int64_t>(*piece * length_));
            keys.push_back({is_short(*piece), value, *piece});
        }
        std::nth_element(keys.begin(), keys.begin() + (half - first), keys.end());
        std::ranges::transform(keys, first, [](const Key& key) { return key.piece; });
    }

    /// The column in which these pieces differ most.
    std::int64_t widest_column(std::span<const std::size_t> pieces) const {
        const double* first = row_of(pieces.front());
        std::vector<double> least(first, first + x_.cols);
        std::vector<double> most = least;
        for (const std::size_t piece : pieces)
            for (std::size_t c = 0; c < least.size(); ++c) {
                const double value = row_of(piece)[c];
                least[c] = std::min(least[c], value);
                most[c] = std::max(most[c], value);
            }
        std::size_t widest = 0;
        for (std::size_t c = 0; c < least.size(); ++c)
            if (most[c] - least[c] > most[widest] - least[widest])
                widest = c;
        return static_cast<std::int64_t>(widest);
    }

    /// The sum of squared distances of these pieces from their mean.
    double variation_of(std::span<const std::size_t> pieces) const {
        AlignedVector<double> mean(static_cast<std::size_t>(x_.cols));
        for (const std::size_t piece : pieces)
            axpy(1 / static_cast<double>(pieces.size()), row_of(piece), mean.data(), x_.cols);
        double sum = 0;
        for (const std::size_t piece : pieces)
            sum += squared_distance(row_of(piece), mean.data(), x_.cols);
        return sum;
    }

    ConstMatrixView x_;
    std::size_t rows_;
    std::size_t length_; ///< of a piece
    std::vector<std::size_t> pieces_;
};

} // namespace

BallTree::BallTree(ConstMatrixView x, Parts parts, std::span<const double> margins) : x_(x) {
    rounding_ = 4e-12 + static_cast<double>(x.cols) * std::numeric_limits<double>::epsilon();
    if (x.rows == 0)
        return;
    const auto size = static_cast<std::int32_t>(x.rows);
    nodes_.reserve(static_cast<std::size_t>(node_count(size)));
    Arrangement arrangement(x, parts);
    nodes_.push_back({0, size});
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const auto [begin, end, radius, left] = nodes_[i];
        if (end - begin <= leaf_size)
            continue;
        const std::int32_t middle = begin + first_half(end - begin);
        arrangement.halve(begin, middle, end);
        nodes_[i].left = static_cast<std::int32_t>(nodes_.size());
        nodes_.push_back({begin, middle});
        nodes_.push_back({middle, end});
    }
    order_ = arrangement.arranged();
    centers_ = Matrix(node_count(size), x.cols);
    std::vector<std::int32_t> leaves(static_cast<std::size_t>((size + leaf_size - 1) / leaf_size));
    for (auto i = static_cast<std::int32_t>(nodes_.size()); i-- > 0;) {
        const Node& node = nodes_[static_cast<std::size_t>(i)];
        const auto leaf = leaves.begin() + node.begin / leaf_size;
        if (node.left == 0) {
            *leaf = i;
            enclose_rows(i, margins);
        } else {
            enclose_leaves(i, {leaf, leaves.begin() + (node.end + leaf_size - 1) / leaf_size});
        }
    }
}

/// Computes the ball of a leaf, around the mean of its rows.
void BallTree::enclose_rows(std::int32_t index, std::span<const double> margins) {
    double* center = centers_.row(index);
    const auto rows = rows_of(index);
    for (const std::int32_t row : rows)
        axpy(1 / static_cast<double>(rows.size()), x_.row(row), center, x_.cols);
    double& radius = nodes_[static_cast<std::size_t>(index)].radius;
    for (const std::int32_t row : rows) {
        const double margin = margins.empty() ? 0 : margins[static_cast<std::size_t>(row)];
        radius =
            std::max(radius, std::sqrt(squared_distance(x_.row(row), center, x_.cols)) + margin);
    }
}

/// Computes the ball of another node, around the mean of its leaves' centers. Their balls are
/// small, so it is hardly larger than a ball around the rows.
void BallTree::enclose_leaves(std::int32_t index, std::span<const std::int32_t> leaves) {
    double* mean = centers_.row(index);
    for (const std::int32_t leaf : leaves)
        axpy(1 / static_cast<double>(leaves.size()), center(leaf), mean, x_.cols);
    double& radius = nodes_[static_cast<std::size_t>(index)].radius;
    for (const std::int32_t leaf : leaves)
        radius = std::max(radius, nodes_[static_cast<std::size_t>(leaf)].radius +
                                      std::sqrt(squared_distance(center(leaf), mean, x_.cols)));
}

} // namespace stltsa::ltsa
