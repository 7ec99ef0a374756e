// SPDX-License-Identifier: BSD-3-Clause
// Decides whether a repeated cycle turns the body or only ends at another phase of its sway.
#pragma once

#include "synthesis/cuts.hpp"

namespace stltsa::synthesis {

/// Spurious turn of each repetition about the up axis, in radians; 0 if the turn is real. A turn is
/// spurious if it is smaller than the heading's swing within the repetition (after subtracting the
/// steady turn), and if ranges of the same length that begin up to one repetition earlier or later
/// turn both left and right.
double stray_turn(const Body& body, const Track& track, const Cut& cut);

} // namespace stltsa::synthesis
