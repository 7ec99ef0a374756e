// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "plot/axes.hpp"
#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"
#include "terminal/text.hpp"

namespace tool::plot {
namespace {

constexpr double line_height = 16;
constexpr std::size_t most_rows = 9;

/// A row of the list; `color`: null if an earlier row has the same name.
struct Row {
    const char* color = nullptr;
    std::string name;
    std::int64_t begin = 0, end = 0;
    double begin_s = 0, end_s = 0;
};

std::vector<Row> unit_rows(const Figure& figure) {
    std::vector<Row> rows;
    std::set<std::int32_t> kinds;
    for (const stltsa::Interval& unit : figure.units)
        rows.push_back({kinds.insert(unit.kind).second ? unit_colors(unit.kind).line : nullptr,
                        stltsa::unit_name(unit.kind), unit.begin, unit.end, unit.begin_s,
                        unit.end_s});
    return rows;
}

std::vector<Row> segment_rows(const Figure& figure) {
    std::vector<Row> rows;
    std::set<std::int32_t> labels;
    for (const stltsa::Segment& segment : figure.segments) {
        const std::string kind = stltsa::segment_name(segment.kind);
        const std::string label = label_text(segment.label);
        rows.push_back(
            {labels.insert(segment.label).second ? label_colors(segment.label).line : nullptr,
             label.empty() ? kind : fmt::format("{}, {}", label, kind), segment.begin, segment.end,
             segment.begin_s, segment.end_s});
    }
    return rows;
}

struct Columns {
    double name, frames, seconds, length;
};

void draw_head(Svg& svg, const char* name, const Columns& x, double y, bool timed) {
    svg.open("g", {{"fill", faint_ink}, {"font-size", list_font}});
    svg.text({x.name, y}, Anchor::start, name);
    svg.text({x.frames, y}, Anchor::end, "frames");
    if (timed) {
        svg.text({x.seconds, y}, Anchor::end, "seconds");
        svg.text({x.length, y}, Anchor::end, "length");
    }
    svg.close("g");
}

void draw_row(Svg& svg, const Row& row, const Columns& x, double y, bool timed) {
    if (row.color != nullptr)
        svg.rect({x.name - 16, y - 8.5, 10, 10}, {{"class", "key"}, {"fill", row.color}});
    svg.open("g", {{"font-size", list_font}});
    svg.text({x.name, y}, Anchor::start, row.name);
    svg.text({x.frames, y}, Anchor::end, fmt::format("{}\u2013{}", row.begin, row.end));
    if (timed) {
        svg.text({x.seconds, y}, Anchor::end,
                 fmt::format("{:.2f}\u2013{:.2f}", row.begin_s, row.end_s));
        svg.text({x.length, y}, Anchor::end, fmt::format("{:.2f} s", row.end_s - row.begin_s));
    }
    svg.close("g");
}

double draw_rows(Svg& svg, const Figure& figure, const Rect& area) {
    const std::vector<Row> rows = figure.several() ? segment_rows(figure) : unit_rows(figure);
    const Columns x{area.x + 16, area.x + 172, area.x + 266, area.x + 322};
    const bool timed = figure.fps > 0;
    double y = area.y + 10;
    draw_head(svg, figure.several() ? "segment" : "unit", x, y, timed);
    const std::size_t shown = std::min(rows.size(), most_rows);
    for (std::size_t i = 0; i < shown; ++i)
        draw_row(svg, rows[i], x, y += line_height, timed);
    if (const std::size_t more = rows.size() - shown; more > 0)
        svg.text({x.name, y += line_height}, Anchor::start, fmt::format("and {} more", more),
                 {{"font-size", list_font}, {"fill", faint_ink}});
    return y + line_height + 8;
}

/// The colors of the kinds of units, each kind once, in rows.
double draw_kinds(Svg& svg, const Figure& figure, const Rect& area, double y) {
    double x = area.x;
    for (const Row& row : unit_rows(figure)) {
        if (row.color == nullptr)
            continue;
        const double taken = 16 + text_width(row.name, list_font) + 10;
        if (x + taken > area.right() && x > area.x) {
            x = area.x;
            y += line_height;
        }
        svg.rect({x, y - 8.5, 10, 10}, {{"class", "key"}, {"fill", row.color}});
        svg.text({x + 14, y}, Anchor::start, row.name, {{"font-size", list_font}});
        x += taken;
    }
    return y + line_height + 8;
}

} // namespace

double draw_key(Svg& svg, const Figure& figure, const Rect& area) {
    double y = area.y + 10;
    if (!figure.units.empty())
        y = draw_rows(svg, figure, area);
    if (figure.several())
        y = draw_kinds(svg, figure, area, y);
    for (const std::string& fact : figure.facts)
        for (const std::string& line : lines_of(fact, list_font, area.width)) {
            svg.text({area.x, y}, Anchor::start, line, {{"font-size", list_font}});
            y += line_height;
        }
    return y;
}

} // namespace tool::plot
