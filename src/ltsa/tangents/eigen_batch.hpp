// SPDX-License-Identifier: BSD-3-Clause
// Leading eigenvectors of several positive semidefinite matrices at once, one per lane of a pack:
// the arrays of a BlockIteration, and its results.
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"
#include "linalg/pack.hpp"
#include "ltsa/tangents/block_iteration.hpp"

namespace stltsa::ltsa {

constexpr std::int64_t rounded_up(std::int64_t value, std::int64_t step) {
    return (value + step - 1) / step * step;
}

/// A lane's results do not depend on the other lanes or their number.
class EigenBatch {
  public:
    struct Shape {
        std::int64_t size;    ///< order of the matrices
        std::int64_t count;   ///< wanted eigenvectors
        std::int64_t columns; ///< of the block, at least count; more converge sooner
    };

    EigenBatch(const Shape& shape, Simd simd);

    Simd simd() const { return simd_; }
    std::int64_t lanes() const { return lanes_; }
    /// Entries of a column of the matrix or the block.
    std::int64_t rows() const { return rows_; }

    double& matrix(std::int64_t lane, std::int64_t a, std::int64_t b) {
        return matrix_[index(a * rows_ + b, lane)];
    }

    /// Whether the iteration found the eigenvectors of a lane and proved that they are the leading
    /// ones. If not, another method is needed.
    bool found(std::int64_t lane) const { return values_[index(shape_.count, lane)] > 0; }
    /// Eigenvalue l, descending.
    double value(std::int64_t lane, std::int64_t l) const { return values_[index(l, lane)]; }
    /// An entry of eigenvector l.
    double vector(std::int64_t lane, std::int64_t l, std::int64_t row) const {
        return vectors_[index(l * rows_ + row, lane)];
    }

    BlockIteration iteration();

  private:
    std::size_t index(std::int64_t entry, std::int64_t lane) const {
        return static_cast<std::size_t>(entry * lanes_ + lane);
    }

    Shape shape_;
    std::int64_t rows_;    ///< size, rounded up to whole tiles of the product
    std::int64_t columns_; ///< columns, rounded up likewise
    Simd simd_;
    std::int64_t lanes_;
    AlignedVector<double> matrix_, block_, product_;
    AlignedVector<double> small_; ///< Ritz values and two matrices of order `columns`
    AlignedVector<double> values_, vectors_;
    AlignedVector<double> start_; ///< the initial block of all lanes, as numbers
};

} // namespace stltsa::ltsa
