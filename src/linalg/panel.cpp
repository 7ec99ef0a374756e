// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/panel.hpp"

#include <algorithm>
#include <vector>

namespace stltsa {
namespace {

struct InnerProducts {
    ConstMatrixView a, b;
    MatrixView out;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        for (std::int64_t row = 0; row < a.rows; ++row) {
            const P right = pack_at<P>(b.row(row) + c);
            for (std::int64_t p = 0; p < a.cols; ++p)
                pack_at<P>(out.row(p) + c) += a(row, p) * right;
        }
    }
};

struct ColumnProduct {
    MatrixView panel;
    ConstMatrixView factor;
    double* row_before;

    template <int W>
    STLTSA_INLINE void run() const {
        for (std::int64_t row = 0; row < panel.rows; ++row) {
            std::copy_n(panel.row(row), panel.cols, row_before);
            for (std::int64_t c = 0; c < panel.cols; c += W) {
                Pack<W> sum{};
                for (std::int64_t p = 0; p < panel.cols; ++p)
                    sum += row_before[p] * pack_at<Pack<W>>(factor.row(p) + c);
                pack_at<Pack<W>>(panel.row(row) + c) = sum;
            }
        }
    }
};

/// out := right - left * factor
struct Residual {
    ConstMatrixView left, factor, right;
    MatrixView out;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        for (std::int64_t row = 0; row < out.rows; ++row) {
            P value = pack_at<P>(right.row(row) + c);
            for (std::int64_t p = 0; p < left.cols; ++p)
                value -= left(row, p) * pack_at<P>(factor.row(p) + c);
            pack_at<P>(out.row(row) + c) = value;
        }
    }
};

/// sums(0, .) := the sum of the rows
struct Sum {
    ConstMatrixView rows;
    MatrixView sums;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        P sum{};
        for (std::int64_t row = 0; row < rows.rows; ++row)
            sum += pack_at<P>(rows.row(row) + c);
        pack_at<P>(sums.data + c) = sum;
    }
};

/// rows(r) -= subtrahend
struct Subtraction {
    MatrixView rows;
    const double* subtrahend;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        const P value = pack_at<P>(subtrahend + c);
        for (std::int64_t row = 0; row < rows.rows; ++row)
            pack_at<P>(rows.row(row) + c) -= value;
    }
};

/// sums(r) := start + sign * the sum of rows(0) - shift, .. rows(r) - shift
struct RunningSums {
    ConstMatrixView rows;
    double sign;
    const double *shift, *start;
    MatrixView sums;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        P sum{};
        const P offset = pack_at<P>(shift + c), before = pack_at<P>(start + c);
        for (std::int64_t row = 0; row < rows.rows; ++row) {
            sum += sign * (pack_at<P>(rows.row(row) + c) - offset);
            pack_at<P>(sums.row(row) + c) = before + sum;
        }
    }
};

/// The sum of each block of rows, one row per block.
Matrix block_sums(ConstMatrixView panel, const Machine& machine) {
    Matrix sums(row_blocks(panel.rows), panel.cols);
    for_row_blocks(panel.rows, machine,
                   [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
                       run_columns(panel.cols, machine.simd,
                                   Sum{panel.block(first, rows), sums.view().block(block, 1)});
                   });
    return sums;
}

} // namespace

void clear(MatrixView panel, const Machine& machine) {
    for_row_blocks(panel.rows, machine, [&](std::int64_t, std::int64_t first, std::int64_t rows) {
        for (std::int64_t row = first; row < first + rows; ++row)
            std::fill_n(panel.row(row), panel.cols, 0.0);
    });
}

Matrix inner_products(ConstMatrixView a, ConstMatrixView b, const Machine& machine) {
    Matrix block_products(row_blocks(a.rows) * a.cols, b.cols);
    for_row_blocks(a.rows, machine, [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
        run_columns(b.cols, machine.simd,
                    InnerProducts{a.block(first, rows), b.block(first, rows),
                                  block_products.view().block(block * a.cols, a.cols)});
    });
    Matrix sum(a.cols, b.cols);
    for (std::int64_t row = 0; row < block_products.rows(); ++row)
        for (std::int64_t c = 0; c < b.cols; ++c)
            sum(row % a.cols, c) += block_products(row, c);
    return sum;
}

