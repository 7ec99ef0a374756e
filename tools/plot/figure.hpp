// SPDX-License-Identifier: BSD-3-Clause
// The picture of a clip: the manifold curve over time with units, cycles and postures (as Fig. 3
// of the paper), and the loop of two coordinates with frame numbers (as Fig. 1).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <stltsa.hpp>

#include "plot/side_view.hpp"

namespace tool::plot {

struct Figure {
    std::string title;
    std::string summary;            ///< what was found, or why nothing was
    std::vector<std::string> facts; ///< lines below the key
    std::int64_t frames = 0;        ///< of the source
    double fps = 0;                 ///< of the source; 0: unknown, the axis counts frames
    std::int64_t first = 0;         ///< sample i is frame first + i * step
    std::int64_t step = 1;
    std::string curve_name;
    std::vector<double> curve;        ///< a value per sample
    std::vector<std::int64_t> pieces; ///< per sample: no line leads to another piece; empty: one
    std::vector<std::string> loop_names;
    stltsa::Matrix loop; ///< samples x 2; empty: no second panel
    std::vector<stltsa::Interval> units;
    std::vector<stltsa::Interval> cycles;
    std::int64_t representative = -1; ///< index into cycles
    std::optional<SideView> bodies;

    std::int64_t frame_of(std::int64_t sample) const { return first + sample * step; }
    /// Seconds, or frames where the rate is unknown.
    double time_of(double frame) const { return fps > 0 ? frame / fps : frame; }
    /// The unit that a frame is in, as STLTSA_UNIT_*; 0: none.
    std::int32_t unit_at(std::int64_t frame) const;
};

/// The SVG document. Same figure, same bytes.
std::string figure_svg(const Figure& figure);

} // namespace tool::plot
