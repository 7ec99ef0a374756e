// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plot/axes.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"

namespace tool::plot {
namespace {

const char* const cycle_color = unit_colors(STLTSA_UNIT_CYCLIC).line;
constexpr double cycle_air = 8; // between the frame and what it shows

/// Of more cycles, this many are drawn, evenly spaced.
constexpr std::int64_t most_lines = 60;

std::vector<Point> line_of(const stltsa::Matrix& values, const Scale& x, const Scale& y) {
    std::vector<Point> line;
    for (std::int64_t i = 0; i < values.rows; ++i)
        if (std::isfinite(values(i, 0)))
            line.push_back({x(static_cast<double>(i)), y(values(i, 0))});
    return line;
}

/// The area between the mean plus and minus the standard deviation.
std::vector<Point> band_of(const stltsa::Matrix& mean, const stltsa::Matrix& deviation,
                           const Scale& x, const Scale& y) {
    std::vector<Point> outline;
    for (const double sign : {1.0, -1.0})
        for (std::int64_t k = 0; k < mean.rows; ++k) {
            const std::int64_t i = sign > 0 ? k : mean.rows - 1 - k;
            const double value = mean(i, 0) + sign * deviation(i, 0);
            if (std::isfinite(value))
                outline.push_back({x(static_cast<double>(i)), y(value)});
        }
    return outline;
}

double length_of(const Figure& figure, const stltsa::Interval& cycle) {
    return figure.fps > 0 ? cycle.end_s - cycle.begin_s
                          : static_cast<double>(cycle.end - cycle.begin);
}

} // namespace

void draw_heading(Svg& svg, const Rect& frame, const std::string& text) {
    svg.text({frame.x, frame.y - 5}, Anchor::start, text,
             {{"class", "heading"}, {"font-weight", "bold"}});
}

void draw_overlay(Svg& svg, const Figure& figure, const Rect& area) {
    const stltsa::Cycles& all = *figure.overlaid;
    const stltsa::Matrix mean = all.mean(), deviation = all.deviation();
    const std::int64_t lines = std::min(all.count(), most_lines);
    std::vector<stltsa::Matrix> cycles;
    Range range;
    for (std::int64_t i = 0; i < lines; ++i) {
        cycles.push_back(all.cycle(i * all.count() / lines));
        for (std::int64_t k = 0; k < mean.rows; ++k)
            range.add(cycles.back()(k, 0));
    }
    range = range.wide();
    const auto last = static_cast<double>(mean.rows - 1);
    const Scale x{0, last, area.x, area.right()};
    const Scale y{range.low, range.high, area.bottom() - cycle_air, area.y + cycle_air};
    draw_heading(svg, area,
                 lines < all.count() ? fmt::format("{} of {} cycles, overlaid", lines, all.count())
                                     : fmt::format("{} cycles, overlaid", lines));
    svg.open("g", {{"fill", "none"},
                   {"stroke", cycle_color},
                   {"stroke-width", many_line},
                   {"stroke-opacity", 0.25}});
    for (const stltsa::Matrix& cycle : cycles)
        svg.polyline(line_of(cycle, x, y), {{"class", "overlaid"}});
    svg.close("g");
    svg.polyline(band_of(mean, deviation, x, y),
                 {{"class", "deviation"}, {"fill", cycle_color}, {"fill-opacity", 0.25}});
    svg.polyline(line_of(mean, x, y), {{"class", "mean"},
                                       {"fill", "none"},
                                       {"stroke", cycle_color},
                                       {"stroke-width", curve_line}});
    draw_frame(svg, area);
    draw_x_axis(svg, area, {0, 100, area.x, area.right()}, 5,
                "share of the cycle in %; band: standard deviation");
    draw_y_axis(svg, area, y, 4, figure.curve_name);
}

void draw_zoom(Svg& svg, const Figure& figure, const Rect& area) {
    const auto chosen = static_cast<std::size_t>(figure.enlarged);
    const auto& cycle = figure.cycles[chosen];
    const auto length = cycle.end - cycle.begin;
    const auto begin = std::max<std::int64_t>(0, cycle.begin - length);
    const auto end = std::min(figure.frames, cycle.end + length);
    Range range;
    for (std::int64_t i = 0; i < std::ssize(figure.curve); ++i)
        if (figure.frame_of(i) >= begin && figure.frame_of(i) <= end)
            range.add(figure.curve[static_cast<std::size_t>(i)]);
    range = range.wide();
    const Scale x{static_cast<double>(begin), static_cast<double>(end), area.x, area.right()};
    const Scale y{range.low, range.high, area.bottom() - cycle_air, area.y + cycle_air};
    const double from = x(static_cast<double>(cycle.begin));
    const double to = x(static_cast<double>(cycle.end));
    draw_heading(svg, area,
                 fmt::format("{}cycle, number {}",
                             figure.enlarged == figure.representative ? "representative " : "",
                             chosen + 1));
    svg.rect({from, area.y, to - from, area.height},
             {{"class", "zoomed"}, {"fill", cycle_color}, {"fill-opacity", 0.18}});
    for (const double edge : {from, to})
        svg.line(
            {edge, area.y}, {edge, area.bottom()},
            {{"stroke", cycle_color}, {"stroke-width", thin_line}, {"stroke-dasharray", dashes}});
    svg.open("g", {{"fill", "none"}, {"stroke-width", curve_line}});
    for (const Stretch& stretch : stretches(figure)) {
        std::vector<Point> line;
        for (std::int64_t i = stretch.begin; i < stretch.end; ++i)
            if (const std::int64_t frame = figure.frame_of(i); frame >= begin && frame <= end)
                line.push_back(
                    {x(static_cast<double>(frame)), y(figure.curve[static_cast<std::size_t>(i)])});
        svg.curve(line, {{"stroke", unit_colors(stretch.kind).line}});
    }
    svg.close("g");
    draw_frame(svg, area);
    draw_x_axis(svg, area, {figure.time_of(x.from), figure.time_of(x.to), area.x, area.right()}, 6,
                time_title(figure.fps));
    draw_y_axis(svg, area, y, 4, "");
}

void draw_cycle_times(Svg& svg, const Figure& figure, const Rect& area) {
    Range range;
    for (const stltsa::Interval& cycle : figure.cycles)
        range.add(length_of(figure, cycle));
    // Equal cycles are a level line, not magnified rounding.
    const double least = 0.05 * range.high;
    const double missing = std::max(0.0, least - (range.high - range.low));
    range = Range{range.low - 0.5 * missing, range.high + 0.5 * missing}.wide();
    const auto count = static_cast<double>(figure.cycles.size());
    const Scale x{1, count, area.x + cycle_air, area.right() - cycle_air};
    const Scale y{range.low, range.high, area.bottom() - cycle_air, area.y + cycle_air};
    draw_heading(svg, area, "cycle times");
    svg.text({area.right(), area.y - 5}, Anchor::end, figure.cycle_times,
             {{"font-size", small_font}, {"fill", faint_ink}});
    const double radius = count > 100 ? 0.6 * mark_radius : mark_radius;
    svg.open("g", {{"stroke-width", thin_line}});
    for (std::size_t i = 0; i < figure.cycles.size(); ++i) {
        const stltsa::Interval& cycle = figure.cycles[i];
        const bool chosen = static_cast<std::int64_t>(i) == figure.representative;
        const char* color =
            figure.several()
                ? label_colors(figure.segments[static_cast<std::size_t>(cycle.segment)].label).line
                : cycle_color;
        svg.circle(
            {x(static_cast<double>(i + 1)), y(length_of(figure, cycle))}, radius,
            {{"class", "cycle-time"}, {"stroke", color}, {"fill", chosen ? color : "#ffffff"}});
    }
    svg.close("g");
    draw_frame(svg, area);
    draw_x_axis(svg, area, x, static_cast<int>(std::min(10.0, count - 1)), "number of the cycle");
    draw_y_axis(svg, area, y, 3, figure.fps > 0 ? "seconds" : "frames");
}

} // namespace tool::plot
