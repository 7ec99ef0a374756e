// SPDX-License-Identifier: BSD-3-Clause
// Vectors that are constant over runs of adjacent rows, as multigrid methods aggregate unknowns.
#pragma once

#include <cstdint>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

/// Q, of orthonormal columns: column r is 1 / sqrt(length) on the rows of run r, 0 elsewhere.
class Aggregation {
  public:
    /// Runs of `length` rows, the last one of what is left.
    Aggregation(std::int64_t rows, std::int64_t length) : rows_(rows), length_(length) {}

    std::int64_t rows() const { return rows_; }
    std::int64_t runs() const { return (rows_ + length_ - 1) / length_; }

    /// panel := Q coarse
    void spread(ConstMatrixView coarse, MatrixView panel, const Machine& machine) const;
    /// coarse := Q^T panel
    void gather(ConstMatrixView panel, MatrixView coarse, const Machine& machine) const;
    /// The norm of what a column of a panel has beyond its means over runs: (I - Q Q^T) x.
    double variation_within(ConstMatrixView panel, std::int64_t column,
                            const Machine& machine) const;

  private:
    /// work(block, run, first row, rows) for each run, many in a block.
    template <class Work>
    void for_runs(const Machine& machine, const Work& work) const;

    std::int64_t rows_, length_;
};

} // namespace stltsa
