// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"
#include "plot/scale.hpp"

namespace tool::plot {
namespace {

constexpr double font = 9.5;
constexpr int most_numbers = 16;
constexpr double air = 22; // between the frame and the loop, for numbers outside it

/// Points of the samples, with one scale for both axes and the loop centered.
std::vector<Point> loop_points(const stltsa::Matrix& loop, const Rect& area) {
    Point low{INFINITY, INFINITY};
    Point high{-HUGE_VAL, -HUGE_VAL};
    for (std::int64_t i = 0; i < loop.rows; ++i) {
        low = {std::min(low.x, loop(i, 0)), std::min(low.y, loop(i, 1))};
        high = {std::max(high.x, loop(i, 0)), std::max(high.y, loop(i, 1))};
    }
    const double size = std::max({high.x - low.x, high.y - low.y, 1e-300});
    const double scale = (std::min(area.width, area.height) - 2 * air) / size;
    std::vector<Point> points;
    for (std::int64_t i = 0; i < loop.rows; ++i)
        points.push_back(
            {area.x + 0.5 * area.width + scale * (loop(i, 0) - 0.5 * (low.x + high.x)),
             area.y + 0.5 * area.height - scale * (loop(i, 1) - 0.5 * (low.y + high.y))});
    return points;
}

void draw_lines(Svg& svg, const Figure& figure, const std::vector<Point>& points) {
    const bool many = points.size() > 600;
    svg.open("g", {{"fill", "none"},
                   {"stroke-linejoin", "round"},
                   {"stroke-width", many ? 0.9 : 1.5},
                   {"stroke-opacity", many ? 0.75 : 1.0}});
    for (const Stretch& stretch : stretches(figure)) {
        const auto begin = points.begin() + stretch.begin;
        const auto end = points.begin() + stretch.end;
        svg.polyline({begin, end}, {{"stroke", unit_colors(stretch.kind).line}});
    }
    svg.close("g");
}

void draw_representative(Svg& svg, const Figure& figure, const std::vector<Point>& points) {
    if (figure.representative < 0)
        return;
    const auto& cycle = figure.cycles[static_cast<std::size_t>(figure.representative)];
    std::vector<Point> part;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::int64_t frame = figure.frame_of(static_cast<std::int64_t>(i));
        if (frame >= cycle.begin && frame <= cycle.end)
            part.push_back(points[i]);
    }
    svg.polyline(part, {{"fill", "none"},
                        {"stroke", unit_colors(STLTSA_UNIT_CYCLIC).line},
                        {"stroke-width", 3.2},
                        {"stroke-linejoin", "round"},
                        {"stroke-opacity", 0.45}});
}

struct Numbered {
    std::int64_t frame = 0;
    Point at;
};

/// Round frame numbers and their points on the loop, interpolated between samples.
std::vector<Numbered> numbered_points(const Figure& figure, const std::vector<Point>& points) {
    const auto last = static_cast<std::int64_t>(points.size()) - 1;
    const double span = static_cast<double>(std::max<std::int64_t>(1, last * figure.step));
    const auto every = static_cast<std::int64_t>(std::max(1.0, nice_step(span, most_numbers)));
    std::vector<Numbered> numbered;
    for (std::int64_t frame = (figure.first + every - 1) / every * every;
         frame <= figure.frame_of(last); frame += every) {
        const std::int64_t left = (frame - figure.first) / figure.step;
        const double share = static_cast<double>((frame - figure.first) % figure.step) /
                             static_cast<double>(figure.step);
        const Point a = points[static_cast<std::size_t>(left)];
        const Point b = points[static_cast<std::size_t>(std::min(left + 1, last))];
        numbered.push_back({frame, {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}});
    }
    return numbered;
}

/// The eight positions for a number around its point, closest to direction `outward` first.
std::vector<Rect> places(Point at, double width, Point outward) {
    constexpr double height = font;
    constexpr double distance = 4;
    struct Place {
        double fit;
        Rect box;
    };
    std::vector<Place> found;
    for (int i = 0; i < 8; ++i) {
        const double angle = i * 0.78539816339744831;
        const Point direction{std::cos(angle), std::sin(angle)};
        const Point middle{at.x + direction.x * (distance + 0.5 * width),
                           at.y + direction.y * (distance + 0.5 * height)};
        found.push_back({direction.x * outward.x + direction.y * outward.y,
                         {middle.x - 0.5 * width, middle.y - 0.5 * height, width, height}});
    }
    std::ranges::stable_sort(found, std::greater{}, &Place::fit);
    std::vector<Rect> boxes;
    for (const Place& place : found)
        boxes.push_back(place.box);
    return boxes;
}

/// Points on the lines, close enough together that no line passes a number unnoticed.
std::vector<Point> dense(const std::vector<Point>& points) {
    constexpr double most_apart = 2;
    std::vector<Point> result;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point a = points[i];
        const Point b = points[i + 1];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const int parts = std::max(1, static_cast<int>(length / most_apart));
        for (int part = 0; part < parts; ++part) {
            const double share = static_cast<double>(part) / parts;
            result.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
        }
    }
    return result;
}

