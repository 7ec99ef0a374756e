// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "recording/stretch_cycles.hpp"

namespace stltsa::recording {

/// Likeness of each cycle to their mean: 1 less the squared deviation in units of twice the swing.
std::vector<double> cycle_likenesses(const Signal& signal, const std::vector<Interval>& cycles);

} // namespace stltsa::recording
