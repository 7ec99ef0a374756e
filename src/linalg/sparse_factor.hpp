// SPDX-License-Identifier: BSD-3-Clause
// The part of sparse_cholesky that depends on the build: sparse_cholmod.cpp or sparse_ldl.cpp.
#pragma once

#include <memory>

#include "linalg/sparse_cholesky.hpp"

namespace stltsa {

class SparseFactor {
  public:
    /// Computes an ordering for the matrix; keeps no reference to the matrix.
    explicit SparseFactor(SparseColumns& matrix);
    ~SparseFactor();
    SparseFactor(SparseFactor&&) = delete;

    /// Factors the same matrix plus a shift of its diagonal. False if a pivot is not positive. Only
    /// the last call may have a shift other than 0.
    bool factorize(SparseColumns& matrix, double shift);
    /// The smallest pivot relative to the largest, an estimate of 1 / condition.
    double pivot_ratio() const;
    /// x := A^-1 x for each row x.
    void solve(MatrixView rows);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace stltsa