ResidualProducts residual_products(ConstMatrixView left, const Matrix& factor,
                                   ConstMatrixView right, const Machine& machine) {
    const std::int64_t cols = right.cols;
    Matrix block_products(row_blocks(right.rows) * 2 * cols, cols);
    for_row_blocks(
        right.rows, machine, [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
            Matrix residual(rows, cols);
            run_columns(cols, machine.simd,
                        Residual{left.block(first, rows), factor.view(), right.block(first, rows),
                                 residual.view()});
            const MatrixView out = block_products.view().block(2 * block * cols, 2 * cols);
            run_columns(
                cols, machine.simd,
                InnerProducts{left.block(first, rows), residual.view(), out.block(0, cols)});
            run_columns(cols, machine.simd,
                        InnerProducts{residual.view(), residual.view(), out.block(cols, cols)});
        });
    ResidualProducts products{Matrix(cols, cols), Matrix(cols, cols)};
    for (std::int64_t row = 0; row < block_products.rows(); ++row) {
        Matrix& sum = row / cols % 2 == 0 ? products.left : products.residual;
        for (std::int64_t c = 0; c < cols; ++c)
            sum(row % cols, c) += block_products(row, c);
    }
    return products;
}

Matrix rows_of(ConstMatrixView panel, std::int64_t count, const Machine& machine) {
    Matrix rows = Matrix::unset(count, panel.rows);
    for_row_blocks(panel.rows, machine, [&](std::int64_t, std::int64_t first, std::int64_t block) {
        for (std::int64_t j = 0; j < count; ++j)
            for (std::int64_t i = first; i < first + block; ++i)
                rows(j, i) = panel(i, j);
    });
    return rows;
}

void set_columns(const Matrix& rows, MatrixView panel, const Machine& machine) {
    for_row_blocks(panel.rows, machine, [&](std::int64_t, std::int64_t first, std::int64_t block) {
        for (std::int64_t i = first; i < first + block; ++i)
            for (std::int64_t j = 0; j < panel.cols; ++j)
                panel(i, j) = j < rows.rows() ? rows(j, i) : 0;
    });
}

void multiply_columns(MatrixView panel, const Matrix& factor, const Machine& machine) {
    for_row_blocks(panel.rows, machine, [&](std::int64_t, std::int64_t first, std::int64_t rows) {
        AlignedVector<double> row(static_cast<std::size_t>(panel.cols));
        run_simd(machine.simd, ColumnProduct{panel.block(first, rows), factor.view(), row.data()});
    });
}

void subtract_scaled(ConstMatrixView source, const Matrix& factors, MatrixView target,
                     const Machine& machine) {
    for_row_blocks(source.rows, machine, [&](std::int64_t, std::int64_t first, std::int64_t rows) {
        for (std::int64_t row = first; row < first + rows; ++row)
            for (std::int64_t c = 0; c < source.cols; ++c)
                target(row, c) -= factors(0, c) * source(row, c);
    });
}

Matrix column_means(ConstMatrixView panel, const Machine& machine) {
    const Matrix sums = block_sums(panel, machine);
    Matrix mean(1, panel.cols);
    for (std::int64_t block = 0; block < sums.rows(); ++block)
        for (std::int64_t c = 0; c < panel.cols; ++c)
            mean(0, c) += sums(block, c);
    for (std::int64_t c = 0; c < panel.cols; ++c)
        mean(0, c) /= static_cast<double>(panel.rows);
    return mean;
}

void subtract_row(MatrixView panel, const Matrix& row, const Machine& machine) {
    for_row_blocks(panel.rows, machine, [&](std::int64_t, std::int64_t first, std::int64_t rows) {
        run_columns(panel.cols, machine.simd, Subtraction{panel.block(first, rows), row.data()});
    });
}

void center(MatrixView panel, const Machine& machine) {
    subtract_row(panel, column_means(panel, machine), machine);
}

void running_sums(ConstMatrixView panel, double sign, const Matrix& shift, MatrixView sums,
                  const Machine& machine) {
    Matrix starts = block_sums(panel, machine); // replaced by the sums of the previous blocks
    Matrix sum(1, panel.cols);
    for (std::int64_t block = 0; block < starts.rows(); ++block) {
        const std::int64_t rows = std::min(row_block, panel.rows - block * row_block);
        for (std::int64_t c = 0; c < panel.cols; ++c) {
            const double of_block =
                sign * (starts(block, c) - static_cast<double>(rows) * shift(0, c));
            starts(block, c) = sum(0, c);
            sum(0, c) += of_block;
        }
    }
    for_row_blocks(panel.rows, machine,
                   [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
                       run_columns(panel.cols, machine.simd,
                                   RunningSums{panel.block(first, rows), sign, shift.data(),
                                               starts.row(block), sums.block(first, rows)});
                   });
}

} // namespace stltsa
