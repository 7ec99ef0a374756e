// SPDX-License-Identifier: BSD-3-Clause
// Symmetric positive definite band matrices and their Cholesky factor, by LAPACK.
#pragma once

#include <cstdint>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

class BandMatrix {
  public:
    /// Entries (i, j) with |i - j| > bandwidth are zero; the others are not initialized.
    BandMatrix(std::int64_t order, std::int64_t bandwidth);

    std::int64_t order() const { return order_; }
    std::int64_t bandwidth() const { return bandwidth_; }
    /// The bandwidth() + 1 entries (j, j), (j + 1, j), .. of the lower triangle; those of rows
    /// beyond the last are unused.
    double* column(std::int64_t j) { return entries_.data() + j * (bandwidth_ + 1); }

    /// Factors L L^T = matrix in place. Returns false and destroys the matrix if a pivot is at most
    /// `smallest` times its diagonal entry, that is, if it is singular to working precision.
    bool factor(double smallest);

    /// After factor(): each row x := (L L^T)^-1 x.
    void solve(MatrixView rows, const Machine& machine) const;

  private:
    std::int64_t order_, bandwidth_;
    UnsetVector<double> entries_;
};

} // namespace stltsa
