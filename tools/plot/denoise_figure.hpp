// SPDX-License-Identifier: BSD-3-Clause
// Coordinates before and after denoising, with the fitted curve (Fig. 2 of the paper).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <stltsa.hpp>

namespace tool::plot {

struct DenoiseFigure {
    std::string title;
    std::string summary;
    std::vector<std::string> facts;
    double fps = 0;         ///< of the source; 0: unknown, the axis counts frames
    std::int64_t first = 0; ///< row i is frame first + i * step
    std::int64_t step = 1;
    std::vector<std::int64_t> lengths; ///< rows of each piece; pieces are not connected
    stltsa::Matrix before;             ///< rows x columns, as the next two
    stltsa::Matrix after;
    stltsa::Matrix curve;
    stltsa::Matrix moves;       ///< 0: the point was not moved
    std::vector<double> gammas; ///< of each column
};

/// The SVG document. Same figure, same bytes.
std::string denoise_figure_svg(const DenoiseFigure& figure);

} // namespace tool::plot
