// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "plot/axes.hpp"
#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/panels.hpp"
#include "plot/scale.hpp"

namespace tool::plot {
namespace {

constexpr double font = small_font;
constexpr int most_numbers = 16;
constexpr double loop_air = 22; // between the frame and the loop, for numbers outside it

/// Points of the samples, with one scale for both axes and the loop centered.
std::vector<Point> loop_points(const stltsa::Matrix& loop, const Rect& area) {
    Range along, up;
    for (std::int64_t i = 0; i < loop.rows; ++i) {
        along.add(loop(i, 0));
        up.add(loop(i, 1));
    }
    const double size = std::max({along.high - along.low, up.high - up.low, 1e-300});
    const double scale = (std::min(area.width, area.height) - 2 * loop_air) / size;
    std::vector<Point> points;
    for (std::int64_t i = 0; i < loop.rows; ++i)
        points.push_back(
            {area.x + 0.5 * area.width + scale * (loop(i, 0) - 0.5 * (along.low + along.high)),
             area.y + 0.5 * area.height - scale * (loop(i, 1) - 0.5 * (up.low + up.high))});
    return points;
}

bool exists(Point point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

void draw_lines(Svg& svg, const Figure& figure, const std::vector<Point>& points) {
    svg.open("g", {{"fill", "none"},
                   {"stroke-linejoin", "round"},
                   {"stroke-width", figure.dense() ? many_line : 0.8 * curve_line},
                   {"stroke-opacity", figure.dense() ? 0.25 : 1.0}});
    for (const Stretch& stretch : stretches(figure)) {
        const auto end = points.begin() + stretch.end;
        const auto first = std::find_if(points.begin() + stretch.begin, end, exists);
        const auto last = std::find_if_not(first, end, exists);
        svg.curve({first, last}, {{"class", "loop"}, {"stroke", unit_colors(stretch.kind).line}});
    }
    svg.close("g");
}

/// The points of the representative cycle.
std::vector<Point> representative_part(const Figure& figure, const std::vector<Point>& points) {
    std::vector<Point> part;
    if (figure.representative < 0)
        return part;
    const auto& cycle = figure.cycles[static_cast<std::size_t>(figure.representative)];
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::int64_t frame = figure.frame_of(static_cast<std::int64_t>(i));
        if (frame >= cycle.begin && frame <= cycle.end && exists(points[i]))
            part.push_back(points[i]);
    }
    return part;
}

/// The points up to the first gap.
std::vector<Point> first_part(const Figure& figure, const std::vector<Point>& points) {
    const auto first = std::ranges::find_if(points, exists);
    const auto piece_of = [&](auto point) {
        return figure.pieces.empty()
                   ? 0
                   : figure.pieces[static_cast<std::size_t>(point - points.begin())];
    };
    auto last = first;
    while (last != points.end() && exists(*last) && piece_of(last) == piece_of(first))
        ++last;
    return {first, last};
}

void draw_representative(Svg& svg, const std::vector<Point>& part) {
    svg.curve(part, {{"class", "representative"},
                     {"fill", "none"},
                     {"stroke", unit_colors(STLTSA_UNIT_CYCLIC).line},
                     {"stroke-width", wide_line},
                     {"stroke-linejoin", "round"},
                     {"stroke-opacity", 0.45}});
}

/// Draws arrowheads along the path, in its direction. Returns their boxes.
std::vector<Rect> draw_arrows(Svg& svg, const std::vector<Point>& path) {
    constexpr int arrows = 3;
    constexpr double size = 4.5;
    std::vector<double> length{0};
    for (std::size_t i = 1; i < path.size(); ++i)
        length.push_back(length.back() +
                         std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y));
    std::vector<Rect> boxes;
    if (constexpr double shortest = 60; path.size() < 3 || length.back() < shortest)
        return boxes;
    for (int arrow = 0; arrow < arrows; ++arrow) {
        const double at = (arrow + 0.5) / arrows * length.back();
        const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
            std::ranges::lower_bound(length, at) - length.begin(), 1, std::ssize(path) - 1));
        const double share = (at - length[i - 1]) / std::max(1e-9, length[i] - length[i - 1]);
        const Point a = path[i - 1], b = path[i];
        const Point tip{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
        const double angle = std::atan2(b.y - a.y, b.x - a.x) * 57.295779513082323;
        svg.add("path", {{"class", "direction"},
                         {"d", "M5 0L-4 4L-2 0L-4 -4Z"},
                         {"transform", "translate(" + number(tip.x) + " " + number(tip.y) +
                                           ") rotate(" + number(angle) + ")"},
                         {"fill", ink}});
        boxes.push_back({tip.x - size, tip.y - size, 2 * size, 2 * size});
    }
    return boxes;
}

