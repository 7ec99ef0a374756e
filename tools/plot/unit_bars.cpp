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

/// "cycle 12", or "12", in each bar of the cycles; nothing if one of them is too narrow.
std::string cycle_text(const std::vector<Rect>& bars, std::size_t index) {
    const auto fits = [&](std::string_view word) {
        const double width = text_width(std::string(word) + std::to_string(bars.size()), font) + 4;
        return std::ranges::all_of(bars, [&](const Rect& bar) { return bar.width >= width; });
    };
    for (const std::string_view word : {"cycle ", ""})
        if (fits(word))
            return std::string(word) + std::to_string(index + 1);
    return "";
}

void draw_cycle_bars(Svg& svg, const Figure& figure, const Rect& row) {
    const UnitColors colors = unit_colors(STLTSA_UNIT_CYCLIC);
    std::vector<Rect> bars;
    for (const stltsa::Interval& cycle : figure.cycles) {
        const Rect bar = bar_of(figure, cycle, row);
        bars.push_back({bar.x + 1, bar.y + 0.5, std::max(0.5, bar.width - 2), bar.height - 1});
    }
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const bool chosen = static_cast<std::int64_t>(i) == figure.representative;
        svg.rect(bars[i], {{"class", "cycle"},
                           {"fill", chosen ? colors.line : "#ffffff"},
                           {"stroke", colors.line},
                           {"stroke-width", 1.0}});
        bar_text(svg, bars[i], cycle_text(bars, i), chosen ? colors.text : colors.line);
    }
}

/// "A · 12 cycles", or "A" where this does not fit.
void segment_text(Svg& svg, const Rect& bar, const stltsa::Segment& segment, const char* color) {
    const std::string label = label_text(segment.label);
    const char* const what = segment.kind == STLTSA_SEGMENT_CYCLIC        ? "cycle"
                             : segment.kind == STLTSA_SEGMENT_REPETITIONS ? "repetition"
                                                                          : nullptr;
    const std::string repeated =
        what != nullptr ? label + " · " + counted(segment.count, what) : label;
    bar_text(svg, bar, text_width(repeated, font) + 2 <= bar.width ? repeated : label, color);
}

/// Repetitions are framed dashed, single actions faint.
double draw_segment_bars(Svg& svg, const Figure& figure, const Rect& row) {
    if (!figure.several())
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
    if (figure.cycles.empty() || figure.dense())
        return used + unit_bar + gap;
    draw_cycle_bars(svg, figure, {area.x, area.y + unit_bar + gap, area.width, cycle_bar});
    return used + unit_bar + gap + cycle_bar + gap;
}

} // namespace tool::plot
