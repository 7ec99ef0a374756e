// SPDX-License-Identifier: BSD-3-Clause
#include "report/figure/svg.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace stltsa::report {
namespace {

/// Text as XML: markup is escaped; what XML 1.0 forbids (control characters, U+FFFE, U+FFFF) and
/// what is not UTF-8 becomes U+FFFD.
std::string escaped(std::string_view text) {
    constexpr std::string_view marks = "&<>\"'";
    constexpr std::string_view escapes[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text, 0);
        const std::string_view character = text.substr(0, std::max<std::size_t>(1, length));
        if (const auto mark = marks.find(character); mark != marks.npos)
            result += escapes[mark];
        else if (length == 0 || is_control(character) || character == "\xEF\xBF\xBE" ||
                 character == "\xEF\xBF\xBF")
            result += "\xEF\xBF\xBD";
        else
            result += character;
        text.remove_prefix(character.size());
    }
    return result;
}

} // namespace

std::string number(double value) {
    return format_text("{}", std::round(100 * value) / 100 + 0.0); // never "-0"
}

std::string pair(Point point) {
    return number(point.x) + ' ' + number(point.y);
}

std::string stroke(const char* its_class, const char* color, double width, const char* more) {
    return format_text(R"(class="{}" fill="none" stroke="{}" stroke-width="{}"{})", its_class,
                       color, number(width), more);
}

std::string fill(const char* its_class, const char* color, double opacity,
                 const std::string& more) {
    return format_text(R"(class="{}" fill="{}" fill-opacity="{}"{})", its_class, color,
                       number(opacity), more);
}

std::string counted(std::int64_t count, const char* noun) {
    return format_text("{} {}{}", count, noun, count == 1 ? "" : "s");
}

double text_width(std::string_view text, double size) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    return 0.6 * size * static_cast<double>(std::ranges::count_if(text, begins));
}

std::vector<std::string> lines_of(std::string_view text, double size, double width) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        std::size_t end = 1;
        while (end < text.size() && text_width(text.substr(0, end + 1), size) <= width)
            ++end;
        const auto blank = text.substr(0, end).rfind(' ');
        if (end < text.size() && blank != text.npos && blank > 0)
            end = blank;
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(text.find_first_not_of(' ', end), text.size()));
    }
    return lines;
}

void Svg::line(Point from, Point to, const std::string& style) {
    body_ += format_text("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", number(from.x),
                         number(from.y), number(to.x), number(to.y), style);
}

void Svg::rect(const Rect& rect, const std::string& style) {
    body_ +=
        format_text("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", number(rect.x),
                    number(rect.y), number(rect.width), number(rect.height), style);
}

void Svg::circle(Point center, double radius, const std::string& style) {
    body_ += format_text("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", number(center.x),
                         number(center.y), number(radius), style);
}

void Svg::path(const std::string& d, const std::string& style) {
    if (!d.empty())
        body_ += format_text("<path d=\"{}\" {}/>\n", d, style);
}

void Svg::polyline(const std::vector<Point>& points, const std::string& style) {
    std::string d;
    for (const Point& point : points)
        d += (d.empty() ? 'M' : 'L') + pair(point);
    path(d, style);
}

void Svg::curve(const std::vector<Point>& points, const std::string& style) {
    std::string d;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point before = points[i == 0 ? 0 : i - 1], from = points[i], to = points[i + 1],
                    after = points[std::min(i + 2, points.size() - 1)];
        d += (i == 0 ? "M" + pair(from) : "") + 'C' +
             pair({from.x + (to.x - before.x) / 6, from.y + (to.y - before.y) / 6}) + ' ' +
             pair({to.x - (after.x - from.x) / 6, to.y - (after.y - from.y) / 6}) + ' ' + pair(to);
    }
    path(d, style);
}

void Svg::text(Point at, const char* anchor, std::string_view content, const std::string& style) {
    body_ += format_text("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" {}>{}</text>\n", number(at.x),
                         number(at.y), anchor, style, escaped(content));
}

void Svg::number_text(Point at, std::string_view content, const char* its_class) {
    const std::string size = format_text(" font-size=\"{}\"", small_font);
    text(at, "middle", content, stroke("halo", white, 2, R"( aria-hidden="true")") + size);
    text(at, "middle", content, fill(its_class, ink, 1, size));
}

std::string Svg::document(double width, double height, std::string_view title) const {
    return format_text(R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}"
 font-family="Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif" font-size="{2}">
<title>{3}</title>
<rect width="100%" height="100%" fill="{4}"/>
{5}</svg>
)",
                       number(width), number(height), font, escaped(title), white, body_);
}

} // namespace stltsa::report
