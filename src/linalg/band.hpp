// SPDX-License-Identifier: BSD-3-Clause
// Symmetric positive definite band matrices and their Cholesky factor, by LAPACK.
#pragma once

#include <cstdint>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

class BandMatrix {
  public:
    /// Entries (i, j) with |i - j| > reach are zero; the others have no value yet.
    BandMatrix(std::int64_t order, std::int64_t reach);

    std::int64_t order() const { return order_; }
    std::int64_t reach() const { return reach_; }
    /// Entries (j, j), (j + 1, j), .. of the lower triangle: reach() + 1, those of rows beyond the
    /// last one unused.
    double* column(std::int64_t j) { return entries_.data() + j * (reach_ + 1); }

    /// L L^T = matrix, in place; false, with the matrix destroyed, if a pivot is at or below
    /// `smallest` times its diagonal entry: the matrix is singular to working precision.
    bool factor(double smallest);

    /// After factor(): each row x := (L L^T)^-1 x.
    void solve(MatrixView rows, const Machine& machine) const;

  private:
    std::int64_t order_, reach_;
    UnsetVector<double> entries_;
};

} // namespace stltsa
