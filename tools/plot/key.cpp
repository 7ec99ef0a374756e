// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"

namespace tool::plot {
namespace {

constexpr double line_height = 16;
constexpr double font = 10.5;
constexpr std::size_t most_rows = 9;

struct Columns {
    double name, frames, seconds, length;
};

void draw_heading(Svg& svg, const Columns& x, double y, bool timed) {
    svg.open("g", {{"fill", faint_ink}, {"font-size", font}});
    svg.text({x.name, y}, Anchor::start, "unit");
    svg.text({x.frames, y}, Anchor::end, "frames");
    if (timed) {
        svg.text({x.seconds, y}, Anchor::end, "seconds");
        svg.text({x.length, y}, Anchor::end, "length");
    }
    svg.close("g");
}

void draw_row(Svg& svg, const stltsa::Interval& unit, const Columns& x, double y) {
    svg.rect({x.name - 16, y - 8.5, 10, 10}, {{"fill", unit_colors(unit.kind).line}});
    svg.open("g", {{"font-size", font}});
    svg.text({x.name, y}, Anchor::start, stltsa::unit_name(unit.kind));
    svg.text({x.frames, y}, Anchor::end, fmt::format("{}\u2013{}", unit.begin, unit.end));
    svg.text({x.seconds, y}, Anchor::end,
             fmt::format("{:.2f}\u2013{:.2f}", unit.begin_s, unit.end_s));
    svg.text({x.length, y}, Anchor::end, fmt::format("{:.2f} s", unit.end_s - unit.begin_s));
    svg.close("g");
}

double draw_units(Svg& svg, const Figure& figure, const Rect& area) {
    const Columns x{area.x + 16, area.x + 172, area.x + 266, area.right()};
    double y = area.y + 10;
    draw_heading(svg, x, y, figure.fps > 0);
    const std::size_t shown = std::min(figure.units.size(), most_rows);
    for (std::size_t i = 0; i < shown; ++i)
        draw_row(svg, figure.units[i], x, y += line_height);
    if (const std::size_t more = figure.units.size() - shown; more > 0)
        svg.text({x.name, y += line_height}, Anchor::start, fmt::format("and {} more", more),
                 {{"font-size", font}, {"fill", faint_ink}});
    return y + line_height + 8;
}

} // namespace

void draw_key(Svg& svg, const Figure& figure, const Rect& area) {
    double y = figure.units.empty() ? area.y + 10 : draw_units(svg, figure, area);
    for (const std::string& fact : figure.facts)
        for (const std::string& line : lines_of(fact, font, area.width)) {
            svg.text({area.x, y}, Anchor::start, line, {{"font-size", font}});
            y += line_height;
        }
}

} // namespace tool::plot
