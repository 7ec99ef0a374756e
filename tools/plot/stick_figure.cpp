// SPDX-License-Identifier: BSD-3-Clause
#include "plot/stick_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plot/palette.hpp"

namespace tool::plot {
namespace {

/// All bones of one depth as one path, one element of one color.
std::string bones_path(const SideView& view, const std::vector<Point>& points, Depth depth) {
    std::string path;
    for (const Bone& bone : view.bones())
        if (bone.depth == depth)
            path += fmt::format("M{} {}L{} {}", number(points[bone.from].x),
                                number(points[bone.from].y), number(points[bone.to].x),
                                number(points[bone.to].y));
    return path;
}

void draw_head(Svg& svg, const Head& head, const std::vector<Point>& points, double scale) {
    const Point& neck = points[head.from];
    const Point& crown = points[head.to];
    const double length = std::hypot(crown.x - neck.x, crown.y - neck.y);
    const double radius = scale * head.radius;
    const double share = length > 0 ? std::max(0.5, radius / length) : 0;
    svg.circle({neck.x + share * (crown.x - neck.x), neck.y + share * (crown.y - neck.y)}, radius,
               {{"class", "head"}, {"fill", ink}, {"stroke", "none"}});
}

} // namespace

Rect posture_box(const SideView& view, std::int64_t frame) {
    const std::vector<Point> points = view.posture(frame);
    const auto [left, right] = std::ranges::minmax_element(points, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax_element(points, {}, &Point::y);
    const double bottom = std::min(0.0, low->y);
    // The head may reach higher than the joints.
    const double top = high->y + (view.head() ? view.head()->radius : 0);
    return {left->x, bottom, right->x - left->x, top - bottom};
}

void draw_stick_figure(Svg& svg, const SideView& view, std::int64_t frame, Point ground,
                       double scale) {
    const Rect box = posture_box(view, frame);
    std::vector<Point> points = view.posture(frame);
    for (Point& point : points)
        point = {ground.x + scale * (point.x - box.x - 0.5 * box.width),
                 ground.y - scale * point.y};
    svg.open("g", {{"class", "posture"},
                   {"data-frame", std::to_string(frame)},
                   {"fill", "none"},
                   {"stroke-width", 0.85 * curve_line},
                   {"stroke-linecap", "round"},
                   {"stroke-linejoin", "round"}});
    for (const auto& [depth, color] :
         {std::pair{Depth::far, far_limb}, {Depth::middle, ink}, {Depth::near, ink}})
        if (const std::string path = bones_path(view, points, depth); !path.empty())
            svg.add("path", {{"d", path}, {"stroke", color}});
    if (view.head())
        draw_head(svg, *view.head(), points, scale);
    svg.close("g");
}

} // namespace tool::plot
