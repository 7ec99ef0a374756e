// SPDX-License-Identifier: BSD-3-Clause
// From the samples of a clip to its motion units and cycles (paper, section 3.1).
#pragma once

#include "base/progress.hpp"
#include "motion/decomposition.hpp"

namespace stltsa::motion {

/// `samples`: frames x features at `fps` (> 0).
Decomposition decompose(ConstMatrixView samples, double fps, const DecomposeOptions& options,
                        const Progress& progress);

} // namespace stltsa::motion
