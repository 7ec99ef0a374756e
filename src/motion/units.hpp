// SPDX-License-Identifier: BSD-3-Clause
// Motion units (paper, section 3.1) from margins and rests, without gap or overlap.
#pragma once

#include <span>
#include <vector>

#include "motion/activity.hpp"
#include "motion/decomposition.hpp"

namespace stltsa::motion {

/// Sigma, in samples, for smoothing the speed that decides where standing next to cycles ends.
double border_smoothing(double period, double fps);

/// The units of cyclic motion that are present. The cyclic unit M_c extends from the first margin
/// to the last. The preparing unit M_p and the wind-up unit M_w are where the body stands before
/// and after it; the initial unit M_i and the final unit M_f lie between these and the cyclic unit.
/// Motion within M_p or M_w is an action.
std::vector<Unit> cyclic_units(const std::vector<double>& margins, std::span<const double> speed,
                               double period);

/// Units without cycles: actions, and the rests between them as preparing units, or as the wind-up
/// unit at the end of the clip.
std::vector<Unit> action_units(const Activity& activity, double fps);

} // namespace stltsa::motion
