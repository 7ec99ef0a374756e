// SPDX-License-Identifier: BSD-3-Clause
#include "plot/labels.hpp"

#include <algorithm>

#include "terminal/text.hpp"

namespace tool::plot {
namespace {

/// Advance width of a character in ems, estimated by class.
double advance(char c) {
    constexpr std::string_view narrow = " !'(),-./:;I[]fijlrt|";
    constexpr std::string_view wide = "%@GMOQWmw";
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80)
        return 0; // continuation byte
    if (narrow.find(c) != std::string_view::npos)
        return 0.4;
    if (wide.find(c) != std::string_view::npos)
        return 0.95;
    return byte >= 'A' && byte <= 'Z' ? 0.72 : 0.635;
}

} // namespace

double text_width(std::string_view text, double font_size) {
    double ems = 0;
    for (const char c : text)
        ems += advance(c);
    return ems * font_size;
}

std::vector<std::string> lines_of(std::string_view text, double font_size, double width) {
    return wrapped(text,
                   [&](const std::string& line) { return text_width(line, font_size) <= width; });
}

std::string shortened(std::string_view text, double font_size, double width) {
    constexpr std::string_view dots = "...";
    if (text_width(text, font_size) <= width)
        return std::string(text);
    const auto in_character = [&] { return (static_cast<unsigned char>(text[0]) & 0xC0) == 0x80; };
    const double room = width - text_width(dots, font_size);
    while (!text.empty() && (text_width(text, font_size) > room || in_character()))
        text.remove_prefix(1);
    return std::string(dots) + std::string(text);
}

bool LabelSpace::free(const Rect& box) const {
    constexpr double air = 4; // else two numbers side by side look like one
    return std::ranges::none_of(taken_, [&](const Rect& other) {
        return box.x < other.right() + air && other.x < box.right() + air &&
               box.y < other.bottom() && other.y < box.bottom();
    });
}

bool LabelSpace::take_if_free(const Rect& box) {
    if (!free(box))
        return false;
    take(box);
    return true;
}

} // namespace tool::plot
