// SPDX-License-Identifier: BSD-3-Clause
// Squared distances within one neighborhood at a time, for neighborhoods with few distances in
// common.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "linalg/pack.hpp"
#include "linalg/simd.hpp"

namespace stltsa::ltsa {

class NeighborhoodDistances {
  public:
    NeighborhoodDistances(ConstMatrixView x, std::int64_t size, Simd simd);

    /// The distance between two frames.
    double operator()(std::int64_t p, std::int64_t q) const {
        return squared_distance(x_.row(p), x_.row(q), x_.cols);
    }
    /// Distances between members a < b of a neighborhood, given by their positions; valid until the
    /// next call.
    auto among(std::span<const std::int32_t> members) {
        measure(members);
        return [this](std::int64_t a, std::int64_t b) {
            return distances_(b / lanes * size_ + a, b % lanes);
        };
    }

  private:
    void measure(std::span<const std::int32_t> members);

    ConstMatrixView x_;
    std::int64_t size_;
    Simd simd_;
    AlignedVector<double> columns_; ///< eight members at a time, laid out for LeafDistances
    std::vector<const double*> rows_;
    Matrix distances_; ///< row a of block g: from member a to members 8 g ..
};

} // namespace stltsa::ltsa
