// SPDX-License-Identifier: BSD-3-Clause
// From the samples of a recording to its segments, units and cycles.
#pragma once

#include "motion/recording/recording.hpp"

namespace stltsa::motion {

/// `samples`: frames x features at `fps` (> 0).
Recording analyze(ConstMatrixView samples, double fps, const Options& options);

} // namespace stltsa::motion
