// SPDX-License-Identifier: BSD-3-Clause
// Panels: several vectors side by side. Row i of a panel holds entry i of each vector, so that an
// operation on all of them reads memory once and fills packs. Unused columns are zero.
#pragma once

#include <algorithm>
#include <cstdint>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

/// Columns of a panel of `count` vectors: a multiple of the widest pack.
constexpr std::int64_t panel_width(std::int64_t count) {
    constexpr std::int64_t pack = simd_width(Simd::avx2);
    return (count + pack - 1) / pack * pack;
}

namespace detail {

template <class Kernel>
struct ColumnWise {
    const Kernel& kernel;
    std::int64_t cols;

    template <int W>
    STLTSA_INLINE void run() const {
        if (cols == 1)
            kernel.template columns<double>(0);
        else
            for (std::int64_t c = 0; c < cols; c += W)
                kernel.template columns<Pack<W>>(c);
    }
};

} // namespace detail

/// Calls kernel.columns<P>(c) for each pack P of columns from c on, or with P = double for a single
/// column; columns() is STLTSA_INLINE.
template <class Kernel>
void run_columns(std::int64_t cols, Simd simd, const Kernel& kernel) {
    run_simd(simd, detail::ColumnWise<Kernel>{kernel, cols});
}

template <class P>
STLTSA_INLINE P& pack_at(double* entry) {
    return *reinterpret_cast<P*>(entry);
}
template <class P>
STLTSA_INLINE const P& pack_at(const double* entry) {
    return *reinterpret_cast<const P*>(entry);
}

/// panel := 0
void clear(MatrixView panel, const Machine& machine);

/// Inner products of each column of a with each of b.
Matrix inner_products(ConstMatrixView a, ConstMatrixView b, const Machine& machine);

/// left^T residual and residual^T residual, with residual = right - left * factor never stored.
struct ResidualProducts {
    Matrix left, residual;
};
ResidualProducts residual_products(ConstMatrixView left, const Matrix& factor,
                                   ConstMatrixView right, const Machine& machine);

/// The first `count` columns as rows.
Matrix rows_of(ConstMatrixView panel, std::int64_t count, const Machine& machine);

/// Writes rows as columns; further columns become zero.
void set_columns(const Matrix& rows, MatrixView panel, const Machine& machine);

/// panel := panel * factor
void multiply_columns(MatrixView panel, const Matrix& factor, const Machine& machine);

/// target -= source * diag(factors)
void subtract_scaled(ConstMatrixView source, const Matrix& factors, MatrixView target,
                     const Machine& machine);

/// The mean of each column, as one row.
Matrix column_means(ConstMatrixView panel, const Machine& machine);

/// sums(r) := sign * the sum of panel(0) - shift, .. panel(r) - shift
void running_sums(ConstMatrixView panel, double sign, const Matrix& shift, MatrixView sums,
                  const Machine& machine);

/// Subtracts `row` from each row.
void subtract_row(MatrixView panel, const Matrix& row, const Machine& machine);

/// Subtracts its mean from each column.
void center(MatrixView panel, const Machine& machine);

} // namespace stltsa
