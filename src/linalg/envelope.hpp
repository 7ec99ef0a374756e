// SPDX-License-Identifier: BSD-3-Clause
// Symmetric matrices of a narrow band, stored as the envelope of their lower triangle, and their
// twisted Cholesky factor: from both ends at once, so that there is always work for two.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

/// Columns of a lower triangle: column j holds rows j .. reach(j), adjacent in memory. reach does
/// not decrease, so a Cholesky factor fits in the same envelope.
class EnvelopeColumns {
  public:
    /// Of each column's first entry among all of them, then of the end.
    using Offsets = UnsetVector<std::int64_t>;

    EnvelopeColumns() : offset_(1, 0) {}
    /// The entries have no value until clear() sets them to zero.
    explicit EnvelopeColumns(Offsets offset);
    /// Zeros for the columns [begin, end).
    void clear(std::int64_t begin, std::int64_t end);

    std::int64_t order() const { return static_cast<std::int64_t>(offset_.size()) - 1; }
    std::int64_t reach(std::int64_t column) const {
        const auto c = static_cast<std::size_t>(column);
        return column + offset_[c + 1] - offset_[c] - 1;
    }
    /// First entry of a column: the diagonal.
    double* column(std::int64_t j) {
        return entries_.data() + offset_[static_cast<std::size_t>(j)];
    }
    const double* column(std::int64_t j) const {
        return entries_.data() + offset_[static_cast<std::size_t>(j)];
    }

  private:
    Offsets offset_;
    UnsetVector<double> entries_;
};

/// The matrix in two arms, one for the thread at each end. Both count from their end and are
/// eliminated in the same way, until only the rows in the middle are left: those that the first arm
/// reaches when half of the rows are its own.
class EnvelopeMatrix {
  public:
    /// From the last row of each column. What the second arm takes off the middle is zero, no other
    /// entry has a value until the columns that an arm has for its rows are cleared.
    EnvelopeMatrix(const std::vector<std::int64_t>& reach, const Machine& machine);

    struct Arm {
        EnvelopeColumns columns;
        /// Its own columns, [0, own), come before those in the middle.
        std::int64_t own;
    };
    std::int64_t order() const { return order_; }
    /// Rows in the middle, [middle_begin(), middle_end()). Their entries are in the first arm; what
    /// the second one takes off them is kept in itself.
    std::int64_t middle_begin() const { return arms_[0].own; }
    std::int64_t middle_end() const { return order_ - arms_[1].own; }
    /// Arm 0 has row i as its row i, arm 1 as its row order() - 1 - i.
    Arm& arm(int index) { return arms_[static_cast<std::size_t>(index)]; }
    const Arm& arm(int index) const { return arms_[static_cast<std::size_t>(index)]; }

    /// An entry of the lower triangle, within the envelope.
    double& entry(std::int64_t row, std::int64_t column) {
        const bool first = row < middle_end();
        return arm(first ? 0 : 1).columns.column(first ? column : order_ - 1 - row)[row - column];
    }

  private:
    std::int64_t order_;
    std::array<Arm, 2> arms_;
};

/// Factors the matrix in place, arm by arm and then in the middle: each as L L^T in its own order
/// of rows. The reciprocals of the diagonal are in its place. False, with the matrix destroyed,
/// where a pivot is at or below `smallest` times its diagonal entry: the matrix is singular to
/// working precision.
bool cholesky(EnvelopeMatrix& matrix, double smallest, const Machine& machine);

/// x := matrix^-1 x for one column or a panel of them.
void cholesky_solve(const EnvelopeMatrix& factor, MatrixView x, const Machine& machine);

} // namespace stltsa
