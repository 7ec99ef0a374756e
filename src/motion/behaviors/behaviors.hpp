// SPDX-License-Identifier: BSD-3-Clause
// Where one behavior ends and another begins.
#pragma once

#include <vector>

#include "motion/behaviors/change_points.hpp"

namespace stltsa::motion {

/// Rows at which the behavior changes, ascending, without the ends. Neighbors of one behavior are
/// joined; then up to `more` borders are added, those that gain most.
std::vector<std::int64_t> behavior_borders(const KernelFeatures& features, std::int64_t more);

} // namespace stltsa::motion
