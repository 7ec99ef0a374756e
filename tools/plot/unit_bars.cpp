// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"
#include "plot/scale.hpp"
#include "terminal/text.hpp"

namespace tool::plot {
namespace {

constexpr double unit_bar = 15;
constexpr double cycle_bar = 13;
constexpr double segment_bar = 18;
/// Narrower cycles get no bars, which would run into each other.
constexpr double least_cycle = 3;
constexpr double gap = 2;
constexpr double font = 10;

/// Writes the text into the bar if it fits there.
void bar_text(Svg& svg, const Rect& bar, const std::string& text, const char* color) {
    if (text_width(text, font) + 2 <= bar.width)
        svg.text({bar.x + 0.5 * bar.width, bar.y + 0.5 * bar.height + 3.5}, Anchor::middle, text,
                 {{"font-size", font}, {"fill", color}});
}

template <class Interval>
Rect bar_of(const Figure& figure, const Interval& interval, const Rect& row) {
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

/// "A 12x", or "A" where this does not fit.
void segment_text(Svg& svg, const Rect& bar, const stltsa::Segment& segment, const char* color) {
    const std::string label = label_text(segment.label);
    const bool repeats =
        segment.kind == STLTSA_SEGMENT_CYCLIC || segment.kind == STLTSA_SEGMENT_REPETITIONS;
    const std::string counted = repeats ? label + " " + std::to_string(segment.count) + "x" : label;
    bar_text(svg, bar, text_width(counted, font) + 2 <= bar.width ? counted : label, color);
}

/// Repetitions are framed dashed, single actions faint.
double draw_segment_bars(Svg& svg, const Figure& figure, const Rect& row) {
    const auto moving = std::ranges::count_if(figure.segments, [](const stltsa::Segment& segment) {
        return segment.kind != STLTSA_SEGMENT_REST;
    });
    if (moving < 2)
        return 0;
    for (const stltsa::Segment& segment : figure.segments) {
        const UnitColors colors = label_colors(segment.label);
        const Rect bar = bar_of(figure, segment, row);
        const bool faint = segment.kind == STLTSA_SEGMENT_ACTION;
        const bool dashed = segment.kind == STLTSA_SEGMENT_REPETITIONS;
        svg.rect({bar.x, bar.y, std::max(0.5, bar.width), bar.height},
                 {{"class", "segment"},
                  {"fill", faint || dashed ? colors.band : colors.line},
                  {"stroke", segment.kind == STLTSA_SEGMENT_REST ? "none" : colors.line},
                  {"stroke-dasharray", dashed ? "4 2" : "none"},
                  {"stroke-width", 1.0}});
        if (segment.kind != STLTSA_SEGMENT_REST)
            segment_text(svg, bar, segment, faint || dashed ? ink : colors.text);
    }
    return segment_bar + gap;
}

} // namespace

bool cycles_fit(const Figure& figure, const Rect& row) {
    return static_cast<double>(figure.cycles.size()) * least_cycle <= row.width;
}

double draw_unit_bars(Svg& svg, const Figure& figure, const Rect& all) {
    if (figure.units.empty())
        return 0;
    const double used = draw_segment_bars(svg, figure, {all.x, all.y, all.width, segment_bar});
    const Rect area{all.x, all.y + used, all.width, all.height - used};
    const Rect units{area.x, area.y, area.width, unit_bar};
    for (const stltsa::Interval& unit : figure.units) {
        const UnitColors colors = unit_colors(unit.kind);
        const Rect bar = bar_of(figure, unit, units);
        svg.rect(bar, {{"class", "unit"}, {"fill", colors.line}});
        bar_text(svg, bar, stltsa::unit_name(unit.kind), colors.text);
    }
    if (figure.cycles.empty() || !cycles_fit(figure, area))
        return used + unit_bar + gap;
    const Rect cycles{area.x, area.y + unit_bar + gap, area.width, cycle_bar};
    for (std::size_t i = 0; i < figure.cycles.size(); ++i)
        draw_cycle_bar(svg, bar_of(figure, figure.cycles[i], cycles), i,
                       static_cast<std::int64_t>(i) == figure.representative);
    return used + unit_bar + gap + cycle_bar + gap;
}

} // namespace tool::plot
