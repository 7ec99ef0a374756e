// SPDX-License-Identifier: BSD-3-Clause
// Running sums of panels whose rows are, or become, means and slopes of runs of rows: what is
// straight on a run is summed without being written out. S is the running sum, (S z)(c) = z(0) + ..
// + z(c - 1), and C takes off the mean.
#pragma once

#include "linalg/aggregation.hpp"
#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

/// x := Q^T C S z: a row for each column of Q; z has one row less than all runs together.
void centered_prefix_sums(ConstMatrixView z, const Aggregation& runs, MatrixView x,
                          const Machine& machine);

/// z := S^T C Q x, the other way round.
void centered_suffix_sums(const Aggregation& runs, ConstMatrixView x, MatrixView z,
                          const Machine& machine);

} // namespace stltsa
