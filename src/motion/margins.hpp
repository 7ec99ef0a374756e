// SPDX-License-Identifier: BSD-3-Clause
// Candidates for the margins of cycles (paper, section 3.1): between each peak and valley of the
// curve, the point where the second difference f''_y(t) is closest to 0. This is the steepest point
// of the smoothed curve; second differences near 0 also occur wherever it is flat or noisy.
#pragma once

#include <span>
#include <vector>

#include "motion/activity.hpp"

namespace stltsa::motion {

struct Margin {
    double at = 0;    ///< samples
    double swing = 0; ///< height from the previous extremum to the next; 0: not usable
    double steepness = 0;
    bool rising = false;
    bool from_rest = false; ///< nothing moves at the previous extremum
    bool to_rest = false;   ///< nothing moves at the next extremum
    bool cut = false;       ///< the clip starts or ends, in motion, before an extremum
};

/// One margin for each pair of neighboring extrema of the smoothed curve. Margins at the very end
/// of the curve, or where nothing moves, are not usable.
std::vector<Margin> find_margins(std::span<const double> curve, const Activity& activity);

/// Positions of the margins in the longest sequence of similar swings that repeat after one
/// `period`, without the half swings between standing and the first or last step.
std::vector<double> longest_sequence(const std::vector<Margin>& margins, double period);

} // namespace stltsa::motion
