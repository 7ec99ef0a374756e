// SPDX-License-Identifier: BSD-3-Clause
// Frame, ticks and titles of a panel.
#pragma once

#include <string_view>

#include "plot/scale.hpp"
#include "plot/svg.hpp"

namespace tool::plot {

/// Font sizes of ticks and numbers, and of lists beside the panels.
inline constexpr double small_font = 9.5;
inline constexpr double list_font = 10.5;

/// Title of a time axis: in seconds, or in frames if the rate is unknown.
std::string_view time_title(double fps);

void draw_frame(Svg& svg, const Rect& frame);
/// Ticks below the frame, with labels unless the title is empty.
void draw_x_axis(Svg& svg, const Rect& frame, const Scale& scale, int most, std::string_view title);
/// Ticks at the left of the frame, and the title, if any, beside the middle of the scale.
void draw_y_axis(Svg& svg, const Rect& frame, const Scale& scale, int most, std::string_view title);
/// Text that reads upward, centered at a point.
void draw_upward(Svg& svg, Point middle, std::string_view text);

} // namespace tool::plot
