// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "motion/decomposition.hpp"

namespace stltsa::motion {

/// Consecutive cycles, each from the first to the third candidate margin (paper, section 3.1).
std::vector<Cycle> cycles_between(const std::vector<double>& margins);

/// Index of the first cycle whose poses, at 32 equally spaced phases, have the least sum of squared
/// distances to those of all cycles; -1 without cycles.
std::int64_t most_typical(const std::vector<Cycle>& cycles, ConstMatrixView samples,
                          const Progress& progress = {});

} // namespace stltsa::motion
