// SPDX-License-Identifier: BSD-3-Clause
// Table 1, step 2 by LAPACK: principal directions of one neighborhood at a time.
#pragma once

#include <cstdint>
#include <span>

#include "linalg/eigen.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/neighbors/neighborhood_distances.hpp"

namespace stltsa::ltsa {

class LocalPca {
  public:
    /// For neighborhoods of `size` frames, `count` directions (at most min(size, features)).
    LocalPca(ConstMatrixView x, std::int64_t size, std::int64_t count, Simd simd);

    void compute(std::span<const std::int32_t> neighborhood);
    /// All eigenvalues, without directions; needs count = min(size, features).
    void compute_values(std::span<const std::int32_t> neighborhood);

    /// Eigenvalue l of the correlation matrix, descending from l = 0.
    double value(std::int64_t l) const { return eigen_.value(l); }
    /// Writes the direction g of value(l), a unit vector orthogonal to e and to the directions
    /// `before` it (rows of `size` entries).
    void direction(std::int64_t l, double* out, const double* before) const;

  private:
    bool frame_side() const { return size_ <= x_.cols; }
    void correlate(std::span<const std::int32_t> neighborhood);
    void covariance(std::span<const std::int32_t> neighborhood);
    void gram(std::span<const std::int32_t> neighborhood);

    ConstMatrixView x_;
    std::int64_t size_;
    TopEigenpairs eigen_;
    NeighborhoodDistances distances_;
    Matrix centered_; ///< size x features; empty if frame_side()
    AlignedVector<double> mean_;
};

/// Table 1, step 3: makes a direction over `size` frames a column of G_i, orthogonal to the column
/// e / sqrt(k) and to the `count` directions `before` it (rows of `size` entries), with norm 1.
/// Zero stays zero.
void make_tangent(const double* before, std::int64_t count, std::int64_t size, double* direction);

} // namespace stltsa::ltsa
