// SPDX-License-Identifier: BSD-3-Clause
// Registration: the phase of each row is where it lies on the mean cycle. Mean cycle and phases are
// improved in turns, beginning with linear time.
#pragma once

#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "motion/cycles/loop.hpp"
#include "motion/cycles/pose_and_velocity.hpp"

namespace stltsa::motion {

/// Steps of the phase vary smoothly over this share of a cycle; from 0.02 to 0.06 events scatter
/// alike, below it poses alone follow slow drift.
inline constexpr double smooth_share = 0.04;

/// Each round of a registration moves the phases about a tenth as far as the one before: after one
/// that moves none by this share of a cycle, what is left is 0.03 ms of a stride.
inline constexpr double nearly_settled = 3e-4;

struct MeanCycle {
    Loop loop;           ///< of pose_and_velocity(), 2 x features columns
    double period = 0;   ///< rows, median of the cycles
    double variance = 0; ///< of the rows it was learned from, summed over the columns
};

struct Registration {
    MeanCycle mean;
    std::vector<Run> runs; ///< strictly rising; shifted, but not reordered
};

/// Registers runs of whole cycles with each other. `runs`: linear time between the borders of
/// cycles; each has at least four rows. `rows`: pose_and_velocity(). After it, over whole turns,
/// the mean share of time at each phase is uniform, so that phases of several clips compare.
/// `smooth`: see smooth_share. `settled`: rounds end after one that moves no phase by so much.
Registration register_runs(ConstMatrixView rows, std::vector<Run> runs, double period,
                           double smooth = smooth_share, double settled = 0);

/// Registers one run with a known mean cycle. Steps of the phase are at least `slowest` of the
/// mean.
Run register_with(ConstMatrixView rows, const MeanCycle& mean, Run run, double slowest,
                  double smooth = smooth_share);

/// The run, continued to rows [within.begin, within.end) a quarter of a cycle at a time. Steps are
/// slower and faster there than within cycles, and columns that are far from the mean cycle have
/// little weight.
Run grown(ConstMatrixView rows, const MeanCycle& mean, const Run& run, Range within);

/// The same without registration, at the rate of the last quarter of a cycle.
Run continued(const Run& run, double period, Range within);

/// Distance of each row of the run from the mean cycle, as a share of its root mean square
/// deviation.
std::vector<double> residuals(ConstMatrixView rows, const MeanCycle& mean, const Run& run);

/// A shift of phase, and the correlation of two mean cycles that it gives, each less its mean.
struct Offset {
    double shift = 0; ///< phase of the second that looks like phase 0 of the first, in [0, 1)
    double likeness = 0;
};
Offset offset_between(const Loop& first, const Loop& second);

} // namespace stltsa::motion
