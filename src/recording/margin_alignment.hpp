// SPDX-License-Identifier: BSD-3-Clause
// Margins at the same posture in every cycle. The steepest points of the coordinate (paper, section
// 3.1) are not, because the coordinate drifts.
#pragma once

#include "recording/stretch_cycles.hpp"

namespace stltsa::recording {

/// Moves every second margin until the movement around it is as similar as possible to that around
/// the others of its kind. On average they stay where they are, and all stay between the rows
/// `begin` and `end`. Margins that are alone of their kind stay. The cycles are not changed.
void align_margins(const Signal& signal, double begin, double end, CyclicStretch& cut);

} // namespace stltsa::recording
