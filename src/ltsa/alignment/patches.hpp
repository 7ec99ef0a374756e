// SPDX-License-Identifier: BSD-3-Clause
// The local terms of the alignment matrix of one component: B = sum over patches of
// S_i (I - e e^T/k - G_i G_i^T) S_i^T (paper, Table 1, step 4), where S_i picks the patch's frames.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/machine.hpp"
#include "ltsa/neighbors/components.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/tangents/tangents.hpp"

namespace stltsa::ltsa {

/// Neighborhoods whose frames are renumbered 0 .. frames-1 within a component, in order of time.
/// What it is made from must outlive it.
class Patches {
  public:
    /// `dimension`: how many of the tangents to use.
    Patches(const Neighborhoods& neighborhoods, const Tangents& tangents,
            const Components& components, std::int64_t component, std::int64_t dimension,
            const Machine& machine);
    Patches(const Patches&) = delete;
    Patches& operator=(const Patches&) = delete;

    std::int64_t frames() const { return frames_; }
    std::int64_t count() const { return static_cast<std::int64_t>(source_.size()); }
    std::int64_t size() const { return size_; }
    std::int64_t dimension() const { return dimension_; }
    /// Frames of a patch, ascending.
    std::span<const std::int32_t> of(std::int64_t patch) const {
        return {index_ + patch * size_, static_cast<std::size_t>(size_)};
    }
    const double* direction(std::int64_t patch, std::int64_t l) const {
        return tangents_->direction(source_[static_cast<std::size_t>(patch)], l);
    }
    /// Patches of fewer than `dimension` directions.
    std::int64_t rank_deficient() const { return rank_deficient_; }

    /// Consecutive patches that share one range of frames.
    static constexpr std::int64_t hull_size = 64;
    /// First and last frame of these patches.
    struct Hull {
        std::int32_t first, last;
    };
    std::span<const Hull> hulls() const { return hulls_; }

  private:
    Hull hull_of(std::int64_t begin, std::int64_t end) const;
    std::int64_t count_rank_deficient(std::int64_t begin, std::int64_t end) const;

    std::int64_t frames_;
    std::int64_t size_;
    std::int64_t dimension_;
    const Tangents* tangents_;
    std::span<const std::int32_t> source_; ///< frame whose neighborhood a patch is
    const std::int32_t* index_;            ///< the neighborhoods' own, or:
    AlignedVector<std::int32_t> renumbered_;
    std::vector<Hull> hulls_;
    std::int64_t rank_deficient_;
};

} // namespace stltsa::ltsa
