// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/ball_tree.hpp"

#include <algorithm>
#include <cmath>

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

/// The column in which the rows that these begin at differ most.
std::int64_t widest_column(ConstMatrixView x, std::span<const Stretch> stretches) {
    const double* first = x.row(stretches.front().row);
    std::vector<double> least(first, first + x.cols);
    std::vector<double> most = least;
    for (const Stretch& stretch : stretches)
        for (std::size_t c = 0; c < least.size(); ++c) {
            const double value = x.row(stretch.row)[c];
            least[c] = std::min(least[c], value);
            most[c] = std::max(most[c], value);
        }
    std::size_t widest = 0;
    for (std::size_t c = 0; c < least.size(); ++c)
        if (most[c] - least[c] > most[widest] - least[widest])
            widest = c;
    return static_cast<std::int64_t>(widest);
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

} // namespace

BallTree::BallTree(ConstMatrixView x, const std::vector<Stretch>& stretches)
    : x_(x), order_(stretches) {
    rounding_ = 4e-12 + static_cast<double>(x.cols) * std::numeric_limits<double>::epsilon();
    if (stretches.empty())
        return;
    const auto size = static_cast<std::int32_t>(stretches.size());
    centers_ = Matrix(node_count(size), x.cols);
    nodes_.reserve(static_cast<std::size_t>(centers_.rows()));
    const bool halve_time = in_order(x, stretches);
    add_node(0, size);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(nodes_.size()); ++i) {
        const std::int32_t begin = nodes_[static_cast<std::size_t>(i)].begin;
        const std::int32_t end = nodes_[static_cast<std::size_t>(i)].end;
        if (end - begin <= leaf_size)
            continue;
        const std::int32_t middle = begin + first_half(end - begin);
        if (!halve_time)
            halve_widest_column(i, middle);
        nodes_[static_cast<std::size_t>(i)].left = add_node(begin, middle);
        add_node(middle, end);
    }
}

std::int32_t BallTree::add_node(std::int32_t begin, std::int32_t end) {
    const auto index = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({begin, end});
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
    nodes_.back().radius = std::sqrt(square);
    return index;
}

/// Puts the stretches of a node in order about the one that becomes number `middle`.
void BallTree::halve_widest_column(std::int32_t index, std::int32_t middle) {
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    const std::int64_t column = widest_column(x_, stretches_of(index));
    std::nth_element(order_.begin() + node.begin, order_.begin() + middle,
                     order_.begin() + node.end, [&](const Stretch& a, const Stretch& b) {
                         const double at_a = x_(a.row, column);
                         const double at_b = x_(b.row, column);
                         return at_a < at_b || (at_a == at_b && a.row < b.row);
                     });
}

} // namespace stltsa::ltsa
