// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/block_envelope.hpp"

#include <algorithm>

#include <cblas.h>
#include <lapacke.h>

namespace stltsa {

BlockEnvelopeMatrix::BlockEnvelopeMatrix(const std::vector<std::int64_t>& reach)
    : order_(static_cast<std::int64_t>(reach.size())) {
    std::int64_t total = 0;
    for (std::int64_t begin = 0; begin < order_; begin += block_columns) {
        const std::int64_t columns = std::min(block_columns, order_ - begin);
        const std::int64_t rows = reach[static_cast<std::size_t>(begin + columns - 1)] - begin + 1;
        blocks_.push_back({begin, columns, rows, total});
        total += columns * rows;
    }
    entries_.resize(checked_size(total, 1));
}

namespace {

using Block = BlockEnvelopeMatrix::Block;

int narrow(std::int64_t value) {
    return static_cast<int>(value);
}

/// Takes from `block` what the factored block `before` contributes to it.
void update(BlockEnvelopeMatrix& matrix, const Block& before, const Block& block) {
    const std::int64_t first = block.begin - before.begin;
    const std::int64_t rows = before.rows - first;
    const double* l = matrix.data(before) + first;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, narrow(rows),
                narrow(std::min(block.columns, rows)), narrow(before.columns), -1, l,
                narrow(before.rows), l, narrow(before.rows), 1, matrix.data(block),
                narrow(block.rows));
}

/// The Cholesky factor of the block's upper square, and what it makes of the rows below.
bool factor(double* data, const Block& block, double smallest, const double* diagonal) {
    const int columns = narrow(block.columns);
    const int rows = narrow(block.rows);
    if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', columns, data, rows) != 0)
        return false;
    for (std::int64_t j = 0; j < block.columns; ++j) {
        const double pivot = data[j * (block.rows + 1)];
        if (!(pivot * pivot > smallest * diagonal[j]))
            return false;
    }
    if (rows > columns)
        cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, rows - columns,
                    columns, 1, data, rows, data + columns, rows);
    return true;
}

} // namespace

bool cholesky(BlockEnvelopeMatrix& matrix, double smallest) {
    std::vector<double> diagonal(static_cast<std::size_t>(matrix.order()));
    for (std::int64_t j = 0; j < matrix.order(); ++j)
        diagonal[static_cast<std::size_t>(j)] = matrix.diagonal(j);
    const auto& blocks = matrix.blocks();
    std::size_t first = 0; // that reaches the block
    for (const Block& block : blocks) {
        while (blocks[first].begin + blocks[first].rows <= block.begin)
            ++first;
        for (const Block* before = &blocks[first]; before != &block; ++before)
            update(matrix, *before, block);
        if (!factor(matrix.data(block), block, smallest, diagonal.data() + block.begin))
            return false;
    }
    return true;
}

namespace {

/// Row-major panels of several vectors: their transpose is what BLAS sees.
void solve_panel(const BlockEnvelopeMatrix& factor, MatrixView x) {
    const int width = narrow(x.cols);
    const int stride = narrow(x.stride);
    const auto& blocks = factor.blocks();
    for (const Block& block : blocks) {
        const double* l = factor.data(block);
        const int rows = narrow(block.rows);
        const int columns = narrow(block.columns);
        cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, width, columns,
                    1, l, rows, x.row(block.begin), stride);
        if (rows > columns)
            cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, width, rows - columns, columns, -1,
                        x.row(block.begin), stride, l + columns, rows, 1,
                        x.row(block.begin + block.columns), stride);
    }
    for (auto block = blocks.rbegin(); block != blocks.rend(); ++block) {
        const double* l = factor.data(*block);
        const int rows = narrow(block->rows);
        const int columns = narrow(block->columns);
        if (rows > columns)
            cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, width, columns, rows - columns,
                        -1, x.row(block->begin + block->columns), stride, l + columns, rows, 1,
                        x.row(block->begin), stride);
        cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasNoTrans, CblasNonUnit, width,
                    columns, 1, l, rows, x.row(block->begin), stride);
    }
}

void solve_vector(const BlockEnvelopeMatrix& factor, double* x) {
    const auto& blocks = factor.blocks();
    for (const Block& block : blocks) {
        const double* l = factor.data(block);
        const int rows = narrow(block.rows);
        const int columns = narrow(block.columns);
        double* part = x + block.begin;
        cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, columns, l, rows, part,
                    1);
        cblas_dgemv(CblasColMajor, CblasNoTrans, rows - columns, columns, -1, l + columns, rows,
                    part, 1, 1, part + columns, 1);
    }
    for (auto block = blocks.rbegin(); block != blocks.rend(); ++block) {
        const double* l = factor.data(*block);
        const int rows = narrow(block->rows);
        const int columns = narrow(block->columns);
        double* part = x + block->begin;
        cblas_dgemv(CblasColMajor, CblasTrans, rows - columns, columns, -1, l + columns, rows,
                    part + columns, 1, 1, part, 1);
        cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, columns, l, rows, part, 1);
    }
}

} // namespace

void cholesky_solve(const BlockEnvelopeMatrix& factor, MatrixView x) {
    if (x.cols == 1 && x.stride == 1)
        solve_vector(factor, x.data);
    else
        solve_panel(factor, x);
}

} // namespace stltsa
