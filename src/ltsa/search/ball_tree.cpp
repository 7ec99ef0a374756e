// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/search/ball_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "ltsa/frames.hpp"

namespace stltsa::ltsa {
namespace {

/// Whether rows that follow each other are much nearer to each other than any two.
bool in_order(ConstMatrixView x, const std::vector<Stretch>& stretches) {
    const std::size_t count = stretches.size();
    double steps = 0, leaps = 0;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double* row = x.row(stretches[i].row);
        steps += squared_distance(row, x.row(stretches[i + 1].row), x.cols);
        leaps += squared_distance(row, x.row(stretches[(i + count / 2) % count].row), x.cols);
    }
    return steps <= leaps / 4;
}

/// How many of these rows the first half of a node gets: whole leaves.
std::int32_t first_half(std::int32_t rows) {
    constexpr std::int32_t size = BallTree::leaf_size;
    return (rows / 2 + size - 1) / size * size;
}

/// Nodes of the tree over so many rows.
std::int64_t node_count(std::int32_t rows) {
    return 2 * ((static_cast<std::int64_t>(rows) + BallTree::leaf_size - 1) / BallTree::leaf_size) -
           1;
}

/// Pieces that follow each other stay together unless they would vary by so much more: a search
/// begins with them. Of 1 to 2, what searches take least time with, of 9000 recorded frames and of
/// 30 000 made-up ones that repeat for long.
constexpr double favor_for_time = 1.1;

/// Puts stretches in the order in which they lie in the tree: what is halved are pieces of motion
/// as long as a leaf, each taken for the row in its middle, or single rows.
class Arrangement {
  public:
    Arrangement(ConstMatrixView x, const std::vector<Stretch>& stretches)
        : x_(x), stretches_(stretches), length_(in_order(x, stretches) ? BallTree::leaf_size : 1),
          pieces_((stretches.size() + length_ - 1) / length_) {
        std::iota(pieces_.begin(), pieces_.end(), std::size_t{0});
    }

    /// Puts the pieces of a node in order about the one with which its second half begins: in order
    /// of time, or of the column in which they differ most where that leaves halves that vary less.
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
        if (of_time < favor_for_time * variation())
            in_time();
    }

    std::vector<Stretch> arranged() const {
        std::vector<Stretch> order;
        order.reserve(stretches_.size());
        for (const std::size_t piece : pieces_)
            for (std::size_t i = piece * length_;
                 i < std::min((piece + 1) * length_, stretches_.size()); ++i)
                order.push_back(stretches_[i]);
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
    bool is_short(std::size_t piece) const { return (piece + 1) * length_ > stretches_.size(); }
    const double* row_of(std::size_t piece) const {
        return x_.row(
            stretches_[std::min(piece * length_ + length_ / 2, stretches_.size() - 1)].row);
    }

    /// In order of the column in which they differ most, but the short one stays at the end: the
    /// others are whole leaves.
    void order_by_column(Piece first, Piece half, Piece last) {
        const std::int64_t column = widest_column(std::span(first, last));
        // Read once: whoever changes x meanwhile must not change the order while it is made.
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

    /// The column in which these differ most.
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

    /// The sum of squared distances from their mean.
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
    const std::vector<Stretch>& stretches_;
    std::size_t length_; ///< of a piece
    std::vector<std::size_t> pieces_;
};

} // namespace

BallTree::BallTree(ConstMatrixView x, const std::vector<Stretch>& stretches) : x_(x) {
    rounding_ = 4e-12 + static_cast<double>(x.cols) * std::numeric_limits<double>::epsilon();
    if (stretches.empty())
        return;
    const auto size = static_cast<std::int32_t>(stretches.size());
    nodes_.reserve(static_cast<std::size_t>(node_count(size)));
    Arrangement arrangement(x, stretches);
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
            enclose_rows(i);
        } else {
            enclose_leaves(i, {leaf, leaves.begin() + (node.end + leaf_size - 1) / leaf_size});
        }
    }
}

/// The ball of a leaf: about the mean of its rows.
void BallTree::enclose_rows(std::int32_t index) {
    double* center = centers_.row(index);
    const auto stretches = stretches_of(index);
    for (const Stretch& stretch : stretches)
        axpy(1 / static_cast<double>(stretches.size()), x_.row(stretch.row), center, x_.cols);
    double square = 0;
    for (const auto [row, next] : stretches) {
        square = std::max(square, squared_distance(x_.row(row), center, x_.cols));
        if (next != row)
            square = std::max(square, squared_distance(x_.row(next), center, x_.cols));
    }
    nodes_[static_cast<std::size_t>(index)].radius = std::sqrt(square);
}

/// The ball of another node: about the mean of its leaves. Their balls are small, so that the ball
/// about them is hardly larger than that about their rows.
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
