// SPDX-License-Identifier: BSD-3-Clause
// Whether the numbers justify to speak of cycles.
#pragma once

#include <string>
#include <vector>

#include "motion/activity.hpp"
#include "motion/period.hpp"

namespace stltsa::motion {

/// What speaks for a run of margins being cycles.
struct Evidence {
    Period period;        ///< of the run where it can tell, else of the clip
    double cyclicity = 0; ///< likewise
    std::size_t margins = 0;
    double cycle = 0; ///< median length of the run's cycles in samples
};

/// `coordinate`: of all samples, not smoothed; `cyclicity` and `period`: of the whole clip.
Evidence weigh(const std::vector<double>& run, ConstMatrixView samples, const Activity& activity,
               const std::vector<double>& coordinate, double cyclicity, const Period& period,
               double fps);

/// Why there are no cycles, in words with the numbers; empty where there are.
std::string doubt(const Evidence& evidence, double fps);

} // namespace stltsa::motion
