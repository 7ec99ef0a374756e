// SPDX-License-Identifier: BSD-3-Clause
// The title of every figure.
#pragma once

#include <string>

#include "plot/svg.hpp"

namespace tool::plot {

/// One line for the title and as many as needed for the summary, between `left` and `right`.
/// Returns the y of the last line.
double draw_title(Svg& svg, const std::string& title, const std::string& summary, double left,
                  double right);

} // namespace tool::plot
