// SPDX-License-Identifier: BSD-3-Clause
#include "plot/svg.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/utf8.hpp"

namespace tool::plot {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD in UTF-8

bool forbidden_in_xml(char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 && c != '\t' && c != '\n' && c != '\r';
}

std::string_view escape_of(char c) {
    switch (c) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    default:
        return forbidden_in_xml(c) ? replacement : "";
    }
}

/// Points closer than this to the previous one are indistinguishable from it.
constexpr double finest = 0.1;

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
        const std::string_view escape = length == 0 ? replacement : escape_of(text[0]);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
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
    Point last{-1e9, -1e9};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool end = i == 0 || i + 1 == points.size();
        if (!end && std::hypot(points[i].x - last.x, points[i].y - last.y) < finest)
            continue;
        last = points[i];
        list += fmt::format("{}{},{}", list.empty() ? "" : " ", number(last.x), number(last.y));
    }
    start("polyline", {{"points", list}}, attributes);
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
