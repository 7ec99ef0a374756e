// SPDX-License-Identifier: BSD-3-Clause
// The SVG that the figure needs.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stltsa::report {

struct Point {
    double x = 0, y = 0;
};

inline double distance(Point a, Point b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

inline Point between(Point a, Point b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

struct Rect {
    double x = 0, y = 0, width = 0, height = 0;

    double right() const { return x + width; }
    double bottom() const { return y + height; }
    Point middle() const { return {x + 0.5 * width, y + 0.5 * height}; }
};

inline constexpr const char *ink = "#222222", *faint_ink = "#767676", *white = "#ffffff";
inline constexpr double font = 11, small_font = 9.5, bold_line = 1.8, fine_line = 0.8;

/// At most two decimals: the same bytes everywhere.
std::string number(double value);
std::string pair(Point point);

/// Styles of lines and of areas: attributes as text. `more`: further ones, with a blank before.
std::string stroke(const char* its_class, const char* color, double width, const char* more = "");
std::string fill(const char* its_class, const char* color, double opacity = 1,
                 const std::string& more = {});

/// About the width of a line of text in DejaVu Sans, the widest font that a viewer may use.
double text_width(std::string_view text, double size);
/// "1 cycle", "2 cycles".
std::string counted(std::int64_t count, const char* noun);
/// Breaks text at blanks, and words that are longer than a line anywhere.
std::vector<std::string> lines_of(std::string_view text, double size, double width);

class Svg {
  public:
    void open(const std::string& style) { body_ += "<g " + style + ">\n"; }
    void close() { body_ += "</g>\n"; }
    void line(Point from, Point to, const std::string& style);
    void rect(const Rect& rect, const std::string& style);
    void circle(Point center, double radius, const std::string& style);
    void path(const std::string& d, const std::string& style);
    void polyline(const std::vector<Point>& points, const std::string& style);
    /// A smooth curve through all points (a Catmull-Rom spline).
    void curve(const std::vector<Point>& points, const std::string& style);
    /// `anchor`: "start", "middle" or "end".
    void text(Point at, const char* anchor, std::string_view content, const std::string& style);
    /// Text over other drawing, with a wider white copy behind it ("paint-order" would do the same,
    /// but not all programs support it).
    void number_text(Point at, std::string_view content, const char* its_class);

    /// The whole document, on white.
    std::string document(double width, double height, std::string_view title) const;

  private:
    std::string body_;
};

} // namespace stltsa::report
