// SPDX-License-Identifier: BSD-3-Clause
// Dense symmetric eigenproblems by LAPACK.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa {

/// The largest eigenpairs of many symmetric matrices of one size; keeps its workspace.
class TopEigenpairs {
  public:
    /// For order x order matrices, `count` pairs (1 <= count <= order).
    TopEigenpairs(std::int64_t order, std::int64_t count);

    /// Where to put the matrix: the lower triangle by columns; solve() leaves it as it is.
    double* matrix() { return matrix_.data(); }
    void solve();
    /// Eigenvalues only, all of them: a sixth of the time at order 36.
    void solve_values();

    /// Pair 0 is the largest. value() is valid after solve() and, if `count` is the order, after
    /// solve_values(); vector() after solve().
    double value(std::int64_t pair) const;
    const double* vector(std::int64_t pair) const;

  private:
    bool solve_for_the_largest();
    void solve_for_all();

    std::int32_t order_;
    std::int32_t count_;
    AlignedVector<double> matrix_, values_, vectors_, work_;
    Matrix destroyed_; ///< what LAPACK works on
    std::vector<std::int32_t> support_, integer_work_;
};

/// All eigenvalues ascending into `values`; `matrix` (order x order, symmetric) becomes the
/// eigenvectors, one per row.
void symmetric_eigen(Matrix& matrix, std::vector<double>& values);

} // namespace stltsa
