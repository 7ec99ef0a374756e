// SPDX-License-Identifier: BSD-3-Clause
// Squared distances of several points to the eight rows of a leaf at once.
#pragma once

#include <cstdint>

#include "linalg/pack.hpp"
#include "linalg/simd.hpp"

namespace stltsa::ltsa {

/// Writes up to eight rows side by side: `cols` columns of eight entries.
inline void fill_leaf(const double* const* rows, std::int64_t count, std::int64_t cols,
                      double* leaf) {
    for (std::int64_t c = 0; c < cols; ++c)
        for (std::int64_t lane = 0; lane < count; ++lane)
            leaf[c * lanes + lane] = rows[lane][c];
}

/// squared_distance() of linalg/simd.hpp, to the last bit, for a row in each lane: the same eight
/// sums of each.
struct LeafDistances {
    const double* leaf;          ///< as fill_leaf() writes it
    const double* const* points; ///< `count` of them
    std::int64_t count;
    std::int64_t cols;
    double* out; ///< eight for each point

    template <int W>
    STLTSA_INLINE void run() const {
        for (std::int64_t p = 0; p < count; ++p)
            for (std::int64_t lane = 0; lane < lanes; lane += W)
                store(to_lanes<Pack<W>>(points[p], leaf + lane), out + p * lanes + lane);
    }
    template <class P>
    STLTSA_INLINE P to_lanes(const double* point, const double* rows) const {
        P s[lanes] = {};
        for (std::int64_t c = 0; c < cols; c += lanes)
        // Unrolled, so that the sums stay in registers.
#pragma GCC unroll 8
            for (std::int64_t l = 0; l < lanes; ++l)
                if (c + l < cols) {
                    const P d = load<P>(rows + (c + l) * lanes) - point[c + l];
                    s[l] += d * d;
                }
        return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
    }
};

} // namespace stltsa::ltsa
