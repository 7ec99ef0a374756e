// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "motion/decompose.hpp"

namespace stltsa::motion {

/// From each margin to the one after the next, back to back.
std::vector<Cycle> cycles_between(const std::vector<double>& margins);

/// The cycle most like the others: whose poses at 32 equally spaced phases have the least sum of
/// squared distances to those of all cycles. The first of equals; -1 without cycles.
std::int64_t most_typical(const std::vector<Cycle>& cycles, ConstMatrixView samples);

} // namespace stltsa::motion
