// SPDX-License-Identifier: BSD-3-Clause
// The local terms of the alignment matrix of one component (Table 1, step 4): B = sum over patches
// of S_i (I - e e^T/k - G_i G_i^T) S_i^T, where S_i selects the patch's frames. The paper's G_i
// includes the column e / sqrt(k).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/machine.hpp"
#include "ltsa/neighbors/components.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/tangents/tangents.hpp"

namespace stltsa::ltsa {

/// The neighborhoods of a component, with its frames numbered 0 .. frames - 1 in order of time.
/// Refers to the arguments of the constructor.
class Patches {
  public:
    /// `dimension`: the number of tangents to use.
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
    /// Patches with fewer than `dimension` directions.
    std::int64_t rank_deficient() const { return rank_deficient_; }

    /// Consecutive patches whose frames are bounded together by one range.
    static constexpr std::int64_t group_size = 64;
    /// The first and last frame of a group of patches.
    struct FrameRange {
        std::int32_t first, last;
    };
    std::span<const FrameRange> group_ranges() const { return group_ranges_; }

  private:
    FrameRange range_of(std::int64_t begin, std::int64_t end) const;
    std::int64_t count_rank_deficient(std::int64_t begin, std::int64_t end) const;

    std::int64_t frames_;
    std::int64_t size_;
    std::int64_t dimension_;
    const Tangents* tangents_;
    std::span<const std::int32_t> source_; ///< the frame of each patch
    const std::int32_t* index_;            ///< of the neighborhoods, or of `renumbered_`
    AlignedVector<std::int32_t> renumbered_;
    std::vector<FrameRange> group_ranges_;
    std::int64_t rank_deficient_;
};

} // namespace stltsa::ltsa
