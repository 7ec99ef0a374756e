// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "plot/side_view.hpp"
#include "plot/svg.hpp"

namespace tool::plot {

/// Smallest box around a posture, in the file's unit, y up, the ground included.
Rect posture_box(const SideView& view, std::int64_t frame);

/// Draws the posture of a frame; `ground` is the point of the paper that the middle of the body
/// stands on, `scale` the paper's unit over the file's.
void draw_stick_figure(Svg& svg, const SideView& view, std::int64_t frame, Point ground,
                       double scale);

} // namespace tool::plot