struct Numbered {
    std::int64_t frame = 0;
    Point at;
};

/// Round frame numbers and their points on the loop, interpolated between samples.
std::vector<Numbered> numbered_points(const Figure& figure, const std::vector<Point>& points) {
    const auto last = static_cast<std::int64_t>(points.size()) - 1;
    const std::int64_t drawn = std::ranges::count_if(points, exists) - 1;
    const double span = static_cast<double>(std::max<std::int64_t>(1, drawn * figure.step));
    const auto every = static_cast<std::int64_t>(std::max(1.0, nice_step(span, most_numbers)));
    std::vector<Numbered> numbered;
    for (std::int64_t frame = (figure.first + every - 1) / every * every;
         frame <= figure.frame_of(last); frame += every) {
        const std::int64_t left = (frame - figure.first) / figure.step;
        const double share = static_cast<double>((frame - figure.first) % figure.step) /
                             static_cast<double>(figure.step);
        const Point a = points[static_cast<std::size_t>(left)];
        const Point b = points[static_cast<std::size_t>(std::min(left + 1, last))];
        if (exists(a) && exists(b))
            numbered.push_back({frame, {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}});
    }
    return numbered;
}

/// Positions for a text around its point: near ones first, of these the one closest to direction
/// `outward`.
std::vector<Rect> places(Point at, double width, Point outward) {
    constexpr double height = font;
    struct Place {
        double cost;
        Rect box;
    };
    std::vector<Place> found;
    for (const double distance : {4.0, 8.0})
        for (int i = 0; i < 8; ++i) {
            const double angle = i * 0.78539816339744831;
            const Point direction{std::cos(angle), std::sin(angle)};
            const Point middle{at.x + direction.x * (distance + 0.5 * width),
                               at.y + direction.y * (distance + 0.5 * height)};
            found.push_back({distance - direction.x * outward.x - direction.y * outward.y,
                             {middle.x - 0.5 * width, middle.y - 0.5 * height, width, height}});
        }
    std::ranges::stable_sort(found, {}, &Place::cost);
    std::vector<Rect> boxes;
    for (const Place& place : found)
        boxes.push_back(place.box);
    return boxes;
}

/// Points on the lines, close enough together that no line passes a number unnoticed.
std::vector<Point> close_points(const std::vector<Point>& points) {
    constexpr double most_apart = 2;
    std::vector<Point> result;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point a = points[i];
        const Point b = points[i + 1];
        if (!exists(a) || !exists(b))
            continue;
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const int parts = std::max(1, static_cast<int>(length / most_apart));
        for (int part = 0; part < parts; ++part) {
            const double share = static_cast<double>(part) / parts;
            result.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
        }
    }
    return result;
}

bool holds_any(const Rect& box, const std::vector<Point>& points) {
    constexpr double around = 1.5; // half the width of a line, and a little
    return std::ranges::any_of(points, [&](const Point& p) {
        return p.x > box.x - around && p.x < box.right() + around && p.y > box.y - around &&
               p.y < box.bottom() + around;
    });
}

bool holds(const Rect& area, const Rect& box) {
    return box.x >= area.x && box.right() <= area.right() && box.y >= area.y &&
           box.bottom() <= area.bottom();
}

