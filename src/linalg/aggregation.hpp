// SPDX-License-Identifier: BSD-3-Clause
// Vectors that are straight over runs of adjacent rows, as multigrid methods aggregate unknowns.
#pragma once

#include <algorithm>
#include <cstdint>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

/// Q, of orthonormal columns: for each run the mean of its rows, then their slope, each scaled to
/// norm 1 and 0 outside the run. Where all runs are of one row there are no slopes, and Q is the
/// identity; where only the last one is, the column of its slope is 0.
class Aggregation {
  public:
    /// Runs of `length` rows, the last one of what is left.
    Aggregation(std::int64_t rows, std::int64_t length)
        : rows_(rows), length_(length), runs_((rows + length - 1) / length),
          entries_(entries_of(length)), last_entries_(entries_of(rows - (runs_ - 1) * length)) {}

    std::int64_t rows() const { return rows_; }
    std::int64_t runs() const { return runs_; }
    /// Columns of Q for each run.
    std::int64_t terms() const { return length_ == 1 ? 1 : 2; }
    std::int64_t columns() const { return runs_ * terms(); }
    /// The first row of a run; of the one after the last run, the end.
    std::int64_t begin(std::int64_t run) const { return std::min(run * length_, rows_); }
    /// The entries of Q in row i of a run: the mean's are all the same, the slope's are `slope`
    /// times (i - begin(run) - middle).
    struct Entries {
        double mean, slope, middle;
    };
    const Entries& entries(std::int64_t run) const {
        return run + 1 < runs_ ? entries_ : last_entries_;
    }

    /// work(block, begin, end) for each block of runs: those that begin within as many rows as a
    /// block has, so none where runs are longer.
    template <class Work>
    void for_blocks(const Machine& machine, const Work& work) const {
        for_row_blocks(rows_, machine,
                       [&](std::int64_t block, std::int64_t first, std::int64_t count) {
                           work(block, run_from(first), run_from(first + count));
                       });
    }
    std::int64_t blocks() const { return row_blocks(rows_); }

    /// panel := Q coarse
    void spread(ConstMatrixView coarse, MatrixView panel, const Machine& machine) const;
    /// The norm of what a column of a panel has that Q does not: (I - Q Q^T) x.
    double variation_within(ConstMatrixView panel, std::int64_t column,
                            const Machine& machine) const;

  private:
    static Entries entries_of(std::int64_t length);
    /// The first run that begins at this row or after it.
    std::int64_t run_from(std::int64_t row) const { return (row + length_ - 1) / length_; }

    std::int64_t rows_, length_, runs_;
    Entries entries_, last_entries_;
};

} // namespace stltsa
