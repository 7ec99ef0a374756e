// SPDX-License-Identifier: BSD-3-Clause
// The usual period of a motion, from which fits choose their neighbors.
#pragma once

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "motion/period/period_track.hpp"

namespace stltsa::motion {

struct Period {
    double samples = 0; ///< 0: none found
    double quality = 0; ///< match of the velocities one period apart, at most 1; 0 without a period
};

/// The median period of the stretch that repeats longest and best. Reports progress as the first
/// half of the stage "neighbors".
Period find_period(ConstMatrixView samples, double fps, const PeriodRange& range,
                   const Progress& progress = {});

} // namespace stltsa::motion
