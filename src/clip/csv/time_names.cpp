// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/time_names.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Lower case without blanks and punctuation; digits stay, so that T10[0] is "t100".
std::string squashed(std::string_view name) {
    std::string text = to_lower(name);
    std::erase_if(text, [](char c) {
        const bool letter = c >= 'a' && c <= 'z';
        return !letter && !(c >= '0' && c <= '9') && static_cast<unsigned char>(c) < 0x80;
    });
    return text;
}

/// Of a cycle, as in "Time (%)" and "percent_gait": no time in seconds.
bool is_share(std::string_view column) {
    return column.find('%') != column.npos || squashed(column).find("percent") != std::string::npos;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

/// Seconds; 0 for no unit. Empty if the word is none.
std::optional<double> seconds_of(std::string_view word) {
    struct TimeUnit {
        std::string_view name;
        double seconds;
    };
    constexpr TimeUnit time_units[] = {{"", 0},
                                       {"s", 1},
                                       {"sec", 1},
                                       {"secs", 1},
                                       {"second", 1},
                                       {"seconds", 1},
                                       {"ms", 1e-3},
                                       {"msec", 1e-3},
                                       {"msecs", 1e-3},
                                       {"millis", 1e-3},
                                       {"milliseconds", 1e-3},
                                       {"us", 1e-6},
                                       {"usec", 1e-6},
                                       {"usecs", 1e-6},
                                       {"microseconds", 1e-6},
                                       {"\xC2\xB5s", 1e-6},
                                       {"\xCE\xBCs", 1e-6},
                                       {"ns", 1e-9},
                                       {"nsec", 1e-9},
                                       {"nanoseconds", 1e-9},
                                       {"min", 60},
                                       {"minutes", 60},
                                       {"utc", 0},
                                       {"unix", 0}};
    for (const TimeUnit& unit : time_units)
        if (unit.name == word)
            return unit.seconds;
    return std::nullopt;
}

/// "frames", "frameno", "frameindex", ...
bool counts(std::string_view name, std::string_view what) {
    return name.starts_with(what) &&
           is_one_of(name.substr(what.size()), {"", "s", "no", "nr", "num", "number", "index",
                                                "idx", "id", "count", "counter"});
}

} // namespace

bool is_time_unit(std::string_view word) {
    return seconds_of(to_lower(word)).value_or(0) > 0;
}

std::optional<TimeName> time_name(std::string_view column) {
    const std::string name = squashed(column);
    if (is_share(column))
        return std::nullopt;
    if (name == "seconds")
        return TimeName{1, false};
    for (const std::string_view word : {"timestamps", "timestamp", "times", "time", "elapsedtime",
                                        "datetime", "unixtime", "date", "ts", "t"}) {
        if (!name.starts_with(word))
            continue;
        const bool letter = word == "t";
        const auto unit = seconds_of(std::string_view(name).substr(word.size()));
        if (unit && !(letter && *unit == 60)) // tmin is a least temperature
            return TimeName{*unit, letter};
    }
    return std::nullopt;
}

std::optional<double> unit_after(std::string_view column) {
    if (is_share(column))
        return std::nullopt;
    const std::string_view name = trim(column);
    const std::size_t place = name.find_last_of("_ .([");
    const auto unit = seconds_of(squashed(place == name.npos ? name : name.substr(place)));
    const bool is_bracket = name.ends_with(')') || name.ends_with(']');
    if (unit && *unit > 0)
        return unit;
    return is_bracket ? std::nullopt : std::optional(1.0);
}

bool is_counter_name(std::string_view column) {
    const std::string name = squashed(column);
    return is_one_of(name, {"index", "idx", "counter", "count", "seq"}) || counts(name, "frame") ||
           counts(name, "sample") || counts(name, "packet") || counts(name, "sequence");
}

bool is_frame_name(std::string_view column) {
    return counts(squashed(column), "frame");
}

bool is_subframe_name(std::string_view column) {
    return is_one_of(squashed(column), {"subframe", "subframes", "subframenumber"});
}

} // namespace stltsa::clip
