// SPDX-License-Identifier: BSD-3-Clause
// Peaks and valleys of a curve, where its first difference is close to 0 (paper, section 3.1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stltsa::motion {

struct Extremum {
    std::int64_t at = 0;
    bool peak = false; ///< false: a valley
};

/// Alternating peaks and valleys, at least `prominence` higher or lower than the next; each is the
/// most extreme sample between its neighbors. The ends of the curve may be extrema. Empty if the
/// curve changes by less than `prominence`.
std::vector<Extremum> alternating_extrema(std::span<const double> curve, double prominence);

/// Vertex of the parabola through (-1, left), (0, middle), (1, right), clamped to +-1/2.
double parabola_vertex(double left, double middle, double right);

} // namespace stltsa::motion
