// SPDX-License-Identifier: BSD-3-Clause
// Where the behavior changes: the cheapest division of the moments, with a price for each border
// (kernel change points: Harchaoui, Cappe, 2007; pruned search: Killick, Fearnhead, Eckley, JASA
// 107, 2012).
#pragma once

#include <vector>

#include "motion/behaviors/kernel_features.hpp"

namespace stltsa::motion {

/// What a border costs, in units of KernelFeatures::cost(). It does not grow with the recording: a
/// price proportional to log n lost a fifth of the behaviors in ten minutes.
double border_price(const KernelFeatures& features);

/// Moments at which the behavior changes, ascending, without the ends. `price`: of a border.
std::vector<std::int64_t> change_points(const KernelFeatures& features, double price);

} // namespace stltsa::motion
