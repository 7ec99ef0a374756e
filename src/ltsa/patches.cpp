// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/patches.hpp"

#include <algorithm>

#include "linalg/simd.hpp"

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

void Patches::project_once(std::int64_t patch, double* v) const {
    double mean = 0;
    for (std::int64_t j = 0; j < size_; ++j)
        mean += v[j];
    mean /= static_cast<double>(size_);
    for (std::int64_t j = 0; j < size_; ++j)
        v[j] -= mean;
    for (std::int64_t l = 0; l < dimension_; ++l) {
        const double* g = direction(patch, l);
        axpy(-dot(g, v, size_), g, v, size_);
    }
}

} // namespace stltsa::ltsa
