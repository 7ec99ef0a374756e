// SPDX-License-Identifier: BSD-3-Clause
// The parts of the figure, each drawn into a rectangle.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "plot/figure.hpp"
#include "plot/svg.hpp"

namespace tool::plot {

/// Rows or values that a panel shows: the lowest and the highest, a unit apart if they are equal.
struct Range {
    double low = INFINITY;
    double high = -HUGE_VAL;

    void add(double value); ///< NaN is left out
    Range wide() const;     ///< widened if low and high are equal; -1 to 1 if nothing was added
};

/// Samples [begin, end) that one line of one color connects. A line ends at the sample where the
/// next begins, except for the last one of a piece.
struct Stretch {
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int32_t kind = 0;
};
/// The samples that have a curve, split where the unit or the piece changes.
std::vector<Stretch> stretches(const Figure& figure);

void draw_curve_panel(Svg& svg, const Figure& figure, const Rect& area);
/// Returns the y below the panel and its caption.
double draw_loop_panel(Svg& svg, const Figure& figure, const Rect& area);
/// Units or segments, and facts. Returns the y below them.
double draw_key(Svg& svg, const Figure& figure, const Rect& area);
/// The curve of all cycles on 0 to 100 %, with mean and standard deviation.
void draw_overlay(Svg& svg, const Figure& figure, const Rect& area);
/// The curve of the enlarged cycle and of its two neighbors.
void draw_zoom(Svg& svg, const Figure& figure, const Rect& area);
/// The length of each cycle.
void draw_cycle_times(Svg& svg, const Figure& figure, const Rect& area);
/// A title above a panel.
void draw_heading(Svg& svg, const Rect& frame, const std::string& text);

/// The bars above the curve: segments with their labels if more than one moves, units with their
/// names, cycles with their numbers. Returns the height used.
double draw_unit_bars(Svg& svg, const Figure& figure, const Rect& area);

} // namespace tool::plot
