// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/point_names.hpp"

#include <algorithm>
#include <string_view>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Between the name of a point and the axis.
constexpr std::string_view separators = "_. :-";

/// The name of the point in lower case; empty if the coordinate is not the one along `axis`.
std::string stem_of(std::string_view name, char axis) {
    const std::string lower = to_lower(trim(name));
    return lower.ends_with(axis) ? std::string(point_name(lower)) : std::string();
}

/// The common stem of three columns; empty if they are not named x, y, z.
std::string stem_at(const std::vector<std::string>& names, std::size_t first) {
    if (first + 3 > names.size())
        return {};
    const std::string stem = stem_of(names[first], 'x');
    const bool same =
        stem == stem_of(names[first + 1], 'y') && stem == stem_of(names[first + 2], 'z');
    return same ? stem : std::string();
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

/// Sensors and results of models name their columns as points do.
bool is_other_quantity(const std::string& stem) {
    constexpr std::string_view parts[] = {"angle", "rotation", "euler",  "accel", "gyr",  "magn",
                                          "veloc", "torque",   "moment", "force", "power"};
    constexpr std::string_view words[] = {"acc", "ang", "mag", "rot", "vel"};
    return std::any_of(std::begin(parts), std::end(parts),
                       [&](std::string_view part) { return stem.find(part) != stem.npos; }) ||
           std::any_of(std::begin(words), std::end(words),
                       [&](std::string_view word) { return has_word(stem, word); });
}

bool is_confidence(std::string_view name, const std::string& stem) {
    constexpr std::string_view words[] = {"likelihood", "confidence", "score", "conf",
                                          "visibility"};
    const std::string lower = to_lower(trim(name));
    return std::ranges::any_of(words, [&](std::string_view word) {
        return lower.ends_with(word) && lower.starts_with(stem) &&
               lower.size() <= stem.size() + 1 + word.size();
    });
}

} // namespace

std::string without_unit(std::string_view name) {
    const std::string_view whole = trim(name);
    const char last = whole.empty() ? '\0' : whole.back();
    const std::size_t begin = last == ']'   ? whole.rfind('[')
                              : last == ')' ? whole.rfind('(')
                                            : whole.npos;
    return std::string(trim(whole.substr(0, begin)));
}

std::string axis_last(std::string_view name) {
    constexpr std::string_view axes = "xyzXYZ", digits = "0123456789";
    const std::string_view whole = trim(name);
    if (whole.size() < 2 || axes.find(whole[0]) == axes.npos)
        return std::string(name);
    std::string_view stem = whole.substr(1);
    if (separators.find(stem[0]) != separators.npos)
        stem.remove_prefix(1);
    else if (digits.find(stem[0]) == digits.npos)
        return std::string(name);
    return stem.empty() ? std::string(name) : std::string(stem) + '_' + whole[0];
}

std::string_view point_name(std::string_view coordinate) {
    std::string_view name = trim(coordinate);
    name.remove_suffix(1);
    if (!name.empty() && separators.find(name.back()) != name.npos)
        name.remove_suffix(1);
    return name;
}

bool names_coordinate(const std::vector<std::string>& names, std::size_t column) {
    for (std::size_t back = 0; back < 3 && back <= column; ++back)
        if (!stem_at(names, column - back).empty())
            return true;
    return false;
}

PointColumns point_at(const std::vector<std::string>& names, std::size_t first) {
    PointColumns found;
    if (first + 2 > names.size())
        return found;
    found.stem = stem_of(names[first], 'x');
    if (found.stem.empty() || stem_of(names[first + 1], 'y') != found.stem)
        return found;
    found.space = first + 2 < names.size() && stem_of(names[first + 2], 'z') == found.stem ? 3 : 2;
    const std::string_view name = trim(names[first]);
    found.is_set_apart = found.stem.size() + 1 < name.size() || name.back() == 'X';
    found.other_quantity = is_other_quantity(found.stem);
    const std::size_t next = first + static_cast<std::size_t>(found.space);
    found.has_confidence = next < names.size() && is_confidence(names[next], found.stem);
    return found;
}

} // namespace stltsa::clip
