// SPDX-License-Identifier: BSD-3-Clause
// The borders between behaviors, made sharper by what is known of the behaviors on both sides.
#pragma once

#include <vector>

#include "recording/change_points.hpp"

namespace stltsa::recording {

/// Rows at which the behavior changes, ascending, without the ends.
std::vector<std::int64_t> behavior_borders(const Signal& signal, const KernelFeatures& features);

} // namespace stltsa::recording
