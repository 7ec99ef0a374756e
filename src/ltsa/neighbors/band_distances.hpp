// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "linalg/matrix.hpp"
#include "linalg/pack.hpp"

namespace stltsa::ltsa {

/// Squared distances between frames [begin, end) of x that are at most `width` frames apart. Each
/// is computed once and shared by all neighborhoods that contain the pair.
class BandDistances {
  public:
    BandDistances(ConstMatrixView x, std::int64_t begin, std::int64_t end, std::int64_t width,
                  Simd simd);

    /// Distances within the windows of frames [first, last).
    static BandDistances of_windows(ConstMatrixView x, std::int64_t first, std::int64_t last,
                                    std::int64_t window, std::int64_t width, Simd simd) {
        return {x, std::max<std::int64_t>(0, first - window), std::min(x.rows, last + window),
                width, simd};
    }

    double operator()(std::int64_t p, std::int64_t q) const {
        const std::int64_t low = std::min(p, q);
        return distances_(low - begin_, std::max(p, q) - low);
    }
    /// Distances between members a < b of a neighborhood, given by their positions.
    auto among(std::span<const std::int32_t> members) const {
        return [this, members](std::int64_t a, std::int64_t b) {
            return (*this)(members[static_cast<std::size_t>(a)],
                           members[static_cast<std::size_t>(b)]);
        };
    }

  private:
    std::int64_t begin_;
    Matrix distances_; ///< row p - begin, column q - p
};

/// Frames of a block of a parallel loop: enough that computing the 2w frames at its borders twice
/// does not matter.
inline std::int64_t frame_block(std::int64_t window) {
    constexpr std::int64_t least = 512;
    return std::max<std::int64_t>(1, (4 * window + least - 1) / least) * least;
}

} // namespace stltsa::ltsa
