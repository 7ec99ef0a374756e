// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/neighbors/band_distances.hpp"

#include "base/checkpoint.hpp"
#include "base/parallel.hpp"
#include "linalg/simd.hpp"

namespace stltsa::ltsa {

namespace {

/// squared_distance() of linalg/simd.hpp with packs: the same eight sums, the same bits.
template <int W>
STLTSA_INLINE double distance_in_packs(const double* a, const double* b, std::int64_t count) {
    Pack<W> sums[lanes / W] = {};
    std::int64_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (std::int64_t p = 0; p < lanes / W; ++p) {
            const Pack<W> d = load<Pack<W>>(a + i + p * W) - load<Pack<W>>(b + i + p * W);
            sums[p] += d * d;
        }
    double s[lanes];
    for (std::int64_t l = 0; l < lanes; ++l)
        s[l] = sums[l / W][l % W];
    for (std::int64_t l = 0; i < count; ++i, ++l) {
        const double d = a[i] - b[i];
        s[l] += d * d;
    }
    return sum_lanes(s);
}

struct FillBand {
    ConstMatrixView x; ///< the rows of the band
    MatrixView band;

    template <int W>
    STLTSA_INLINE void run() const {
        for (std::int64_t p = 0; p < x.rows; ++p) {
            band(p, 0) = 0;
            for (std::int64_t q = p + 1; q < std::min(x.rows, p + band.cols); ++q) {
                band(p, q - p) = distance_in_packs<W>(x.row(p), x.row(q), x.cols);
                checkpoint(x.cols);
            }
        }
    }
};

} // namespace

BandDistances::BandDistances(ConstMatrixView x, std::int64_t begin, std::int64_t end,
                             std::int64_t width, Simd simd)
    : begin_(begin), distances_(Matrix::unset(end - begin, width + 1)) {
    run_simd(simd, FillBand{x.block(begin, end - begin), distances_.view()});
}

} // namespace stltsa::ltsa
