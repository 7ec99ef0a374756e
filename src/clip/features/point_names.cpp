// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/point_names.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Between the name of a point and the axis.
constexpr std::string_view separators = "_. :-";

/// Where the bracket begins that a name ends with; npos: it ends with none.
std::size_t bracket_of(std::string_view name) {
    const char last = name.empty() ? '\0' : name.back();
    return last == ']' ? name.rfind('[') : last == ')' ? name.rfind('(') : name.npos;
}

std::string_view in_bracket(std::string_view name) {
    const std::size_t begin = bracket_of(name);
    return begin == name.npos ? std::string_view()
                              : trim(name.substr(begin + 1, name.size() - begin - 2));
}

/// The axis of "x" or "Y", and of three indices if it is in a bracket.
std::optional<std::size_t> axis_of(std::string_view text, std::string_view indices) {
    constexpr std::string_view letters = "xyz";
    if (text.size() != 1)
        return std::nullopt;
    std::size_t axis = letters.find(to_lower(text));
    if (axis == letters.npos)
        axis = indices.find(text[0]);
    return axis == letters.npos ? std::nullopt : std::optional(axis);
}

/// With "_x" after it, as points are named whose axis is not last.
Coordinate named(std::string_view point, std::size_t axis) {
    if (point.empty())
        return {};
    return {std::string(point), std::string(point) + '_' + "xyz"[axis], axis, true};
}

Coordinate axis_last(std::string_view name, std::string_view indices) {
    if (const auto axis = axis_of(in_bracket(name), indices))
        return named(trim(name.substr(0, bracket_of(name))), *axis);
    const auto axis = name.empty() ? std::nullopt : axis_of(name.substr(name.size() - 1), {});
    const std::string_view point = axis ? point_name(name) : std::string_view();
    if (point.empty())
        return {};
    const bool is_capital = name.back() < 'a';
    return {std::string(point), std::string(name), *axis,
            is_capital || point.size() + 1 < name.size()};
}

/// Without a word for positions before it: "x_heel" of "pos_x_heel" and "posX_heel".
std::string_view without_position(std::string_view name) {
    constexpr std::string_view words[] = {"position", "pos", "location", "loc", "coord"};
    const auto separates = [&](std::size_t at) {
        return at < name.size() && separators.find(name[at]) != separators.npos;
    };
    for (const std::string_view word : words)
        if (const std::size_t end = word.size(); starts_with_ignoring_case(name, word)) {
            if (separates(end))
                return name.substr(end + 1);
            if (separates(end + 1) && axis_of(name.substr(end, 1), {}))
                return name.substr(end);
        }
    return name;
}

/// "heel_0", with a separator: not T10.
Coordinate axis_numbered(std::string_view name, std::string_view indices) {
    const std::size_t at = name.find_last_of(separators);
    if (at == name.npos || at + 2 != name.size())
        return {};
    const std::size_t axis = indices.find(name.back());
    return axis == indices.npos ? Coordinate() : named(name.substr(0, at), axis);
}

/// "v_x_heel", of "v_heel".
Coordinate axis_between(std::string_view name) {
    for (std::size_t at = name.find_first_of(separators); at != name.npos;
         at = name.find_first_of(separators, at + 1))
        if (at + 2 < name.size() && separators.find(name[at + 2]) != separators.npos)
            if (const auto axis = axis_of(name.substr(at + 1, 1), {}))
                return named(std::string(name.substr(0, at)).append(name.substr(at + 2)), *axis);
    return {};
}

Coordinate axis_first(std::string_view column) {
    constexpr std::string_view digits = "0123456789";
    std::string_view name = without_position(column);
    const auto axis = axis_of(name.substr(0, 1), {});
    if (!axis || name.size() < 2)
        return {};
    const bool is_small = name[0] >= 'a';
    name.remove_prefix(1);
    if (separators.find(name[0]) != separators.npos)
        name.remove_prefix(1);
    else if (digits.find(name[0]) == digits.npos && !(is_small && name[0] >= 'A' && name[0] <= 'Z'))
        return {};
    return named(name, *axis);
}

/// Whether one of the words of the stem is the word.
bool has_word(const std::string& stem, std::string_view word) {
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    const std::size_t at = stem.find(word);
    if (at == stem.npos)
        return false;
    const std::size_t end = at + word.size();
    return (at == 0 || !is_letter(stem[at - 1])) && (end == stem.size() || !is_letter(stem[end]));
}

/// In the names of angles; the others may be parts of other words, as "ang" of "hand angle".
constexpr std::string_view angle_parts[] = {"angle", "rotation", "euler", "orientation"};
constexpr std::string_view angle_words[] = {"ang", "rot"};

/// Every index that may be that of an axis.
constexpr std::string_view all_indices = "0123";

