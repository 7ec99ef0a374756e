// SPDX-License-Identifier: BSD-3-Clause
// Turning points of a curve.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stltsa::motion {

struct Extremum {
    std::int64_t at = 0;
    bool peak = false; ///< else a valley
};

/// Peaks and valleys by turns, each at least `prominence` from the next, the most extreme sample
/// of its kind between its neighbors. The ends of the curve count. Empty where the curve nowhere
/// changes by `prominence`.
std::vector<Extremum> alternating_extrema(std::span<const double> curve, double prominence);

/// Where the parabola through (-1, left), (0, middle), (1, right) turns, held to +-1/2.
double parabola_vertex(double left, double middle, double right);

} // namespace stltsa::motion
