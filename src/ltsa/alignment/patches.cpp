// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/alignment/patches.hpp"

#include <algorithm>
#include <numeric>

namespace stltsa::ltsa {

Patches::Patches(const Neighborhoods& neighborhoods, const Tangents& tangents,
                 const Components& components, std::int64_t component, std::int64_t dimension,
                 const Machine& machine)
    : frames_(static_cast<std::int64_t>(
          components.members[static_cast<std::size_t>(component)].size())),
      size_(neighborhoods.size), dimension_(dimension), tangents_(&tangents),
      source_(components.windows[static_cast<std::size_t>(component)]),
      index_(neighborhoods.index.data()) {
    if (components.count > 1) { // else every frame keeps its number
        renumbered_.reserve(source_.size() * static_cast<std::size_t>(size_));
        for (const std::int32_t frame : source_)
            for (const std::int32_t member : neighborhoods.of(frame))
                renumbered_.push_back(components.position[static_cast<std::size_t>(member)]);
        index_ = renumbered_.data();
    }
    static_assert(row_block % hull_size == 0);
    hulls_.resize(static_cast<std::size_t>((count() + hull_size - 1) / hull_size));
    std::vector<std::int64_t> deficient(static_cast<std::size_t>(row_blocks(count())));
    for_row_blocks(
        count(), machine, [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
            for (std::int64_t p = first; p < first + rows; p += hull_size)
                hulls_[static_cast<std::size_t>(p / hull_size)] =
                    hull_of(p, std::min(p + hull_size, first + rows));
            deficient[static_cast<std::size_t>(block)] = count_rank_deficient(first, first + rows);
        });
    rank_deficient_ = std::accumulate(deficient.begin(), deficient.end(), std::int64_t{0});
}

Patches::Hull Patches::hull_of(std::int64_t begin, std::int64_t end) const {
    Hull hull{of(begin).front(), of(begin).back()};
    for (std::int64_t p = begin + 1; p < end; ++p) {
        hull.first = std::min(hull.first, of(p).front());
        hull.last = std::max(hull.last, of(p).back());
    }
    return hull;
}

std::int64_t Patches::count_rank_deficient(std::int64_t begin, std::int64_t end) const {
    return std::count_if(source_.begin() + begin, source_.begin() + end,
                         [this](std::int32_t frame) {
                             return tangents_->rank[static_cast<std::size_t>(frame)] < dimension_;
                         });
}

} // namespace stltsa::ltsa
