// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "plot/side_view.hpp"
#include "plot/svg.hpp"

namespace tool::plot {

/// Smallest box around a posture and the ground, in file units, y up.
Rect posture_box(const SideView& view, std::int64_t frame);

/// Draws the posture of a frame; `ground`: the point of the figure on which the middle of the body
/// stands; `scale`: figure units per file unit.
void draw_stick_figure(Svg& svg, const SideView& view, std::int64_t frame, Point ground,
                       double scale);

} // namespace tool::plot
