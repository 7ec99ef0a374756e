// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/nearest.hpp"

#include <cmath>

#include "linalg/simd.hpp"
#include "ltsa/best.hpp"

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

/// Nodes of the tree over so many rows.
std::int64_t node_count(std::int64_t rows) {
    return rows <= leaf_size ? 1 : 1 + node_count(rows / 2) + node_count(rows - rows / 2);
}

double distance(const double* a, const double* b, std::int64_t count) {
    return std::sqrt(squared_distance(a, b, count));
}

} // namespace

NearestRows::NearestRows(ConstMatrixView x, const std::vector<Stretch>& stretches)
    : x_(x), stretches_(stretches), order_(stretches) {
    if (stretches.empty())
        return;
    rows_.reserve(stretches.size());
    for (const Stretch& stretch : stretches)
        rows_.push_back(stretch.row);
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
    const auto stretches = stretches_of(node);
    for (const Stretch& stretch : stretches)
        axpy(1 / static_cast<double>(stretches.size()), x_.row(stretch.row), center, x_.cols);
    for (const Stretch& stretch : stretches)
        for (const std::int32_t at : {stretch.row, stretch.next})
            node.radius = std::max(node.radius, distance(x_.row(at), center, x_.cols));
    nodes_.push_back(node);
    return index;
}

/// In halves along the column in which the rows differ most.
void NearestRows::split(std::int32_t index) {
    const Node node = nodes_[static_cast<std::size_t>(index)];
    const std::int64_t column = widest_column(x_, stretches_of(node));
    const std::int32_t middle = node.begin + (node.end - node.begin) / 2;
    std::nth_element(order_.begin() + node.begin, order_.begin() + middle,
                     order_.begin() + node.end, [&](const Stretch& a, const Stretch& b) {
                         const double at_a = x_(a.row, column);
                         const double at_b = x_(b.row, column);
                         return at_a < at_b || (at_a == at_b && a.row < b.row);
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

/// The foot of the perpendicular, from the lengths of the three sides, or an end.
NearStretch NearestRows::nearest_point(const double* query, Stretch stretch) const {
    const double* row = x_.row(stretch.row);
    const double* next = x_.row(stretch.next);
    const double to_row = squared_distance(query, row, x_.cols);
    if (stretch.row == stretch.next)
        return {to_row, stretch, 0};
    const double to_next = squared_distance(query, next, x_.cols);
    const double length = squared_distance(row, next, x_.cols);
    const double share = 0.5 + 0.5 * (to_row - to_next) / length;
    if (share >= 1)
        return {to_next, stretch, 1};
    if (!(share > 0)) // nor a number, where squares overflow
        return {to_row, stretch, 0};
    return {std::max(to_row - share * share * length, 0.0), stretch, share};
}

std::vector<Candidate> NearestRows::nearest_within(const double* query, std::int64_t count,
                                                   RowRange range) const {
    const auto begin = std::lower_bound(rows_.begin(), rows_.end(), range.begin);
    const auto end = std::lower_bound(begin, rows_.end(), range.end);
    Best<Candidate> best(static_cast<std::size_t>(std::min<std::int64_t>(count, end - begin)));
    if (count > 0)
        for (auto row = begin; row < end; ++row)
            best.offer({squared_distance(query, x_.row(*row), x_.cols), *row});
    return best.sorted();
}

std::vector<NearStretch> NearestRows::nearest_stretches_within(const double* query,
                                                               std::int64_t count,
                                                               RowRange range) const {
    const auto begin = std::lower_bound(rows_.begin(), rows_.end(), range.begin) - rows_.begin();
    const auto end = std::lower_bound(rows_.begin(), rows_.end(), range.end) - rows_.begin();
    Best<NearStretch> best(
        static_cast<std::size_t>(std::clamp<std::int64_t>(end - begin, 0, count)));
    for (auto i = begin; count > 0 && i < end; ++i) {
        const Stretch& stretch = stretches_[static_cast<std::size_t>(i)];
        const bool leaves = stretch.next >= range.end;
        best.offer(nearest_point(query, {stretch.row, leaves ? stretch.row : stretch.next}));
    }
    return best.sorted();
}

template <class Found, class OfferLeaf>
std::vector<Found> NearestRows::search(const double* query, std::int64_t count,
                                       const OfferLeaf& offer_leaf) const {
    if (count < 1 || rows_.empty())
        return {};
    Best<Found> best(std::min(static_cast<std::size_t>(count), rows_.size()));
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
        } else {
            offer_leaf(stretches_of(node), best);
        }
    }
    return best.sorted();
}

std::vector<Candidate> NearestRows::nearest_outside(const double* query, std::int64_t count,
                                                    RowRange zone) const {
    return search<Candidate>(query, count, [&](std::span<const Stretch> leaf, auto& best) {
        for (const Stretch& stretch : leaf)
            if (stretch.row < zone.begin || stretch.row >= zone.end)
                best.offer({squared_distance(query, x_.row(stretch.row), x_.cols), stretch.row});
    });
}

std::vector<NearStretch> NearestRows::nearest_stretches(const double* query,
                                                        std::int64_t count) const {
    return search<NearStretch>(query, count, [&](std::span<const Stretch> leaf, auto& best) {
        for (const Stretch& stretch : leaf)
            best.offer(nearest_point(query, stretch));
    });
}

} // namespace stltsa::ltsa
