// SPDX-License-Identifier: BSD-3-Clause
// Principal directions of several small neighborhoods at once, one in each lane of a pack.
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"
#include "linalg/pack.hpp"

namespace stltsa::ltsa {

/// Finds the leading eigenvectors of correlation matrices by block iteration. A lane's results do
/// not depend on what is in the others, nor on how many there are.
class TangentBatch {
  public:
    /// Beyond this, LAPACK on the matrix of features is the better way.
    static constexpr std::int64_t largest_size = 32;

    /// For neighborhoods of `size` frames, `count` directions.
    TangentBatch(std::int64_t size, std::int64_t count, Simd simd);

    std::int64_t lanes() const { return lanes_; }
    /// Takes the squared distance of frames a < b of a lane's neighborhood.
    void set_distance(std::int64_t lane, std::int64_t a, std::int64_t b, double distance) {
        matrix_[index(a * rows_ + b, lane)] = distance;
    }
    /// Every lane must have its distances; they are destroyed.
    void solve();

    /// Whether solve() found the directions of a lane, and they are the leading ones beyond doubt.
    /// Where it did not, another method is needed.
    bool found(std::int64_t lane) const { return values_[index(count_, lane)] > 0; }
    /// Eigenvalue l of the correlation matrix, descending.
    double value(std::int64_t lane, std::int64_t l) const { return values_[index(l, lane)]; }
    /// Its eigenvector: `size` entries.
    void direction(std::int64_t lane, std::int64_t l, double* out) const;

  private:
    std::size_t index(std::int64_t entry, std::int64_t lane) const {
        return static_cast<std::size_t>(entry * lanes_ + lane);
    }
    void fill_start();

    std::int64_t size_, count_;
    std::int64_t rows_;    ///< size, rounded up to what the product takes at a time
    std::int64_t columns_; ///< of the block: more than count, which speeds up convergence
    Simd simd_;
    std::int64_t lanes_;
    AlignedVector<double> matrix_;  ///< rows x rows
    AlignedVector<double> start_;   ///< columns of `rows` entries, the same in every lane
    AlignedVector<double> block_;   ///< the same shape
    AlignedVector<double> product_; ///< the same shape
    AlignedVector<double> small_;   ///< Ritz values and two matrices of order `columns`
    AlignedVector<double> values_;  ///< count eigenvalues, then whether they were found
    AlignedVector<double> vectors_; ///< count columns of `rows` entries
};

} // namespace stltsa::ltsa
