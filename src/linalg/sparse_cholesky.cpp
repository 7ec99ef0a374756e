// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/sparse_cholesky.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "linalg/sparse_factor.hpp"

namespace stltsa {
namespace {

/// Shift of a singular matrix, relative to its largest diagonal entry.
constexpr double tiny_shift = 1e-13;
/// A smaller ratio of pivots means a singular matrix; in exactly singular ones rounding leaves
/// about 1e-16.
constexpr double smallest_ratio = 1e-14;

double largest_diagonal(const SparseColumns& matrix) {
    double largest = 0;
    for (std::int64_t c = 0; c < matrix.order; ++c)
        largest = std::max(
            largest,
            matrix.values[static_cast<std::size_t>(matrix.begin[static_cast<std::size_t>(c)])]);
    return largest;
}

} // namespace

SparseCholesky::SparseCholesky(SparseColumns matrix)
    : factor_(std::make_unique<SparseFactor>(matrix)) {
    if (factor_->factorize(matrix, 0) && factor_->pivot_ratio() > smallest_ratio)
        return;
    if (!factor_->factorize(matrix, tiny_shift * largest_diagonal(matrix)))
        fail(Status::degenerate, "the alignment matrix is singular: the frames vary in too few "
                                 "directions");
}

SparseCholesky::~SparseCholesky() = default;

void SparseCholesky::solve(MatrixView rows) const {
    factor_->solve(rows);
}

} // namespace stltsa
