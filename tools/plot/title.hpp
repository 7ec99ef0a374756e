// SPDX-License-Identifier: BSD-3-Clause
// What stands on top of every figure.
#pragma once

#include <string>

#include "plot/svg.hpp"

namespace tool::plot {

/// A line for the title, as many as needed for the summary, between the edges `left` and `right`;
/// returns the last one's y.
double draw_title(Svg& svg, const std::string& title, const std::string& summary, double left,
                  double right);

} // namespace tool::plot
