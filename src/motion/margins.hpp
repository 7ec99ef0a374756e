// SPDX-License-Identifier: BSD-3-Clause
// Where cycles may begin and end (paper, section 3.1): between each peak and valley of the curve
// the point whose second difference is closest to 0, taken as the steepest point of a smooth
// curve, since flat stretches and noise have such points everywhere.
#pragma once

#include <span>
#include <vector>

#include "motion/activity.hpp"

namespace stltsa::motion {

struct Margin {
    double at = 0;    ///< samples
    double swing = 0; ///< height from the extremum before to the one after; 0: not usable
    double steepness = 0;
    bool rising = false;
    bool from_rest = false; ///< nothing moves at the extremum before
    bool to_rest = false;   ///< nor at the one after
};

/// One margin for each pair of neighboring extrema of the smoothed curve. Unusable ones (at the
/// very end of the curve, or where nothing moves) have no swing.
std::vector<Margin> find_margins(std::span<const double> curve, const Activity& activity);

/// Positions of the longest run of margins that are alike and that repeat after one `period`,
/// without the half swing from standing into the first step, or from the last one to standing.
std::vector<double> longest_run(const std::vector<Margin>& margins, double period);

} // namespace stltsa::motion
