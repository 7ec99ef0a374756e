// SPDX-License-Identifier: BSD-3-Clause
// Decides whether there is enough evidence for cycles.
#pragma once

#include <string>
#include <vector>

#include "motion/activity.hpp"
#include "motion/period.hpp"

namespace stltsa::motion {

/// Evidence that a sequence of margins delimits cycles.
struct Evidence {
    Period period;        ///< of the cycles if they are most of the motion, else of the clip
    double cyclicity = 0; ///< of the same samples
    std::size_t margins = 0;
    double cycle = 0; ///< median length of the cycles in samples
};

/// `margins`: from longest_sequence(). `coordinate`: of all samples, not smoothed. `cyclicity` and
/// `period`: of the whole clip.
Evidence weigh(const std::vector<double>& margins, ConstMatrixView samples,
               const Activity& activity, const std::vector<double>& coordinate, double cyclicity,
               const Period& period, double fps, const Progress& progress = {});

/// Why the evidence is not enough, with the numbers; empty if it is.
std::string doubt(const Evidence& evidence, double fps);

} // namespace stltsa::motion
