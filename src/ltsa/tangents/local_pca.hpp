// SPDX-License-Identifier: BSD-3-Clause
// Principal directions of one neighborhood at a time; keeps its workspace.
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
    /// The values alone, all of them: `count` is min(size, features).
    void compute_values(std::span<const std::int32_t> neighborhood);

    /// Eigenvalue l of the correlation matrix, descending from l = 0.
    double value(std::int64_t l) const { return eigen_.value(l); }
    /// Writes the unit vector over the neighborhood's frames that belongs to value(l), orthogonal
    /// to e and to the directions `before` it (rows of `size` entries).
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
    Matrix centered_; ///< size x features, only on the feature side
    AlignedVector<double> mean_;
};

/// Makes a direction over `size` frames orthogonal to e and to the `count` directions `before` it
/// (rows of `size` entries), with norm 1; zero stays zero. G_i of Table 1, step 3, without its
/// column e / sqrt(k).
void make_tangent(const double* before, std::int64_t count, std::int64_t size, double* direction);

} // namespace stltsa::ltsa
