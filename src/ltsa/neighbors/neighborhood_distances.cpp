// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/neighbors/neighborhood_distances.hpp"

#include <algorithm>

#include "ltsa/search/leaf_distances.hpp"

namespace stltsa::ltsa {

NeighborhoodDistances::NeighborhoodDistances(ConstMatrixView x, std::int64_t size, Simd simd)
    : x_(x), size_(size), simd_(simd), columns_(checked_size(x.cols, lanes)),
      distances_((size + lanes - 1) / lanes * size, lanes) {}

void NeighborhoodDistances::measure(std::span<const std::int32_t> members) {
    rows_.clear();
    for (const std::int32_t member : members)
        rows_.push_back(x_.row(member));
    for (std::int64_t first = 0; first < size_; first += lanes) {
        const std::int64_t count = std::min(lanes, size_ - first);
        fill_leaf(rows_.data() + first, count, x_.cols, columns_.data());
        // Distances to the members before the last one of the block.
        run_simd(simd_, LeafDistances{columns_.data(), rows_.data(), first + count - 1, x_.cols,
                                      distances_.row(first / lanes * size_)});
    }
}

} // namespace stltsa::ltsa
