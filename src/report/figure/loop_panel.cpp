// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "report/figure/panels.hpp"

namespace stltsa::report {
namespace {

/// Which parts of a panel are taken.
struct Space {
    Rect area;
    std::vector<Rect> taken = {};

    bool is_free(const Rect& box) const {
        return box.x >= area.x && box.right() <= area.right() && box.y >= area.y &&
               box.bottom() <= area.bottom() && std::ranges::none_of(taken, [&](const Rect& other) {
                   return box.x < other.right() && other.x < box.right() &&
                          box.y < other.bottom() && other.y < box.bottom();
               });
    }
    void take(Point at, double size) {
        taken.push_back({at.x - size, at.y - size, 2 * size, 2 * size});
    }
};

/// Writes a text beside its point where it covers neither lines nor other texts, if there is room:
/// near places first, of these the one farthest from the center.
bool write(Svg& svg, Space& space, Point at, const std::string& text, const char* its_class) {
    const Point center = space.area.middle();
    const double width = text_width(text, small_font), out = std::max(1e-9, distance(center, at));
    std::vector<std::pair<double, Rect>> places;
    for (const double away : {4.0, 8.0})
        for (int i = 0; i < 8; ++i) {
            const double x = std::cos(i * turn / 8), y = std::sin(i * turn / 8);
            places.push_back(
                {away - (x * (at.x - center.x) + y * (at.y - center.y)) / out,
                 {at.x + x * (away + 0.5 * width) - 0.5 * width,
                  at.y + y * (away + 0.5 * small_font) - 0.5 * small_font, width, small_font}});
        }
    std::ranges::stable_sort(places, {}, &std::pair<double, Rect>::first);
    const auto place = std::ranges::find_if(
        places, [&](const auto& tried) { return space.is_free(tried.second); });
    if (place == places.end())
        return false;
    const Rect& box = place->second;
    // Two numbers side by side must not look like one.
    space.taken.push_back({box.x - 4, box.y, box.width + 8, box.height});
    svg.number_text({box.x + 0.5 * width, box.bottom() - 1.2}, text, its_class);
    return true;
}

/// Three arrowheads along a path, in its direction.
void draw_arrows(Svg& svg, Space& space, const std::vector<Point>& path) {
    double length = 0, passed = 0, next = 1.0 / 6;
    for (std::size_t i = 1; i < path.size(); ++i)
        length += distance(path[i - 1], path[i]);
    for (std::size_t i = 1; i < path.size() && length > 60; ++i) {
        const double before = passed;
        passed += distance(path[i - 1], path[i]);
        if (passed < next * length)
            continue;
        const Point tip =
            between(path[i - 1], path[i], (next * length - before) / (passed - before));
        next += 1.0 / 3;
        const double x = path[i].x - path[i - 1].x, y = path[i].y - path[i - 1].y;
        space.take(tip, 4.5);
        svg.path("M5 0L-4 4L-2 0L-4 -4Z",
                 fill("direction", ink, 1,
                      format_text(" transform=\"translate({} {}) rotate({})\"", number(tip.x),
                                  number(tip.y), number(std::atan2(y, x) * 360 / turn))));
    }
}

} // namespace

void draw_loop(Svg& svg, const Figure& figure, const Rect& area) {
    Range along, up;
    for (std::int64_t i = figure.begin; i < figure.end; ++i)
        along.add(figure.rows(i, 1)), up.add(figure.rows(i, 2));
    const double half = 0.5 * std::max({along.high - along.low, up.high - up.low, 1e-300});
    const double x_middle = 0.5 * (along.low + along.high), y_middle = 0.5 * (up.low + up.high);
    const Scale x{x_middle - half, x_middle + half, area.x + 22, area.right() - 22};
    const Scale y{y_middle - half, y_middle + half, area.bottom() - 22, area.y + 22};
    Space space{area};
    std::vector<Point> points, typical; // all, and those of the representative cycle
    for (std::int64_t i = figure.begin; i < figure.end; ++i) {
        const Point at{x(figure.rows(i, 1)), y(figure.rows(i, 2))};
        const Point from = points.empty() ? at : points.back();
        for (double way = 0, step = distance(from, at); way < step; way += 2)
            space.take(between(from, at, way / step), 1.5);
        points.push_back(at);
        if (figure.chosen != nullptr && figure.frame_of(i) >= figure.chosen->begin &&
            figure.frame_of(i) <= figure.chosen->end)
            typical.push_back(at);
    }
    draw_frame(svg, area);
    svg.curve(typical, stroke("representative", unit_color(STLTSA_UNIT_CYCLIC), 4,
                              " stroke-opacity=\"0.45\" stroke-linejoin=\"round\""));
    const std::vector<Stretch> parts = stretches(figure, figure.begin, figure.end);
    for (const Stretch& part : parts)
        svg.curve(
            {points.begin() + part.begin - figure.begin, points.begin() + part.end - figure.begin},
            stroke("loop", part.color, figure.dense ? 0.7 : 0.8 * bold_line,
                   figure.dense ? " stroke-opacity=\"0.25\"" : ""));
    draw_arrows(svg, space, typical.empty() ? points : typical);
    const Point start = points.front();
    svg.rect({start.x - 3, start.y - 3, 6, 6}, fill("start", ink, 1, " stroke=\"#ffffff\""));
    space.take(start, 3.5);
    write(svg, space, start, "start", "start-text");
    const auto every = std::max<std::int64_t>(1, std::ssize(points) / 16);
    for (const Stretch& part : parts)
        for (std::int64_t i = (part.begin / every + 1) * every; i < part.end; i += every) {
            const Point at = points[static_cast<std::size_t>(i - figure.begin)];
            if (write(svg, space, at, format_text("{}", figure.frame_of(i)), "number"))
                svg.circle(at, 2.2, fill("numbered", part.color, 1, " stroke=\"#ffffff\""));
        }
    svg.text({area.middle().x, area.bottom() + 14}, "middle", "first coordinate of the loop",
             fill("axis-title", ink));
    draw_upward(svg, {area.x - 8, area.middle().y}, "second coordinate of the loop");
}

} // namespace stltsa::report
