// SPDX-License-Identifier: BSD-3-Clause
// Which side of the body a cycle begins with. The sign of a coordinate is arbitrary; that of the
// body's motion is the same in every clip of a skeleton.
#pragma once

#include "recording/drafts.hpp"

namespace stltsa::recording {

/// Weighted sums of the velocities at each row, in units of the usual speed: `side` in terms of the
/// samples' columns.
std::vector<double> side_motion(const Signal& signal, const std::vector<double>& side);

/// Begins the cycles of a motion without two like sides at the same half everywhere: that in which
/// the columns rise.
void turn_to_rise(const Signal& signal, CyclicStretch& cut);

/// Whether the two halves of the cycles are alike but for the side.
bool sides_alternate(const std::vector<double>& motion, const CyclicStretch& cut);

/// The side with which each cycle begins: 0 while `motion` is negative, else 1. The cycles are not
/// changed.
std::vector<int> sides_of(const std::vector<double>& motion, const CyclicStretch& cut);

/// Makes the cycles of each regular sequence begin while `motion` is negative, if that leaves one,
/// and gives the side of each cycle: 0, or 1 if they begin while it is positive.
std::vector<int> turn_to_side(const std::vector<double>& motion, CyclicStretch& cut);

} // namespace stltsa::recording
