// SPDX-License-Identifier: BSD-3-Clause
// Motion units from margins and rests; they cover all samples without gap or overlap.
#pragma once

#include <span>
#include <vector>

#include "motion/activity.hpp"
#include "motion/decompose.hpp"

namespace stltsa::motion {

/// How much to smooth the samples for the speed that borders beside cycles are read off: sigma in
/// samples.
double border_smoothing(double period, double fps);

/// The five units of cyclic motion, without those that are absent: preparing and wind-up where the
/// body stands next to the run of margins, initial and final up to and from there. Beyond, where it
/// moves again, are actions.
std::vector<Unit> cyclic_units(const std::vector<double>& run, std::span<const double> speed,
                               double period);

/// Actions, with the rests between them: preparing, and wind-up at the end of the clip.
std::vector<Unit> action_units(const Activity& activity, double fps);

} // namespace stltsa::motion
