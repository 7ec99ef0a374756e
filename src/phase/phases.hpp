// SPDX-License-Identifier: BSD-3-Clause
// The phase of every row of a motion that repeats.
#pragma once

#include <span>
#include <vector>

#include "motion/cycles/registration.hpp"

namespace stltsa::phase {

using motion::Loop;
using motion::MeanCycle;
using motion::Range;
using motion::Run;

/// Mean squared distance from the mean cycle, as a share of the variance, above which the phase is
/// linear in time: 0.1 is usual; a column that drifts gives 0.57, zeros for gaps 0.9.
inline constexpr double most_residual = 0.4;

/// Borders of cycles back to back, in rows, not rounded: cycle i lasts from border i to i + 1.
using Borders = std::vector<double>;

/// Of one motion. Cycle k of a run goes from phase k to k + 1: the borders lie there on average.
struct Phases {
    MeanCycle mean;
    std::vector<Run> runs; ///< one for each sequence of cycles, from its first to its last border
    bool linear = false;   ///< the mean cycle explains too little: phases are linear in time
    /// Mean squared distance of the rows from the mean cycle, as a share of the variance.
    double residual = 0;
    std::vector<std::vector<double>> distances; ///< of each run: residuals()
    bool cyclic = true; ///< else runs are repetitions with pauses, one turn each
    /// The phase, in [0, 1), at which the body is at the same place in every recording, wherever
    /// its cycles begin; 0 of repetitions.
    double zero = 0;
};

/// Phases of the rows within the cycles. `rows`: features, not smoothed, finite; `rate`: rows per
/// second. `side`: one weight for each column, whose weighted sum shows which side of the body is
/// forward; empty: unknown. Sequences have a cycle of at least four rows each, and lie within the
/// rows.
Phases find_phases(ConstMatrixView rows, double rate, std::span<const Borders> sequences,
                   std::span<const double> side);

/// The same of an action that is repeated with pauses: each sequence is one repetition, from phase
/// 0 to 1.
Phases find_phases_of_repetitions(ConstMatrixView rows, double rate,
                                  std::span<const Borders> repetitions);

} // namespace stltsa::phase
