// SPDX-License-Identifier: BSD-3-Clause
// Solves sparse symmetric systems with SuiteSparse: CHOLMOD, or LDL in builds without it (build
// option sparse).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa {

/// The lower triangle of a symmetric matrix by columns: rows ascending within each.
struct SparseColumns {
    std::int64_t order = 0;
    std::vector<std::int64_t> begin; ///< order + 1
    std::vector<std::int64_t> rows;
    std::vector<double> values;
};

class SparseFactor;

class SparseCholesky {
  public:
    /// Orders (AMD) and factors the matrix. If it is singular to working precision, a tiny shift is
    /// added first. Throws Status::degenerate.
    explicit SparseCholesky(SparseColumns matrix);
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) = delete;

    /// x := A^-1 x for each row x. One thread at a time, because the workspace is shared.
    void solve(MatrixView rows) const;

  private:
    std::unique_ptr<SparseFactor> factor_;
};

} // namespace stltsa
