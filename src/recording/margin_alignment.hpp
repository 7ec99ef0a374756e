// SPDX-License-Identifier: BSD-3-Clause
// Margins at the same posture in every cycle. The steepest points of the coordinate (paper, section
// 3.1) are not, because the coordinate drifts.
#pragma once

#include "base/progress.hpp"
#include "recording/stretch_cycles.hpp"

namespace stltsa::recording {

/// Moves the margins of each sequence: those at even indices until the movement around each is as
/// similar as possible to that around the others, and so those at odd indices. On average they stay
/// where they are, unless one would leave the rows from `begin` to `end`. They stay in order; a
/// margin that ends one sequence and begins the next remains one. Cycles are not changed.
void align_margins(const Signal& signal, double begin, double end, const Progress& progress,
                   std::vector<CyclicStretch>& stretches);

} // namespace stltsa::recording
