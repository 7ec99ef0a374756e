// SPDX-License-Identifier: BSD-3-Clause
// A clip that was cut to one cycle, to be played in a loop.
#pragma once

#include <optional>

#include "motion/cycles/stretch_cycles.hpp"

namespace stltsa::motion {

/// The whole recording as one cycle if it ends where it begins, in the same motion, one row
/// earlier: its own length is the lag after which it repeats.
std::optional<CyclicStretch> closed_cycle(const Signal& signal, const PeriodRange& periods);

} // namespace stltsa::motion
