// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/patches.hpp"

#include <algorithm>

namespace stltsa::ltsa {

Patches::Patches(const Neighborhoods& neighborhoods, const Tangents& tangents,
                 const Components& components, std::int64_t component, std::int64_t dimension)
    : frames_(static_cast<std::int64_t>(
          components.members[static_cast<std::size_t>(component)].size())),
      size_(neighborhoods.size), dimension_(dimension), tangents_(&tangents),
      source_(components.windows[static_cast<std::size_t>(component)]),
      index_(neighborhoods.index.data()) {
    if (components.count == 1) // every frame keeps its number
        return;
    renumbered_.reserve(source_.size() * static_cast<std::size_t>(size_));
    for (const std::int32_t frame : source_)
        for (const std::int32_t member : neighborhoods.of(frame))
            renumbered_.push_back(components.position[static_cast<std::size_t>(member)]);
    index_ = renumbered_.data();
}

std::int64_t Patches::rank_deficient() const {
    return std::count_if(source_.begin(), source_.end(), [this](std::int32_t frame) {
        return tangents_->rank[static_cast<std::size_t>(frame)] < dimension_;
    });
}

} // namespace stltsa::ltsa
