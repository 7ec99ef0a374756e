// SPDX-License-Identifier: BSD-3-Clause
// The usual period of a motion, from which fits choose their neighbors.
#pragma once

#include "linalg/matrix.hpp"
#include "motion/period/period_track.hpp"

namespace stltsa::motion {

struct Period {
    double samples = 0; ///< 0: none found
    double quality = 0; ///< median match along the stretch, at most 1; 0 without a period
};

/// The lag, near the median period of the best stretch, at which the velocities match best. The
/// best stretch has the largest product of length and match. Reports progress as the first half of
/// the stage "neighbors".
Period find_period(ConstMatrixView samples, double fps, const PeriodRange& range);

} // namespace stltsa::motion
