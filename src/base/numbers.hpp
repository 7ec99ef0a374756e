// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <numbers>

namespace stltsa {

/// Stands for a number that is unknown.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Sums of squares of larger numbers may overflow.
inline constexpr double largest_number = 1e100;
/// A full turn in radians.
inline constexpr double turn = 2 * std::numbers::pi;

} // namespace stltsa
