// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "plot/axes.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"
#include "plot/postures.hpp"
#include "plot/stick_figure.hpp"

namespace tool::plot {
namespace {

constexpr double curve_air = 12; // between the curve and the postures

/// Layout: bars above the frame; inside it postures, the curve, postures.
struct Layout {
    Rect frame;
    Scale time;  ///< frame number to x
    Scale value; ///< curve value to y

    double middle() const { return 0.5 * (value.start + value.end); }
};

Layout layout_of(const Figure& figure, const Rect& frame, double posture_height) {
    Range range;
    for (const double value : figure.curve)
        range.add(value);
    range = range.wide();
    return {frame,
            {0, static_cast<double>(figure.frames), frame.x, frame.right()},
            {range.low, range.high, frame.bottom() - posture_height - curve_air,
             frame.y + posture_height + curve_air}};
}

Point curve_point(const Figure& figure, const Layout& layout, std::int64_t sample) {
    return {layout.time(static_cast<double>(figure.frame_of(sample))),
            layout.value(figure.curve[static_cast<std::size_t>(sample)])};
}

/// The point of the curve at a frame, interpolated between samples; where there is no curve, a
/// point on the dotted line.
Point curve_at(const Figure& figure, const Layout& layout, std::int64_t frame) {
    const double at = static_cast<double>(frame - figure.first) / static_cast<double>(figure.step);
    const auto last = static_cast<std::int64_t>(figure.curve.size()) - 1;
    const std::int64_t left = std::clamp(static_cast<std::int64_t>(std::floor(at)), std::int64_t{0},
                                         std::max<std::int64_t>(0, last - 1));
    const std::int64_t right = std::min(left + 1, last);
    const double share = std::clamp(at - static_cast<double>(left), 0.0, 1.0);
    const Point a = curve_point(figure, layout, left);
    const Point b = curve_point(figure, layout, right);
    const double y = a.y + share * (b.y - a.y);
    return {layout.time(static_cast<double>(frame)), std::isfinite(y) ? y : layout.middle()};
}

void draw_bands(Svg& svg, const Figure& figure, const Layout& layout) {
    for (const stltsa::Interval& unit : figure.units) {
        const double begin = layout.time(static_cast<double>(unit.begin));
        const double end = layout.time(static_cast<double>(unit.end));
        svg.rect({begin, layout.frame.y, end - begin, layout.frame.height},
                 {{"class", "band"}, {"fill", unit_colors(unit.kind).band}});
    }
}

/// A darker band behind the representative cycle, a dashed line at every margin. They end where the
/// postures begin, so that no number lies on a line.
void draw_margins(Svg& svg, const Figure& figure, const Layout& layout) {
    const char* color = unit_colors(STLTSA_UNIT_CYCLIC).line;
    const double top = layout.value.end - curve_air, bottom = layout.value.start + curve_air;
    if (figure.representative >= 0) {
        const auto& cycle = figure.cycles[static_cast<std::size_t>(figure.representative)];
        const double begin = layout.time(static_cast<double>(cycle.begin));
        const double end = layout.time(static_cast<double>(cycle.end));
        svg.rect({begin, layout.frame.y, end - begin, layout.frame.height},
                 {{"fill", color}, {"fill-opacity", 0.12}});
    }
    if (figure.dense())
        return;
    svg.open("g", {{"stroke", color}, {"stroke-width", thin_line}, {"stroke-dasharray", dashes}});
    for (std::size_t i = 0; i < figure.cycles.size(); ++i)
        for (const std::int64_t frame : {figure.cycles[i].begin, figure.cycles[i].end})
            if (i == 0 || frame != figure.cycles[i - 1].end) {
                const double x = layout.time(static_cast<double>(frame));
                svg.line({x, top}, {x, bottom}, {{"class", "margin"}});
            }
    svg.close("g");
}

/// The width of a part of the envelope: a cycle, or a few pixels if there is none.
double envelope_part(const Figure& figure, const Layout& layout) {
    constexpr double least = 4;
    std::int64_t total = 0;
    for (const stltsa::Interval& cycle : figure.cycles)
        total += cycle.end - cycle.begin;
    const double mean = figure.cycles.empty() ? 0
                                              : static_cast<double>(total) /
                                                    static_cast<double>(figure.cycles.size());
    return std::max(least, layout.time(mean) - layout.time(0));
}

/// The outline from the lowest to the highest value in each of `parts` equal parts of the points.
std::vector<Point> envelope_of(const std::vector<Point>& points, std::size_t parts) {
    std::vector<Point> lows, outline;
    for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t from = part * points.size() / parts;
        const std::size_t to = (part + 1) * points.size() / parts;
        const auto begin = points.begin() + static_cast<std::ptrdiff_t>(from);
        const auto end = points.begin() + static_cast<std::ptrdiff_t>(to);
        const auto [low, high] = std::minmax_element(
            begin, end, [](const Point& a, const Point& b) { return a.y < b.y; });
        const double x = part == 0           ? points.front().x
                         : part + 1 == parts ? points.back().x
                                             : 0.5 * (begin->x + (end - 1)->x);
        outline.push_back({x, low->y});
        lows.push_back({x, high->y});
    }
    outline.insert(outline.end(), lows.rbegin(), lows.rend());
    return outline;
}

void draw_curve(Svg& svg, const Figure& figure, const Layout& layout) {
    const double part = envelope_part(figure, layout);
    svg.open("g", {{"fill", "none"}, {"stroke-width", curve_line}, {"stroke-linejoin", "round"}});
    for (const Stretch& stretch : stretches(figure)) {
        std::vector<Point> points;
        for (std::int64_t i = stretch.begin; i < stretch.end; ++i)
            points.push_back(curve_point(figure, layout, i));
        const char* color = unit_colors(stretch.kind).line;
        const auto parts = static_cast<std::size_t>((points.back().x - points.front().x) / part);
        if (constexpr std::size_t fewest = 3; figure.dense() && parts >= fewest)
            svg.polyline(envelope_of(points, parts), {{"class", "envelope"},
                                                      {"fill", color},
                                                      {"fill-opacity", 0.45},
                                                      {"stroke", color},
                                                      {"stroke-width", many_line}});
        else
            svg.polyline(points, {{"class", "curve"}, {"stroke", color}});
    }
    svg.close("g");
}

/// Draws a faint dotted line where there is no curve.
void draw_gaps(Svg& svg, const Figure& figure, const Layout& layout) {
    const auto x_of = [&](std::int64_t sample) {
        return layout.time(static_cast<double>(figure.frame_of(sample)));
    };
    const auto draw = [&](double from, double to) {
        if (constexpr double least = 3; to - from > least)
            svg.line({from, layout.middle()}, {to, layout.middle()},
                     {{"class", "no-curve"},
                      {"stroke", faint_ink},
                      {"stroke-width", thin_line},
                      {"stroke-dasharray", "1 3"}});
    };
    double end = layout.frame.x;
    for (const Stretch& stretch : stretches(figure)) {
        draw(end, x_of(stretch.begin));
        end = x_of(stretch.end);
    }
    draw(end, layout.frame.right());
}

constexpr double number_row = 12; // for the frame number beside a posture

/// A posture above or below the curve, connected to its point.
void draw_posture(Svg& svg, const Figure& figure, const Layout& layout, const Posture& posture,
                  double scale) {
    const double tall = scale * posture_box(*figure.bodies, posture.frame).height;
    const double ground =
        posture.above ? layout.value.end - 14 : layout.frame.bottom() - number_row - 3;
    const Point dot = curve_at(figure, layout, posture.frame);
    const Point tie{posture.x, posture.above ? ground + 3 : ground - tall - 4};
    svg.line(dot, tie,
             {{"class", "tie"}, {"stroke", faint_ink}, {"stroke-width", 0.75 * thin_line}});
    svg.circle(dot, mark_radius, {{"fill", "#ffffff"}, {"stroke", ink}, {"stroke-width", 1.0}});
    draw_stick_figure(svg, *figure.bodies, posture.frame, {posture.x, ground}, scale);
    svg.text_with_halo({posture.x, posture.above ? ground - tall - 4 : ground + number_row},
                       Anchor::middle, std::to_string(posture.frame), small_font, "posture-number");
}

} // namespace

void draw_curve_panel(Svg& svg, const Figure& figure, const Rect& area) {
    constexpr double axis_height = 32;
    constexpr double posture_height = 84;
    const double used = draw_unit_bars(svg, figure, area);
    const Rect frame{area.x, area.y + used, area.width, area.height - used - axis_height};
    const Layout layout = layout_of(figure, frame, figure.bodies ? posture_height : 0);

    draw_bands(svg, figure, layout);
    draw_margins(svg, figure, layout);
    draw_frame(svg, frame);
    draw_x_axis(svg, frame,
                {0, figure.time_of(static_cast<double>(figure.frames)), frame.x, frame.right()}, 12,
                time_title(figure.fps));
    if (figure.curve.empty())
        return;
    if (!stretches(figure).empty())
        draw_y_axis(svg, frame, layout.value, 5, figure.curve_name);
    draw_gaps(svg, figure, layout);
    draw_curve(svg, figure, layout);
    if (!figure.bodies)
        return;
    const PosturePlan plan = plan_postures(figure, frame, posture_height - number_row - 6);
    for (const Posture& posture : plan.postures)
        draw_posture(svg, figure, layout, posture, plan.scale);
}

} // namespace tool::plot
