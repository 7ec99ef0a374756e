// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"
#include "plot/postures.hpp"
#include "plot/scale.hpp"
#include "plot/stick_figure.hpp"

namespace tool::plot {
namespace {

constexpr double small_font = 9.5;

/// Layout: bars above the frame; inside it postures, the curve, postures.
struct Layout {
    Rect frame;
    Scale time;  ///< frame number to x
    Scale value; ///< curve value to y
};

std::pair<double, double> range_of(const std::vector<double>& values) {
    double low = INFINITY;
    double high = -HUGE_VAL;
    for (const double v : values)
        if (std::isfinite(v)) {
            low = std::min(low, v);
            high = std::max(high, v);
        }
    if (!(low < high))
        return {low - 1, low + 1};
    return {low, high};
}

Layout layout_of(const Figure& figure, const Rect& frame, double posture_height) {
    const auto [low, high] = range_of(figure.curve);
    constexpr double air = 12;
    return {frame,
            {0, static_cast<double>(figure.frames), frame.x, frame.right()},
            {low, high, frame.bottom() - posture_height - air, frame.y + posture_height + air}};
}

Point curve_point(const Figure& figure, const Layout& layout, std::int64_t sample) {
    return {layout.time(static_cast<double>(figure.frame_of(sample))),
            layout.value(figure.curve[static_cast<std::size_t>(sample)])};
}

/// The point of the curve at a frame, interpolated between samples.
Point curve_at(const Figure& figure, const Layout& layout, std::int64_t frame) {
    const double at = static_cast<double>(frame - figure.first) / static_cast<double>(figure.step);
    const auto last = static_cast<std::int64_t>(figure.curve.size()) - 1;
    const std::int64_t left = std::clamp(static_cast<std::int64_t>(std::floor(at)), std::int64_t{0},
                                         std::max<std::int64_t>(0, last - 1));
    const std::int64_t right = std::min(left + 1, last);
    const double share = std::clamp(at - static_cast<double>(left), 0.0, 1.0);
    const Point a = curve_point(figure, layout, left);
    const Point b = curve_point(figure, layout, right);
    return {layout.time(static_cast<double>(frame)), a.y + share * (b.y - a.y)};
}

void draw_bands(Svg& svg, const Figure& figure, const Layout& layout) {
    for (const stltsa::Interval& unit : figure.units) {
        const double begin = layout.time(static_cast<double>(unit.begin));
        const double end = layout.time(static_cast<double>(unit.end));
        svg.rect({begin, layout.frame.y, end - begin, layout.frame.height},
                 {{"class", "band"}, {"fill", unit_colors(unit.kind).band}});
    }
}

/// A darker band behind the representative cycle, a dashed line at every margin.
void draw_margins(Svg& svg, const Figure& figure, const Layout& layout) {
    const char* color = unit_colors(STLTSA_UNIT_CYCLIC).line;
    if (figure.representative >= 0) {
        const auto& cycle = figure.cycles[static_cast<std::size_t>(figure.representative)];
        const double begin = layout.time(static_cast<double>(cycle.begin));
        const double end = layout.time(static_cast<double>(cycle.end));
        svg.rect({begin, layout.frame.y, end - begin, layout.frame.height},
                 {{"fill", color}, {"fill-opacity", 0.12}});
    }
    svg.open("g", {{"stroke", color}, {"stroke-width", 0.8}, {"stroke-dasharray", "3 2.5"}});
    for (std::size_t i = 0; i < figure.cycles.size() && cycles_fit(figure, layout.frame); ++i)
        for (const std::int64_t frame : {figure.cycles[i].begin, figure.cycles[i].end})
            if (i == 0 || frame != figure.cycles[i - 1].end) {
                const double x = layout.time(static_cast<double>(frame));
                svg.line({x, layout.frame.y}, {x, layout.frame.bottom()}, {});
            }
    svg.close("g");
}

void draw_curve(Svg& svg, const Figure& figure, const Layout& layout) {
    svg.open("g", {{"fill", "none"}, {"stroke-width", 1.8}, {"stroke-linejoin", "round"}});
    for (const Stretch& stretch : stretches(figure)) {
        std::vector<Point> points;
        for (std::int64_t i = stretch.begin; i < stretch.end; ++i)
            points.push_back(curve_point(figure, layout, i));
        svg.polyline(points, {{"stroke", unit_colors(stretch.kind).line}});
    }
    svg.close("g");
}

void draw_time_axis(Svg& svg, const Figure& figure, const Layout& layout) {
    const double bottom = layout.frame.bottom();
    const double to = figure.time_of(static_cast<double>(figure.frames));
    const Scale time{0, to, layout.frame.x, layout.frame.right()};
    for (const Tick& tick : nice_ticks(0, to, 12)) {
        const double x = time(tick.value);
        svg.line({x, bottom}, {x, bottom + 4}, {{"stroke", ink}, {"stroke-width", 0.8}});
        svg.text({x, bottom + 15}, Anchor::middle, tick.label,
                 {{"class", "tick"}, {"font-size", small_font}});
    }
    svg.text({layout.frame.x + 0.5 * layout.frame.width, bottom + 28}, Anchor::middle,
             figure.fps > 0 ? "time in seconds" : "frame");
}

void draw_value_axis(Svg& svg, const Figure& figure, const Layout& layout) {
    const double x = layout.frame.x;
    for (const Tick& tick : nice_ticks(layout.value.from, layout.value.to, 5)) {
        const double y = layout.value(tick.value);
        svg.line({x - 4, y}, {x, y}, {{"stroke", ink}, {"stroke-width", 0.8}});
        svg.text({x - 6, y + 3.5}, Anchor::end, tick.label, {{"font-size", small_font}});
    }
    const double middle = 0.5 * (layout.value.start + layout.value.end);
    svg.open("g", {{"transform",
                    "translate(" + number(x - 36) + " " + number(middle) + ") rotate(-90)"}});
    svg.text({0, 0}, Anchor::middle, figure.curve_name);
    svg.close("g");
}

constexpr double number_row = 12; // for the frame number beside a posture

/// One posture above (even slots) or below (odd slots) the curve, connected to its point.
void draw_posture(Svg& svg, const Figure& figure, const Layout& layout, const PosturePlan& plan,
                  std::size_t slot) {
    const std::int64_t frame = plan.frames[slot];
    const bool above = slot % 2 == 0;
    const double width = layout.frame.width / static_cast<double>(plan.frames.size());
    const double x = layout.frame.x + (static_cast<double>(slot) + 0.5) * width;
    const double tall = plan.scale * posture_box(*figure.bodies, frame).height;
    const double ground = above ? layout.value.end - 14 : layout.frame.bottom() - number_row - 3;
    const Point dot = curve_at(figure, layout, frame);
    const Point tie{x, above ? ground + 3 : ground - tall - 4};
    svg.line(dot, tie, {{"stroke", faint_ink}, {"stroke-width", 0.6}});
    svg.circle(dot, 2.2, {{"fill", "#ffffff"}, {"stroke", ink}, {"stroke-width", 1.0}});
    draw_stick_figure(svg, *figure.bodies, frame, {x, ground}, plan.scale);
    svg.text_with_halo({x, above ? ground - tall - 4 : ground + number_row}, Anchor::middle,
                       std::to_string(frame), small_font, "posture-number");
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
    svg.rect(frame,
             {{"class", "frame"}, {"fill", "none"}, {"stroke", hairline}, {"stroke-width", 0.8}});
    draw_time_axis(svg, figure, layout);
    if (figure.curve.empty())
        return;
    draw_value_axis(svg, figure, layout);
    draw_curve(svg, figure, layout);
    if (!figure.bodies)
        return;
    const PosturePlan plan = plan_postures(figure, area.width, posture_height - number_row - 6);
    for (std::size_t slot = 0; slot < plan.frames.size(); ++slot)
        draw_posture(svg, figure, layout, plan, slot);
}

} // namespace tool::plot
