// SPDX-License-Identifier: BSD-3-Clause
#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"
#include "plot/scale.hpp"

namespace tool::plot {
namespace {

constexpr double unit_bar = 15;
constexpr double cycle_bar = 13;
constexpr double gap = 2;
constexpr double font = 10;

/// Writes the text into the bar if it fits there.
void bar_text(Svg& svg, const Rect& bar, const std::string& text, const char* color) {
    if (text_width(text, font) + 2 <= bar.width)
        svg.text({bar.x + 0.5 * bar.width, bar.y + 0.5 * bar.height + 3.5}, Anchor::middle, text,
                 {{"font-size", font}, {"fill", color}});
}

Rect bar_of(const Figure& figure, const stltsa::Interval& interval, const Rect& row) {
    const Scale time{0, static_cast<double>(figure.frames), row.x, row.right()};
    const double begin = time(static_cast<double>(interval.begin));
    const double end = time(static_cast<double>(interval.end));
    return {begin, row.y, end - begin, row.height};
}

void draw_cycle_bar(Svg& svg, const Rect& bar, std::size_t index, bool chosen) {
    const UnitColors colors = unit_colors(STLTSA_UNIT_CYCLIC);
    const Rect inner{bar.x + 1, bar.y + 0.5, std::max(0.5, bar.width - 2), bar.height - 1};
    svg.rect(inner, {{"class", "cycle"},
                     {"fill", chosen ? colors.line : "#ffffff"},
                     {"stroke", colors.line},
                     {"stroke-width", 1.0}});
    const std::string number_text = std::to_string(index + 1);
    const std::string long_text = "cycle " + number_text;
    const char* color = chosen ? colors.text : colors.line;
    bar_text(svg, inner, text_width(long_text, font) + 2 <= inner.width ? long_text : number_text,
             color);
}

} // namespace

double draw_unit_bars(Svg& svg, const Figure& figure, const Rect& area) {
    if (figure.units.empty())
        return 0;
    const Rect units{area.x, area.y, area.width, unit_bar};
    for (const stltsa::Interval& unit : figure.units) {
        const UnitColors colors = unit_colors(unit.kind);
        const Rect bar = bar_of(figure, unit, units);
        svg.rect(bar, {{"class", "unit"}, {"fill", colors.line}});
        bar_text(svg, bar, stltsa::unit_name(unit.kind), colors.text);
    }
    if (figure.cycles.empty())
        return unit_bar + gap;
    const Rect cycles{area.x, area.y + unit_bar + gap, area.width, cycle_bar};
    for (std::size_t i = 0; i < figure.cycles.size(); ++i)
        draw_cycle_bar(svg, bar_of(figure, figure.cycles[i], cycles), i,
                       static_cast<std::int64_t>(i) == figure.representative);
    return unit_bar + gap + cycle_bar + gap;
}

} // namespace tool::plot
