// SPDX-License-Identifier: BSD-3-Clause
// Symmetric matrices of a wide band, stored as dense blocks of columns for BLAS, and their Cholesky
// factor.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa {

/// Columns in groups of `block_columns`. A group holds, column after column, the rows from its
/// first diagonal entry to the farthest row that one of its columns reaches; what lies above the
/// diagonal is not read.
class BlockEnvelopeMatrix {
  public:
    static constexpr std::int64_t block_columns = 32;

    /// reach[j]: the last row of column j; does not decrease.
    /// The entries have no value until clear() sets them to zero.
    explicit BlockEnvelopeMatrix(const std::vector<std::int64_t>& reach);

    struct Block {
        std::int64_t begin;   ///< first column, and first row
        std::int64_t columns; ///< at most block_columns
        std::int64_t rows;
        std::int64_t offset;
    };

    std::int64_t order() const { return order_; }
    const std::vector<Block>& blocks() const { return blocks_; }
    /// Entry (row, column) of the block that holds the column is at
    /// data(block)[(column - begin) * rows + row - begin].
    double* data(const Block& block) { return entries_.data() + block.offset; }
    const double* data(const Block& block) const { return entries_.data() + block.offset; }
    void clear(const Block& block) { std::fill_n(data(block), block.columns * block.rows, 0.0); }
    double& diagonal(std::int64_t j) {
        const Block& block = blocks_[static_cast<std::size_t>(j / block_columns)];
        return data(block)[(j - block.begin) * (block.rows + 1)];
    }

  private:
    std::int64_t order_;
    std::vector<Block> blocks_;
    UnsetVector<double> entries_;
};

/// L L^T = matrix, in place; false, with the matrix destroyed, where a pivot is at or below
/// `smallest` times its diagonal entry: the matrix is singular to working precision.
bool cholesky(BlockEnvelopeMatrix& matrix, double smallest);

/// x := (L L^T)^-1 x for one column or a panel of them.
void cholesky_solve(const BlockEnvelopeMatrix& factor, MatrixView x);

} // namespace stltsa