/// Where a unit of length begins that follows an axis, as in "heel_x_mm"; npos: none does.
std::size_t length_of(std::string_view name) {
    const std::size_t place = name.rfind('_');
    const bool follows = place != name.npos && place > 1 &&
                         axis_of(name.substr(place - 1, 1), {}) &&
                         separators.find(name[place - 2]) != separators.npos;
    return follows && is_length_unit(name.substr(place + 1)) ? place : name.npos;
}

} // namespace

bool is_axis(std::string_view text) {
    return axis_of(text, {}).has_value();
}

std::string_view unit_of(std::string_view name) {
    const std::string_view whole = trim(name), unit = in_bracket(whole);
    if (const std::size_t length = length_of(whole); length != whole.npos)
        return whole.substr(length + 1);
    return axis_of(unit, all_indices) ? std::string_view() : unit;
}

std::string_view without_unit(std::string_view name) {
    const std::string_view whole = trim(name);
    if (const std::size_t length = length_of(whole); length != whole.npos)
        return whole.substr(0, length);
    return unit_of(whole).empty() ? whole : trim(whole.substr(0, bracket_of(whole)));
}

bool is_length_unit(std::string_view unit) {
    constexpr std::string_view units[] = {"m",    "mm",  "cm",          "km",     "in",
                                          "ft",   "px",  "mm.",         "pixel",  "pixels",
                                          "(mm)", "(m)", "millimeters", "meters", "centimeters"};
    return std::ranges::any_of(
        units, [unit](std::string_view u) { return equals_ignoring_case(unit, u); });
}

bool is_other_unit(std::string_view unit) {
    constexpr std::string_view units[] = {
        "deg",     "degs", "degree", "degrees",   "\xC2\xB0", "rad",  "rads", "radian",
        "radians", "n",    "nm",     "nmm",       "n.m",      "n.mm", "n*m",  "w",
        "v",       "mv",   "uv",     "\xC2\xB5V", "t",        "ut",   "g"};
    if (equals_ignoring_case(unit, "n/a"))
        return false;
    return unit.find('/') != unit.npos || std::ranges::any_of(units, [unit](std::string_view u) {
               return equals_ignoring_case(unit, u);
           });
}

std::string_view point_name(std::string_view coordinate) {
    std::string_view name = trim(coordinate);
    name.remove_suffix(1);
    if (!name.empty() && separators.find(name.back()) != name.npos)
        name.remove_suffix(1);
    return name;
}

Coordinate coordinate_of(std::string_view column, AxisPlace place) {
    const std::string_view name = without_unit(column);
    switch (place) {
    case AxisPlace::first:
        return axis_first(name);
    case AxisPlace::numbered:
        return axis_numbered(name, "012");
    case AxisPlace::numbered_from_1:
        return axis_numbered(name, "123");
    case AxisPlace::between:
        return axis_between(name);
    case AxisPlace::last:
        return axis_last(name, "012");
    case AxisPlace::counted:
        return axis_last(name, "123");
    }
    return {};
}

std::string_view point_of_confidence(std::string_view column) {
    constexpr std::string_view words[] = {"likelihood", "confidence", "score", "conf",
                                          "visibility"};
    const std::string_view name = trim(column);
    const std::string lower = to_lower(name);
    for (const std::string_view word : words)
        if (lower.size() > word.size() && lower.ends_with(word))
            return point_name(name.substr(0, name.size() - word.size() + 1));
    return {};
}

bool is_angle(std::string_view word) {
    const std::string_view one = word.substr(0, word.size() - (word.ends_with('s') ? 1 : 0));
    return std::ranges::find(angle_parts, one) != std::end(angle_parts) ||
           std::ranges::find(angle_words, one) != std::end(angle_words);
}

bool is_other_quantity(std::string_view point) {
    constexpr std::string_view parts[] = {"quat",   "accel",  "gyr",    "magn",  "veloc", "ornt",
                                          "jntang", "torque", "moment", "force", "power"};
    constexpr std::string_view words[] = {"acc", "mag", "vel"};
    const std::string stem = to_lower(point);
    const auto has_part = [&](std::string_view part) { return stem.find(part) != stem.npos; };
    const auto has = [&](std::string_view word) { return has_word(stem, word); };
    return std::ranges::any_of(parts, has_part) || std::ranges::any_of(angle_parts, has_part) ||
           std::ranges::any_of(words, has) || std::ranges::any_of(angle_words, has);
}

bool names_coordinate(const std::vector<std::string>& names, std::size_t column) {
    const auto at = [&](std::size_t first) {
        std::string point;
        unsigned axes = 0;
        for (std::size_t c = first; c < first + 3 && c < names.size(); ++c) {
            const Coordinate found = coordinate_of(names[c], AxisPlace::last);
            if (found.point.empty() || (c > first && !equals_ignoring_case(found.point, point)))
                return false;
            point = found.point;
            axes |= 1u << found.axis;
        }
        return axes == 7;
    };
    for (std::size_t back = 0; back < 3 && back <= column; ++back)
        if (at(column - back))
            return true;
    return false;
}

} // namespace stltsa::clip
