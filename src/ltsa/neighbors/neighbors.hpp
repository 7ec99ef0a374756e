// SPDX-License-Identifier: BSD-3-Clause
// Which frames are neighbors of which (paper, section 2.1; Table 1, step 1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.hpp"
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

/// Selects the k nearest within +-window frames of the same clip. The window is cut off at the
/// ends.
class WindowNeighbors {
  public:
    WindowNeighbors(std::span<const std::int64_t> lengths, const Parameters& parameters);
    /// Of the frames [first, last). distance(p, q): squared distance of frames of one window; for
    /// BandDistances and NeighborhoodDistances.
    template <class Distance>
    void select(const Distance& distance, std::int64_t first, std::int64_t last,
                Neighborhoods& neighborhoods) const;
    /// The same, with distances of its own.
    void select(ConstMatrixView x, Simd simd, std::int64_t first, std::int64_t last,
                Neighborhoods& neighborhoods) const;

  private:
    std::vector<std::int64_t> begins_{0}; ///< of the clips, and the end of the last one
    std::int64_t window_;
    bool include_self_;
};

// Neighborhoods of all frames, the clips one after another.

/// As WindowNeighbors selects them.
Neighborhoods temporal_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                                 const Parameters& parameters, const Progress& progress);
/// The k nearest among all frames.
Neighborhoods spatial_neighbors(ConstMatrixView x, const Parameters& parameters,
                                const Progress& progress);
/// The temporal ones, plus the `links` nearest frames outside the exclusion zone, which is
/// +-exclusion frames of the same clip.
Neighborhoods recurrent_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                                  const Parameters& parameters, const Progress& progress);

} // namespace stltsa::ltsa
