// SPDX-License-Identifier: BSD-3-Clause
// The figure of a clip: the curve over time with units, cycles and postures (Fig. 3 of the paper),
// the loop of two coordinates with frame numbers (Fig. 1), and cycle times; if there are many
// cycles, also these on 0 to 100 % and the representative one. docs/figures.md describes the style.
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
    std::string summary;            ///< the result, or the reason why there is none
    std::vector<std::string> facts; ///< lines below the key
    std::int64_t frames = 0;        ///< of the source
    double fps = 0;                 ///< of the source; 0: unknown, the axis counts frames
    std::int64_t first = 0;         ///< sample i is frame first + i * step
    std::int64_t step = 1;
    std::string curve_name;
    std::vector<double> curve;        ///< one value per sample; NaN: there is no curve
    std::vector<std::int64_t> pieces; ///< per sample: pieces are not connected; empty: one piece
    std::vector<std::string> loop_names;
    stltsa::Matrix loop;   ///< samples x 2, NaN where not drawn; empty: no second panel
    std::string loop_note; ///< below the loop; empty: none
    std::vector<stltsa::Segment> segments;
    std::vector<stltsa::Interval> units;
    std::vector<stltsa::Interval> cycles;
    std::int64_t representative = -1; ///< index into cycles
    std::int64_t enlarged = -1; ///< the representative cycle or, if it has no curve, another one
    /// The curve of the cycles in the segment of the enlarged one, on 0 to 100 %.
    std::optional<stltsa::Cycles> overlaid;
    std::string cycle_times; ///< mean and standard deviation in words; empty: several motions
    std::optional<SideView> bodies;
    std::vector<std::int64_t> postures; ///< frames; the first n are the choice of n postures

    std::int64_t frame_of(std::int64_t sample) const { return first + sample * step; }
    /// Seconds, or frames if the rate is unknown.
    double time_of(double frame) const { return fps > 0 ? frame / fps : frame; }
    /// Whether there are too many cycles to draw them side by side.
    bool dense() const;
    /// Whether there is more than one behavior.
    bool several() const;
    /// The unit of a frame, as STLTSA_UNIT_*; 0: none.
    std::int32_t unit_at(std::int64_t frame) const;
};

/// The SVG document. Same figure, same bytes.
std::string figure_svg(const Figure& figure);

} // namespace tool::plot
