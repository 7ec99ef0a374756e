// SPDX-License-Identifier: BSD-3-Clause
#include "plot/figure.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "plot/panels.hpp"
#include "plot/title.hpp"

namespace tool::plot {
namespace {

// One unit is a quarter of a millimeter when the figure is printed 180 mm wide.
constexpr double width = 720;
constexpr double left = 54;
constexpr double right = 14;

} // namespace

std::int32_t Figure::unit_at(std::int64_t frame) const {
    for (const stltsa::Interval& unit : units)
        if (frame >= unit.begin && frame < unit.end)
            return unit.kind;
    return 0;
}

bool Figure::dense() const {
    constexpr std::size_t most_cycles = 40;
    constexpr std::size_t most_samples = 6000;
    return cycles.size() > most_cycles || curve.size() > most_samples;
}

bool Figure::several() const {
    return std::ranges::count_if(segments, [](const stltsa::Segment& segment) {
               return segment.kind != STLTSA_SEGMENT_REST;
           }) > 1;
}

void Range::add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
}

Range Range::wide() const {
    if (low < high)
        return *this;
    return low > high ? Range{-1, 1} : Range{low - 0.5, high + 0.5};
}

std::vector<Stretch> stretches(const Figure& figure) {
    std::vector<Stretch> result;
    bool joined = false; // with the sample before
    for (std::int64_t i = 0; i < std::ssize(figure.curve); ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (!std::isfinite(figure.curve[at])) {
            joined = false;
            continue;
        }
        const std::int32_t kind = figure.unit_at(figure.frame_of(i));
        joined = joined && (figure.pieces.empty() || figure.pieces[at] == figure.pieces[at - 1]);
        if (joined)
            result.back().end = i + 1;
        if (!joined || kind != result.back().kind)
            result.push_back({i, i + 1, kind});
        joined = true;
    }
    return result;
}

std::string figure_svg(const Figure& figure) {
    Svg svg;
    double y = draw_title(svg, figure.title, figure.summary, left, width - right) + 12;
    const double curve_height = figure.bodies ? 370 : 240;
    draw_curve_panel(svg, figure, {left, y, width - left - right, curve_height});
    y += curve_height + 20;

    constexpr double heading = 18;
    if (figure.dense() && figure.overlaid) {
        constexpr double half = 0.5 * (width - left - right) - 24;
        constexpr double height = 150;
        draw_overlay(svg, figure, {left, y + heading, half, height});
        draw_zoom(svg, figure, {width - right - half, y + heading, half, height});
        y += heading + height + 50;
    }

    constexpr double loop_side = 270;
    constexpr double key_left = left + loop_side + 30;
    const bool loop = !figure.loop.values.empty();
    double bottom = y;
    if (loop)
        bottom = draw_loop_panel(svg, figure, {left, y, loop_side, loop_side});
    const double x = loop ? key_left : left;
    y = draw_key(svg, figure, {x, y, width - right - x, loop_side});
    if (constexpr std::size_t fewest = 3; figure.cycles.size() >= fewest) {
        constexpr double least_height = 64, margin = 46, axis = 32;
        const double height = std::max(least_height, bottom - y - heading - axis);
        draw_cycle_times(svg, figure,
                         {x + margin, y + heading, width - right - x - margin, height});
        y += heading + height + axis;
    }
    return svg.document(width, std::max(y, bottom) + 14, figure.title);
}

} // namespace tool::plot
