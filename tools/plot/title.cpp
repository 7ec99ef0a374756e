// SPDX-License-Identifier: BSD-3-Clause
#include "plot/title.hpp"

#include "plot/labels.hpp"

namespace tool::plot {

double draw_title(Svg& svg, const std::string& title, const std::string& summary, double left,
                  double right) {
    constexpr double title_font = 15;
    constexpr double summary_font = 12;
    svg.text({left, 22}, Anchor::start, shortened(title, 1.1 * title_font, right - left),
             {{"font-size", title_font}, {"font-weight", "bold"}});
    double y = 24;
    for (const std::string& line : lines_of(summary, summary_font, right - left))
        svg.text({left, y += 16}, Anchor::start, line, {{"font-size", summary_font}});
    return y;
}

} // namespace tool::plot
