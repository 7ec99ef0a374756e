// SPDX-License-Identifier: BSD-3-Clause
// Symmetric matrices stored as the envelope of their lower triangle, and their Cholesky factor.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

/// Column j holds rows j .. reach[j], adjacent in memory. reach does not decrease, so a Cholesky
/// factor fits in the same envelope.
class EnvelopeMatrix {
  public:
    /// The entries have no value until clear() sets them to zero.
    explicit EnvelopeMatrix(const std::vector<std::int64_t>& reach);
    /// Zeros for the columns [begin, end).
    void clear(std::int64_t begin, std::int64_t end);

    std::int64_t order() const { return static_cast<std::int64_t>(offset_.size()) - 1; }
    std::int64_t reach(std::int64_t column) const {
        const auto c = static_cast<std::size_t>(column);
        return column + offset_[c + 1] - offset_[c] - 1;
    }
    /// Entries that are stored.
    std::int64_t entries() const { return static_cast<std::int64_t>(entries_.size()); }
    /// First entry of a column: the diagonal.
    double* column(std::int64_t j) {
        return entries_.data() + offset_[static_cast<std::size_t>(j)];
    }
    const double* column(std::int64_t j) const {
        return entries_.data() + offset_[static_cast<std::size_t>(j)];
    }

  private:
    std::vector<std::int64_t> offset_; ///< of each column, then of the end
    UnsetVector<double> entries_;
};

/// Factors the matrix in place from both ends at once, so that there is always work for two: the
/// upper half is eliminated downwards (L L^T), the lower half upwards (L^T L), and the rows in the
/// middle that both have reached at last. The reciprocals of the diagonal are in its place. False,
/// with the matrix destroyed, where a pivot is at or below `smallest` times its diagonal entry: the
/// matrix is singular to working precision.
bool cholesky(EnvelopeMatrix& matrix, double smallest, const Machine& machine);

/// x := matrix^-1 x for one column or a panel of them.
void cholesky_solve(const EnvelopeMatrix& factor, MatrixView x, const Machine& machine);

} // namespace stltsa
