// SPDX-License-Identifier: BSD-3-Clause
// Leading singular vectors of matrices whose columns differ much in size, by LAPACK.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa {

/// A factorization with pivoting by size, then Jacobi's method from one side on its triangle: the
/// error of a vector depends on the matrix with its columns made alike, not on their sizes. See Z.
/// Drmac and K. Veselic, "New fast and accurate Jacobi SVD algorithm", SIAM J. Matrix Anal. Appl.
/// 29 (2008). Keeps its workspace.
class GradedSvd {
  public:
    /// For rows x cols matrices, `count` vectors (at most the smaller of both).
    GradedSvd(std::int64_t rows, std::int64_t cols, std::int64_t count);

    /// Where to put the matrix, by columns; solve() destroys it.
    double* matrix() { return matrix_.data(); }
    /// False where Jacobi's method did not converge.
    bool solve();

    /// Valid after solve(): singular value 0 is the largest, to it belongs the left singular vector
    /// of `rows` entries.
    double value(std::int64_t l) const { return values_[static_cast<std::size_t>(l)]; }
    const double* vector(std::int64_t l) const { return vectors_.data() + l * rows_; }

  private:
    std::int32_t rows_, cols_, rank_, count_;
    AlignedVector<double> matrix_, scales_, triangle_, rotations_, values_, vectors_, work_;
    std::vector<std::int32_t> pivots_;
};

} // namespace stltsa
