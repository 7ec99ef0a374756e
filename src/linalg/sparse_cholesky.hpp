// SPDX-License-Identifier: BSD-3-Clause
// Sparse symmetric systems by SuiteSparse CHOLMOD. Only in builds that have it.
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

class SparseCholesky {
  public:
    /// Orders (AMD) and factors. A matrix that is singular to working precision is factored with
    /// a tiny shift. Throws Status::degenerate.
    explicit SparseCholesky(SparseColumns matrix);
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) = delete;

    /// x := A^-1 x for each row x. One thread at a time: the workspace is kept.
    void solve(MatrixView rows) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace stltsa
