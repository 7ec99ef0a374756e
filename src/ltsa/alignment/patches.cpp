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
    if (components.count > 1) { // otherwise frames keep their numbers
        renumbered_.reserve(source_.size() * static_cast<std::size_t>(size_));
        for (const std::int32_t frame : source_)
            for (const std::int32_t member : neighborhoods.of(frame))
                renumbered_.push_back(components.position[static_cast<std::size_t>(member)]);
        index_ = renumbered_.data();
    }
    static_assert(row_block % group_size == 0);
    group_ranges_.resize(static_cast<std::size_t>((count() + group_size - 1) / group_size));
    std::vector<std::int64_t> deficient(static_cast<std::size_t>(row_blocks(count())));
    for_row_blocks(
        count(), machine, [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
            for (std::int64_t p = first; p < first + rows; p += group_size)
                group_ranges_[static_cast<std::size_t>(p / group_size)] =
                    range_of(p, std::min(p + group_size, first + rows));
            deficient[static_cast<std::size_t>(block)] = count_rank_deficient(first, first + rows);
        });
    rank_deficient_ = std::accumulate(deficient.begin(), deficient.end(), std::int64_t{0});
}

Patches::FrameRange Patches::range_of(std::int64_t begin, std::int64_t end) const {
    FrameRange range{of(begin).front(), of(begin).back()};
    for (std::int64_t p = begin + 1; p < end; ++p) {
        range.first = std::min(range.first, of(p).front());
        range.last = std::max(range.last, of(p).back());
    }
    return range;
}

std::int64_t Patches::count_rank_deficient(std::int64_t begin, std::int64_t end) const {
    return std::count_if(source_.begin() + begin, source_.begin() + end,
                         [this](std::int32_t frame) {
                             return tangents_->rank[static_cast<std::size_t>(frame)] < dimension_;
                         });
}

} // namespace stltsa::ltsa
