// SPDX-License-Identifier: BSD-3-Clause
// The phase of every row of a motion that repeats: registered where the period is steadiest, and
// grown from there in both directions for as long as the motion goes on.
#pragma once

#include <vector>

#include "motion/cycles/registration.hpp"
#include "motion/period/period_track.hpp"

namespace stltsa::motion {

struct Growth {
    Run run;                       ///< rows of the signal; rises by 1 per cycle
    MeanCycle mean;                ///< of pose_and_velocity(), velocities at the local tempo
    std::vector<double> deviation; ///< of each row from the mean cycle: square, 1: its variance

    double turns() const { return run.rows() > 1 ? run.phase.back() - run.phase.front() : 0; }
    /// The row at which the phase is reached, interpolated, or extrapolated at most half a row.
    double row_of(double phase) const;
};

/// Grows from `stretch` to at most the rows `within`, which contain it. No rows: too few to
/// register.
Growth grow(const Signal& signal, const Stretch& stretch, Rows within);

} // namespace stltsa::motion
