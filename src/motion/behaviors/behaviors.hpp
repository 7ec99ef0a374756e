// SPDX-License-Identifier: BSD-3-Clause
// Where one behavior ends and another begins.
#pragma once

#include <vector>

#include "motion/behaviors/change_points.hpp"

namespace stltsa::motion {

/// Rows at which the behavior changes, ascending, without the ends. `price`: of a border.
/// Neighbors of one behavior are joined unless the price is below border_price(). `poll` is called
/// every few milliseconds and may throw.
std::vector<std::int64_t> behavior_borders(const KernelFeatures& features, double price,
                                           const std::function<void()>& poll);

} // namespace stltsa::motion
