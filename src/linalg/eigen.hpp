// SPDX-License-Identifier: BSD-3-Clause
// Dense symmetric eigenproblems by LAPACK.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa {

/// The largest eigenpairs of symmetric matrices of one size, with a workspace that is reused.
class TopEigenpairs {
  public:
    /// For order x order matrices, `count` pairs (1 <= count <= order).
    TopEigenpairs(std::int64_t order, std::int64_t count);

    /// The matrix, to be filled: the lower triangle by columns. Solving does not change it.
    double* matrix() { return matrix_.data(); }
    void solve();
    /// All eigenvalues without vectors: a sixth of the time at order 36.
    void solve_values();

    /// Pair 0 is the largest. value() is valid after solve() and, if `count` is the order, after
    /// solve_values(); vector() after solve().
    double value(std::int64_t pair) const;
    const double* vector(std::int64_t pair) const;

  private:
    bool solve_largest();
    void solve_all();

    std::int32_t order_;
    std::int32_t count_;
    AlignedVector<double> matrix_, values_, vectors_, work_;
    Matrix scratch_; ///< copy that LAPACK destroys
    std::vector<std::int32_t> support_, integer_work_;
};

/// Writes all eigenvalues, ascending, to `values` and replaces the symmetric `matrix` by its
/// eigenvectors, one per row.
void symmetric_eigen(Matrix& matrix, std::vector<double>& values);

} // namespace stltsa
