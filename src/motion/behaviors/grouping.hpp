// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace stltsa::motion {

/// Group of each of `count` items, numbered by first appearance: average linkage, up to the mean
/// distance `most`. Beyond some thousands, items join the group of the nearest earlier item.
std::vector<int> group(std::int64_t count, double most,
                       const std::function<double(std::int64_t, std::int64_t)>& distance);

} // namespace stltsa::motion
