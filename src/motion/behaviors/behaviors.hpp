// SPDX-License-Identifier: BSD-3-Clause
// The borders between behaviors, made sharper by what is known of the behaviors on both sides.
#pragma once

#include <vector>

#include "motion/behaviors/change_points.hpp"

namespace stltsa::motion {

/// Rows at which the behavior changes, ascending, without the ends. `price`: of a border; below
/// border_price, moments are not assigned anew, which would lose short behaviors. `poll` is called
/// every few milliseconds and may throw.
std::vector<std::int64_t> behavior_borders(const Signal& signal, const KernelFeatures& features,
                                           double price, const std::function<void()>& poll);

} // namespace stltsa::motion
