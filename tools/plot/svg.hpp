// SPDX-License-Identifier: BSD-3-Clause
// The SVG that the figures need: elements with attributes, numbers of fixed precision, escaped
// text. Debian has no small library for it.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace tool::plot {

/// At most two decimals, with a decimal point, never "-0": the same bytes everywhere.
std::string number(double value);

/// Text as XML: markup escaped; control characters become U+FFFD.
std::string escaped(std::string_view text);

struct Point {
    double x = 0;
    double y = 0;
};

struct Rect {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;

    double right() const { return x + width; }
    double bottom() const { return y + height; }
};

struct Attribute {
    std::string_view name;
    std::string value;

    Attribute(std::string_view key, double v) : name(key), value(number(v)) {}
    Attribute(std::string_view key, std::string_view v) : name(key), value(escaped(v)) {}
};
using Attributes = std::initializer_list<Attribute>;

enum class Anchor { start, middle, end };

class Svg {
  public:
    void open(std::string_view element, Attributes attributes = {});
    void close(std::string_view element);
    void add(std::string_view element, Attributes attributes);

    void line(Point from, Point to, Attributes attributes);
    void rect(const Rect& rect, Attributes attributes);
    void circle(Point center, double radius, Attributes attributes);
    void polyline(const std::vector<Point>& points, Attributes attributes);
    /// A smooth curve through all points (a Catmull-Rom spline).
    void curve(const std::vector<Point>& points, Attributes attributes);
    void text(Point at, Anchor anchor, std::string_view content, Attributes attributes = {});
    /// Text over other drawing, with a wider white copy behind it. ("paint-order" would do the
    /// same, but not all programs support it.)
    void text_with_halo(Point at, Anchor anchor, std::string_view content, double font_size,
                        std::string_view its_class);

    /// The whole document, on white.
    std::string document(double width, double height, std::string_view title) const;

  private:
    void start(std::string_view element, Attributes attributes);
    void start(std::string_view element, Attributes geometry, Attributes attributes);
    std::string body_;
};

} // namespace tool::plot
