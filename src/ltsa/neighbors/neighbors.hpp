// SPDX-License-Identifier: BSD-3-Clause
// The neighborhoods of all frames (Table 1, step 1; paper, section 2.1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/parameters.hpp"

namespace stltsa::ltsa {

/// The neighborhood of each frame: k frame numbers, ascending.
struct Neighborhoods {
    std::int64_t size = 0; ///< k
    UnsetVector<std::int32_t> index;

    std::int64_t frames() const { return static_cast<std::int64_t>(index.size()) / size; }
    std::span<const std::int32_t> of(std::int64_t frame) const {
        return {index.data() + frame * size, static_cast<std::size_t>(size)};
    }
    std::span<std::int32_t> of(std::int64_t frame) {
        return {index.data() + frame * size, static_cast<std::size_t>(size)};
    }
};

/// Table 1, step 1: selects the k nearest frames within +-window frames of the same clip. The
/// window is truncated at the ends of the clip.
class WindowNeighbors {
  public:
    WindowNeighbors(std::span<const std::int64_t> lengths, const Parameters& parameters);
    /// For the frames [first, last). distance(p, q): squared distance of frames of one window, a
    /// BandDistances or NeighborhoodDistances.
    template <class Distance>
    void select(const Distance& distance, std::int64_t first, std::int64_t last,
                Neighborhoods& neighborhoods) const;
    /// The same, computing the distances.
    void select(ConstMatrixView x, Simd simd, std::int64_t first, std::int64_t last,
                Neighborhoods& neighborhoods) const;

  private:
    std::vector<std::int64_t> begins_{0}; ///< first frames of the clips, and the end of the last
    std::int64_t window_;
    bool include_self_;
};

// Table 1, step 1: the neighborhoods of all frames, by mode.

/// The k nearest within the window (WindowNeighbors).
Neighborhoods temporal_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                                 const Parameters& parameters);
/// The k nearest among all frames.
Neighborhoods spatial_neighbors(ConstMatrixView x, const Parameters& parameters);
/// The temporal neighbors, plus the `links` nearest frames outside the exclusion zone of
/// +-exclusion frames of the same clip.
Neighborhoods recurrent_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                                  const Parameters& parameters);

} // namespace stltsa::ltsa
