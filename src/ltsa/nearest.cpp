// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/nearest.hpp"

#include <cmath>

#include "linalg/simd.hpp"

namespace stltsa::ltsa {
namespace {

/// Most rows of a leaf.
constexpr std::int32_t leaf_size = 16;

/// A node, and a lower bound of the squared distance to the rows below it.
struct Bound {
    double distance;
    std::int32_t node;
};

/// For heaps with the nearest node on top.
bool farther(const Bound& a, const Bound& b) {
    return a.distance > b.distance || (a.distance == b.distance && a.node > b.node);
}

/// The nearest so far, as a heap with the farthest on top.
class Best {
  public:
    explicit Best(std::size_t count) : count_(count) { heap_.reserve(count); }

    bool is_beyond(double distance) const {
        return heap_.size() == count_ && distance > heap_.front().distance;
    }
    void offer(const Candidate& candidate) {
        if (heap_.size() == count_) {
            if (!(candidate < heap_.front()))
                return;
            std::pop_heap(heap_.begin(), heap_.end());
            heap_.back() = candidate;
        } else {
            heap_.push_back(candidate);
        }
        std::push_heap(heap_.begin(), heap_.end());
    }
    std::vector<Candidate> sorted() {
        std::sort_heap(heap_.begin(), heap_.end());
        return std::move(heap_);
    }

  private:
    std::size_t count_;
    std::vector<Candidate> heap_;
};

/// The column in which these rows differ most.
std::int64_t widest_column(ConstMatrixView x, std::span<const std::int32_t> rows) {
    std::vector<double> least(x.row(rows[0]), x.row(rows[0]) + x.cols);
    std::vector<double> most = least;
    for (const std::int32_t row : rows)
        for (std::size_t c = 0; c < least.size(); ++c) {
            const double value = x.row(row)[c];
            least[c] = std::min(least[c], value);
            most[c] = std::max(most[c], value);
        }
    std::size_t widest = 0;
    for (std::size_t c = 0; c < least.size(); ++c)
        if (most[c] - least[c] > most[widest] - least[widest])
            widest = c;
    return static_cast<std::int64_t>(widest);
}

/// Nodes of the tree over so many rows.
std::int64_t node_count(std::int64_t rows) {
    return rows <= leaf_size ? 1 : 1 + node_count(rows / 2) + node_count(rows - rows / 2);
}

double distance(const double* a, const double* b, std::int64_t count) {
    return std::sqrt(squared_distance(a, b, count));
}

} // namespace

NearestRows::NearestRows(ConstMatrixView x, std::vector<std::int32_t> rows)
    : x_(x), rows_(std::move(rows)), order_(rows_) {
    if (rows_.empty())
        return;
    const auto size = static_cast<std::int32_t>(rows_.size());
    centers_ = Matrix(node_count(size), x.cols);
    nodes_.reserve(static_cast<std::size_t>(centers_.rows()));
    add_node(0, size);
    for (std::int32_t node = 0; node < static_cast<std::int32_t>(nodes_.size()); ++node)
        if (nodes_[static_cast<std::size_t>(node)].end -
                nodes_[static_cast<std::size_t>(node)].begin >
            leaf_size)
            split(node);
}

std::int32_t NearestRows::add_node(std::int32_t begin, std::int32_t end) {
    const auto index = static_cast<std::int32_t>(nodes_.size());
    Node node{begin, end};
    double* center = centers_.row(index);
    const auto rows = rows_of(node);
    for (const std::int32_t row : rows)
        axpy(1 / static_cast<double>(rows.size()), x_.row(row), center, x_.cols);
    for (const std::int32_t row : rows)
        node.radius = std::max(node.radius, distance(x_.row(row), center, x_.cols));
    nodes_.push_back(node);
    return index;
}

/// In halves along the column in which the rows differ most.
void NearestRows::split(std::int32_t index) {
    const Node node = nodes_[static_cast<std::size_t>(index)];
    const std::int64_t column = widest_column(x_, rows_of(node));
    const std::int32_t middle = node.begin + (node.end - node.begin) / 2;
    std::nth_element(order_.begin() + node.begin, order_.begin() + middle,
                     order_.begin() + node.end, [&](std::int32_t a, std::int32_t b) {
                         const double at_a = x_(a, column);
                         const double at_b = x_(b, column);
                         return at_a < at_b || (at_a == at_b && a < b);
                     });
    const std::int32_t left = add_node(node.begin, middle);
    const std::int32_t right = add_node(middle, node.end);
    nodes_[static_cast<std::size_t>(index)].left = left;
    nodes_[static_cast<std::size_t>(index)].right = right;
}

double NearestRows::lower_bound(const double* query, std::int32_t node) const {
    // The triangle inequality, less what rounding may have added.
    constexpr double rounding = 1e-12;
    const double center = distance(query, centers_.row(node), x_.cols);
    const double radius = nodes_[static_cast<std::size_t>(node)].radius;
    const double bound = center - radius - rounding * (center + radius);
    return bound > 0 ? bound * bound : 0;
}

std::vector<Candidate> NearestRows::nearest_within(const double* query, std::int64_t count,
                                                   RowRange range) const {
    const auto begin = std::lower_bound(rows_.begin(), rows_.end(), range.begin);
    const auto end = std::lower_bound(begin, rows_.end(), range.end);
    Best best(static_cast<std::size_t>(std::min<std::int64_t>(count, end - begin)));
    if (count > 0)
        for (auto row = begin; row < end; ++row)
            best.offer({squared_distance(query, x_.row(*row), x_.cols), *row});
    return best.sorted();
}

std::vector<Candidate> NearestRows::nearest_outside(const double* query, std::int64_t count,
                                                    RowRange zone) const {
    Best best(std::min(static_cast<std::size_t>(count), rows_.size()));
    if (count < 1 || rows_.empty())
        return {};
    std::vector<Bound> open{{0, 0}};
    const auto add = [&](std::int32_t node) {
        open.push_back({lower_bound(query, node), node});
        std::push_heap(open.begin(), open.end(), farther);
    };
    while (!open.empty() && !best.is_beyond(open.front().distance)) {
        const Node& node = nodes_[static_cast<std::size_t>(open.front().node)];
        std::pop_heap(open.begin(), open.end(), farther);
        open.pop_back();
        if (node.left != 0) {
            add(node.left);
            add(node.right);
            continue;
        }
        for (const std::int32_t row : rows_of(node))
            if (row < zone.begin || row >= zone.end)
                best.offer({squared_distance(query, x_.row(row), x_.cols), row});
    }
    return best.sorted();
}

} // namespace stltsa::ltsa
