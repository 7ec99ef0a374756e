// SPDX-License-Identifier: BSD-3-Clause
// Vectors that are constant over runs of adjacent rows, as multigrid methods aggregate unknowns.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

/// Q, of orthonormal columns: column r is 1 / sqrt(length) on the rows of run r, 0 elsewhere.
class Aggregation {
  public:
    /// Runs of `length` rows, the last one of what is left.
    Aggregation(std::int64_t rows, std::int64_t length)
        : rows_(rows), length_(length), runs_((rows + length - 1) / length),
          entry_(1 / std::sqrt(static_cast<double>(length))),
          last_entry_(1 / std::sqrt(static_cast<double>(rows - (runs_ - 1) * length))) {}

    std::int64_t rows() const { return rows_; }
    std::int64_t runs() const { return runs_; }
    /// The first row of a run; of the one after the last run, the end.
    std::int64_t begin(std::int64_t run) const { return std::min(run * length_, rows_); }
    /// The entries of Q in a run.
    double entry(std::int64_t run) const { return run + 1 < runs_ ? entry_ : last_entry_; }
    /// The sum of these.
    double weight(std::int64_t run) const {
        return static_cast<double>(begin(run + 1) - begin(run)) * entry(run);
    }

    /// panel := Q coarse
    void spread(ConstMatrixView coarse, MatrixView panel, const Machine& machine) const;
    /// The norm of what a column of a panel has beyond its means over runs: (I - Q Q^T) x.
    double variation_within(ConstMatrixView panel, std::int64_t column,
                            const Machine& machine) const;

  private:
    /// work(block, run) for each run, many in a block.
    template <class Work>
    void for_runs(const Machine& machine, const Work& work) const;

    std::int64_t rows_, length_, runs_;
    double entry_, last_entry_;
};

} // namespace stltsa
