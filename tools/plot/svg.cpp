// SPDX-License-Identifier: BSD-3-Clause
#include "plot/svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/utf8.hpp"

namespace tool::plot {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD in UTF-8

/// Control characters are invisible and mostly forbidden in XML 1.0, which forbids U+FFFE and
/// U+FFFF as well.
bool is_forbidden(std::string_view character) {
    return stltsa::is_control(character) || character == "\xEF\xBF\xBE" ||
           character == "\xEF\xBF\xBF";
}

std::string_view escape_of(std::string_view character) {
    switch (character[0]) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return is_forbidden(character) ? replacement : "";
    }
}

/// Points closer than this to the previous one are indistinguishable from it.
constexpr double finest = 0.1;

/// The points without those, except that the first and the last stay.
std::vector<Point> distinct(const std::vector<Point>& points) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& p = points[i];
        const bool end = i == 0 || i + 1 == points.size();
        if (end || std::hypot(p.x - kept.back().x, p.y - kept.back().y) >= finest)
            kept.push_back(p);
    }
    return kept;
}

} // namespace

std::string number(double value) {
    std::string text = fmt::format("{:.2f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string escaped(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = stltsa::utf8_length(text, 0);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
        const std::string_view escape = length == 0 ? replacement : escape_of(character);
        result += escape.empty() ? character : escape;
        text.remove_prefix(character.size());
    }
    return result;
}

void Svg::start(std::string_view element, Attributes attributes) {
    start(element, {}, attributes);
}

void Svg::start(std::string_view element, Attributes geometry, Attributes attributes) {
    body_ += fmt::format("<{}", element);
    for (const Attributes& list : {geometry, attributes})
        for (const Attribute& attribute : list)
            body_ += fmt::format(" {}=\"{}\"", attribute.name, attribute.value);
}

void Svg::open(std::string_view element, Attributes attributes) {
    start(element, attributes);
    body_ += ">\n";
}

void Svg::close(std::string_view element) {
    body_ += fmt::format("</{}>\n", element);
}

void Svg::add(std::string_view element, Attributes attributes) {
    start(element, attributes);
    body_ += "/>\n";
}

void Svg::line(Point from, Point to, Attributes attributes) {
    start("line", {{"x1", from.x}, {"y1", from.y}, {"x2", to.x}, {"y2", to.y}}, attributes);
    body_ += "/>\n";
}

void Svg::rect(const Rect& rect, Attributes attributes) {
    start("rect", {{"x", rect.x}, {"y", rect.y}, {"width", rect.width}, {"height", rect.height}},
          attributes);
    body_ += "/>\n";
}

void Svg::circle(Point center, double radius, Attributes attributes) {
    start("circle", {{"cx", center.x}, {"cy", center.y}, {"r", radius}}, attributes);
    body_ += "/>\n";
}

void Svg::polyline(const std::vector<Point>& points, Attributes attributes) {
    if (points.size() < 2)
        return;
    std::string list;
    for (const Point& point : distinct(points))
        list += fmt::format("{}{},{}", list.empty() ? "" : " ", number(point.x), number(point.y));
    start("polyline", {{"points", list}}, attributes);
    body_ += "/>\n";
}

void Svg::curve(const std::vector<Point>& all, Attributes attributes) {
    const std::vector<Point> points = distinct(all);
    if (points.size() < 2)
        return;
    const auto at = [&](std::size_t i) { return points[std::min(i, points.size() - 1)]; };
    std::string path = fmt::format("M{} {}", number(at(0).x), number(at(0).y));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point before = at(i == 0 ? 0 : i - 1), from = at(i), to = at(i + 1),
                    after = at(i + 2);
        path += fmt::format("C{} {} {} {} {} {}", number(from.x + (to.x - before.x) / 6),
                            number(from.y + (to.y - before.y) / 6),
                            number(to.x - (after.x - from.x) / 6),
                            number(to.y - (after.y - from.y) / 6), number(to.x), number(to.y));
    }
    start("path", {{"d", path}}, attributes);
    body_ += "/>\n";
}

void Svg::text(Point at, Anchor anchor, std::string_view content, Attributes attributes) {
    constexpr const char* names[] = {"start", "middle", "end"};
    start("text", {{"x", at.x}, {"y", at.y}, {"text-anchor", names[static_cast<int>(anchor)]}},
          attributes);
    body_ += fmt::format(">{}</text>\n", escaped(content));
}

void Svg::text_with_halo(Point at, Anchor anchor, std::string_view content, double font_size,
                         std::string_view its_class) {
    text(at, anchor, content,
         {{"class", "halo"},
          {"font-size", font_size},
          {"fill", "#ffffff"},
          {"stroke", "#ffffff"},
          {"stroke-width", 2.0},
          {"aria-hidden", "true"}});
    text(at, anchor, content, {{"class", its_class}, {"font-size", font_size}});
}

std::string Svg::document(double width, double height, std::string_view title) const {
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
                       "width=\"{0}\" height=\"{1}\" "
                       "font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', "
                       "sans-serif\" font-size=\"11\" fill=\"#222222\">\n"
                       "<title>{2}</title>\n"
                       "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
                       "{3}</svg>\n",
                       number(width), number(height), escaped(title), body_);
}

} // namespace tool::plot
