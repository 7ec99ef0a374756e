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

/// squared_distance() of linalg/simd.hpp for one row per lane, with the same eight sums and bits.
struct LeafDistances {
    const double* leaf;          ///< written by fill_leaf()
    const double* const* points; ///< `count` of them
    std::int64_t count;
    std::int64_t cols;
    double* out; ///< eight per point

    template <int W>
    STLTSA_INLINE void run() const {
        for (std::int64_t p = 0; p < count; ++p)
            for (std::int64_t lane = 0; lane < lanes; lane += W)
                store(to_lanes<Pack<W>>(points[p], leaf + lane), out + p * lanes + lane);
    }
    template <class P>
    STLTSA_INLINE P to_lanes(const double* point, const double* rows) const {
        P s[lanes] = {};
        std::int64_t c = 0;
        for (; c + lanes <= cols; c += lanes)
            add_columns(point + c, rows + c * lanes, lanes, s);
        add_columns(point + c, rows + c * lanes, cols - c, s);
        return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
    }
    /// Unrolled, so that the sums stay in registers.
    template <class P>
    STLTSA_INLINE static void add_columns(const double* point, const double* rows,
                                          std::int64_t count, P (&s)[lanes]) {
#pragma GCC unroll 8
        for (std::int64_t l = 0; l < lanes; ++l)
            if (l < count) {
                const P d = load<P>(rows + l * lanes) - point[l];
                s[l] += d * d;
            }
    }
};

} // namespace stltsa::ltsa
