// SPDX-License-Identifier: BSD-3-Clause
// Where the behavior changes: the cheapest division of the moments, with a price for each border
// (kernel change points: Harchaoui, Cappe, 2007; pruned search: Killick, Fearnhead, Eckley, JASA
// 107, 2012).
#pragma once

#include <functional>
#include <vector>

#include "motion/behaviors/kernel_features.hpp"

namespace stltsa::motion {

/// A price for each border, not for the length of the recording: with log n, a fifth of the
/// behaviors of ten minutes was lost.
constexpr double border_price = 9;

/// Moments at which the behavior changes, ascending, without the ends. `poll` is called every few
/// milliseconds and may throw.
std::vector<std::int64_t> change_points(const KernelFeatures& features, double price,
                                        const std::function<void()>& poll = {});

} // namespace stltsa::motion
