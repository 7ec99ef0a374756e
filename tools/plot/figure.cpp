// SPDX-License-Identifier: BSD-3-Clause
#include "plot/figure.hpp"

#include <algorithm>

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

std::vector<Stretch> stretches(const Figure& figure) {
    std::vector<Stretch> result;
    const auto samples = std::max(static_cast<std::int64_t>(figure.curve.size()), figure.loop.rows);
    const auto piece = [&](std::int64_t i) {
        return figure.pieces.empty() ? 0 : figure.pieces[static_cast<std::size_t>(i)];
    };
    for (std::int64_t i = 0; i < samples; ++i) {
        const std::int32_t kind = figure.unit_at(figure.frame_of(i));
        const bool joined = i > 0 && piece(i) == piece(i - 1);
        if (joined)
            result.back().end = i + 1;
        if (!joined || kind != result.back().kind)
            result.push_back({i, i + 1, kind});
    }
    return result;
}

std::string figure_svg(const Figure& figure) {
    Svg svg;
    double y = draw_title(svg, figure.title, figure.summary, left, width - right) + 12;
    const double curve_height = figure.bodies ? 370 : 240;
    draw_curve_panel(svg, figure, {left, y, width - left - right, curve_height});
    y += curve_height + 20;

    constexpr double loop_side = 270;
    constexpr double key_left = left + loop_side + 30;
    const bool loop = !figure.loop.values.empty();
    if (loop)
        draw_loop_panel(svg, figure, {left, y, loop_side, loop_side});
    draw_key(svg, figure, {loop ? key_left : left, y, width - right - key_left, loop_side});
    return svg.document(width, y + loop_side + 24, figure.title);
}

} // namespace tool::plot
