// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/patches.hpp"

#include <algorithm>

namespace stltsa::ltsa {

Patches::Patches(const Neighborhoods& neighborhoods, const Tangents& tangents,
                 const Components& components, std::int64_t component, std::int64_t dimension)
    : frames_(static_cast<std::int64_t>(
          components.members[static_cast<std::size_t>(component)].size())),
      size_(neighborhoods.size), dimension_(dimension), tangents_(&tangents) {
    for (std::int64_t i = 0; i < neighborhoods.frames(); ++i) {
        const auto members = neighborhoods.of(i);
        const auto first = static_cast<std::size_t>(members.front());
        if (components.of_frame[first] != component)
            continue;
        source_.push_back(static_cast<std::int32_t>(i));
        for (const std::int32_t member : members)
            index_.push_back(components.position[static_cast<std::size_t>(member)]);
    }
}

std::int64_t Patches::rank_deficient() const {
    return std::count_if(source_.begin(), source_.end(), [this](std::int32_t frame) {
        return tangents_->rank[static_cast<std::size_t>(frame)] < dimension_;
    });
}

} // namespace stltsa::ltsa
