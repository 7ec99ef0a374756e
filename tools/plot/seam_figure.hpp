// SPDX-License-Identifier: BSD-3-Clause
// Strips of postures across the seams of new motion, in the order of time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plot/side_view.hpp"

namespace tool::plot {

/// Postures of every `step`-th frame on both sides of a frame.
struct Strip {
    std::string heading;
    std::string note;
    std::int64_t middle = 0;
    std::int64_t step = 1;
    std::int64_t crossfade = -1; ///< blended frames on each side of the middle; -1: no seam
    bool wraps = false;          ///< the middle is the end of a loop, which goes on with frame 0
};

/// Number of postures in a strip: as many before its middle as after it.
inline constexpr std::int64_t strip_postures = 13;

struct SeamFigure {
    std::string title;
    std::string summary;
    std::string note; ///< below the strips
    SideView bodies;  ///< of the new clip
    std::vector<Strip> strips;
};

/// The SVG document. Same figure, same bytes.
std::string seam_figure_svg(const SeamFigure& figure);

} // namespace tool::plot
