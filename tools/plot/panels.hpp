// SPDX-License-Identifier: BSD-3-Clause
// The parts of the figure, each drawn into a rectangle.
#pragma once

#include <vector>

#include "plot/figure.hpp"
#include "plot/svg.hpp"

namespace tool::plot {

/// Samples [begin, end) that one line of one color connects. A line ends at the sample where the
/// next begins, except for the last one of a piece.
struct Stretch {
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int32_t kind = 0;
};
/// The samples, split where the unit or the piece changes.
std::vector<Stretch> stretches(const Figure& figure);

void draw_curve_panel(Svg& svg, const Figure& figure, const Rect& area);
void draw_loop_panel(Svg& svg, const Figure& figure, const Rect& area);
void draw_key(Svg& svg, const Figure& figure, const Rect& area);

/// Whether the cycles are wide enough to be drawn one by one.
bool cycles_fit(const Figure& figure, const Rect& row);

/// The bars above the curve: segments with their labels if more than one moves, units with their
/// names, cycles with their numbers. Returns the height used.
double draw_unit_bars(Svg& svg, const Figure& figure, const Rect& area);

} // namespace tool::plot
