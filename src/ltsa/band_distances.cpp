// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/band_distances.hpp"

#include "linalg/simd.hpp"

namespace stltsa::ltsa {

BandDistances::BandDistances(ConstMatrixView x, std::int64_t begin, std::int64_t end,
                             std::int64_t width)
    : begin_(begin), distances_(end - begin, width + 1) {
    for (std::int64_t p = begin; p < end; ++p)
        for (std::int64_t q = p + 1; q < std::min(end, p + width + 1); ++q)
            distances_(p - begin, q - p) = squared_distance(x.row(p), x.row(q), x.cols);
}

} // namespace stltsa::ltsa