std::size_t points_inside(const std::vector<Point>& points, const Rect& box) {
    return static_cast<std::size_t>(std::ranges::count_if(points, [&](const Point& p) {
        return p.x > box.x && p.x < box.right() && p.y > box.y && p.y < box.bottom();
    }));
}

Point away_from(Point center, Point at) {
    const double length = std::max(1e-9, std::hypot(at.x - center.x, at.y - center.y));
    return {(at.x - center.x) / length, (at.y - center.y) / length};
}

/// Writes a number where it covers no other number and as little of the curve as possible; omits it
/// if there is no room.
void draw_number(Svg& svg, const std::string& text, Point at, Point outward,
                 const std::vector<Point>& line, LabelSpace& space) {
    const Rect* best = nullptr;
    std::size_t covered = 0;
    const std::vector<Rect> boxes = places(at, text_width(text, font), outward);
    for (const Rect& box : boxes)
        if (space.free(box))
            if (const std::size_t here = points_inside(line, box);
                best == nullptr || here < covered) {
                best = &box;
                covered = here;
            }
    if (best == nullptr)
        return;
    space.take(*best);
    svg.text_with_halo({best->x + 0.5 * best->width, best->bottom() - 1.2}, Anchor::middle, text,
                       font, "number");
}

void draw_numbers(Svg& svg, const Figure& figure, const std::vector<Point>& points,
                  const Rect& area) {
    const Point center{area.x + 0.5 * area.width, area.y + 0.5 * area.height};
    const std::vector<Numbered> numbered = numbered_points(figure, points);
    const std::vector<Point> line = dense(points);
    LabelSpace space;
    for (const auto& [frame, at] : numbered)
        space.take({at.x - 2, at.y - 2, 4, 4});
    for (const auto& [frame, at] : numbered) {
        svg.circle(at, 2.2,
                   {{"fill", unit_colors(figure.unit_at(frame)).line},
                    {"stroke", "#ffffff"},
                    {"stroke-width", 0.7}});
        draw_number(svg, std::to_string(frame), at, away_from(center, at), line, space);
    }
}

} // namespace

void draw_loop_panel(Svg& svg, const Figure& figure, const Rect& area) {
    svg.rect(area, {{"fill", "none"}, {"stroke", hairline}, {"stroke-width", 0.8}});
    const std::vector<Point> points = loop_points(figure.loop, area);
    draw_representative(svg, figure, points);
    draw_lines(svg, figure, points);
    draw_numbers(svg, figure, points, area);
    svg.text({area.x + 0.5 * area.width, area.bottom() + 14}, Anchor::middle,
             figure.loop_names.at(0));
    svg.open("g", {{"transform", "translate(" + number(area.x - 8) + " " +
                                     number(area.y + 0.5 * area.height) + ") rotate(-90)"}});
    svg.text({0, 0}, Anchor::middle, figure.loop_names.at(1));
    svg.close("g");
}

} // namespace tool::plot