Point away_from(Point center, Point at) {
    const double length = std::max(1e-9, std::hypot(at.x - center.x, at.y - center.y));
    return {(at.x - center.x) / length, (at.y - center.y) / length};
}

/// Writes texts where they cover neither each other nor a line; omits those without room.
class Writer {
  public:
    Writer(Svg& svg, const Rect& area, const std::vector<Point>& points)
        : svg_(svg), area_(area), line_(close_points(points)), center_{area.x + 0.5 * area.width,
                                                                       area.y + 0.5 * area.height} {
    }

    void keep_free(const Rect& box) { space_.take(box); }

    /// Whether there was room.
    bool write(const std::string& text, Point at, std::string_view its_class) {
        const auto boxes = places(at, text_width(text, font), away_from(center_, at));
        const auto box = std::ranges::find_if(boxes, [&](const Rect& place) {
            return holds(area_, place) && space_.free(place) && !holds_any(place, line_);
        });
        if (box == boxes.end())
            return false;
        space_.take(*box);
        svg_.text_with_halo({box->x + 0.5 * box->width, box->bottom() - 1.2}, Anchor::middle, text,
                            font, its_class);
        return true;
    }

  private:
    Svg& svg_;
    Rect area_;
    std::vector<Point> line_;
    Point center_;
    LabelSpace space_;
};

Rect around(Point at, double size) {
    return {at.x - size, at.y - size, 2 * size, 2 * size};
}

void draw_start(Svg& svg, Point at) {
    const Rect box = around(at, 3);
    svg.rect(box,
             {{"class", "start"}, {"fill", ink}, {"stroke", "#ffffff"}, {"stroke-width", 0.7}});
}

void draw_numbers(Svg& svg, const Figure& figure, const std::vector<Point>& points,
                  Writer& writer) {
    const auto start = std::ranges::find_if(points, exists);
    if (start == points.end())
        return;
    const std::vector<Numbered> numbered = numbered_points(figure, points);
    for (const auto& [frame, at] : numbered)
        writer.keep_free(around(at, 2));
    writer.keep_free(around(*start, 3.5));
    draw_start(svg, *start);
    writer.write("start", *start, "start-text");
    for (const auto& [frame, at] : numbered)
        if (frame > 0 && writer.write(std::to_string(frame), at, "number"))
            svg.circle(at, mark_radius,
                       {{"fill", unit_colors(figure.unit_at(frame)).line},
                        {"stroke", "#ffffff"},
                        {"stroke-width", 0.7}});
}

} // namespace

double draw_loop_panel(Svg& svg, const Figure& figure, const Rect& area) {
    draw_frame(svg, area);
    const std::vector<Point> points = loop_points(figure.loop, area);
    const std::vector<Point> representative = representative_part(figure, points);
    draw_representative(svg, representative);
    draw_lines(svg, figure, points);
    Writer writer(svg, area, points);
    for (const Rect& arrow :
         draw_arrows(svg, representative.empty() ? first_part(figure, points) : representative))
        writer.keep_free(arrow);
    draw_numbers(svg, figure, points, writer);
    svg.text({area.x + 0.5 * area.width, area.bottom() + 14}, Anchor::middle,
             figure.loop_names.at(0), {{"class", "axis-title"}});
    draw_upward(svg, {area.x - 8, area.y + 0.5 * area.height}, figure.loop_names.at(1));
    double y = area.bottom() + 18;
    std::string note = figure.loop_note;
    if (figure.cycles.size() > 1)
        note += std::string(note.empty() ? "" : " ") +
                "The curve drifts slowly, so even equal cycles lie side by side: the width of the "
                "loop shows drift as well as difference.";
    if (!note.empty())
        for (const std::string& line : lines_of(note, font, area.width))
            svg.text({area.x, y += 12}, Anchor::start, line,
                     {{"class", "caption"}, {"font-size", font}, {"fill", faint_ink}});
    return y;
}

} // namespace tool::plot
