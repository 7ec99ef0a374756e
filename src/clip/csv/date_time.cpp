// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/date_time.hpp"

#include <string>

#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

/// Takes `digits` digits off the front of a text, and then the character, if there is one.
std::optional<int> take(std::string_view& text, std::size_t digits, char then) {
    const std::size_t length = digits + (then == '\0' ? 0 : 1);
    if (text.size() < length || text.substr(0, digits).find_first_not_of("0123456789") != text.npos)
        return std::nullopt;
    if (then != '\0' && text[digits] != then)
        return std::nullopt;
    const auto value = parse_integer(text.substr(0, digits));
    text.remove_prefix(length);
    return static_cast<int>(*value);
}

/// Days since 1970-01-01 in the Gregorian calendar: years begin in March, so that a leap day is the
/// last of its year, and 400 years have 146097 days.
int days_of(int year, int month, int day) {
    year -= month <= 2 ? 1 : 0;
    const int of_era = year % 400;
    const int of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    return year / 400 * 146097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719468;
}

std::optional<double> take_date(std::string_view& text) {
    const auto year = take(text, 4, '-');
    const auto month = year ? take(text, 2, '-') : std::nullopt;
    const auto day = month ? take(text, 2, '\0') : std::nullopt;
    if (!day || *month < 1 || *month > 12 || *day < 1 || *day > 31)
        return std::nullopt;
    if (text.empty() || (text[0] != ' ' && text[0] != 'T' && text[0] != 't'))
        return std::nullopt;
    text.remove_prefix(1);
    return 86400.0 * days_of(*year, *month, *day);
}

/// Seconds with decimals, after which a time zone may follow.
std::optional<double> take_seconds(std::string_view& text) {
    const std::size_t end = text.find_first_of("Zz+-");
    std::string number(text.substr(0, end));
    if (number.size() < 2 || number.find_first_not_of("0123456789.,") != number.npos)
        return std::nullopt;
    if (const std::size_t comma = number.find(','); comma != number.npos)
        number[comma] = '.';
    text.remove_prefix(number.size());
    const auto seconds = parse_number(number);
    return seconds && *seconds < 61 ? seconds : std::nullopt;
}

} // namespace

std::optional<double> parse_date_time(std::string_view cell) {
    const bool has_date = cell.size() > 10 && cell[4] == '-';
    const auto date = has_date ? take_date(cell) : std::optional(0.0);
    const auto hours = date ? take(cell, 2, ':') : std::nullopt;
    const auto minutes = hours ? take(cell, 2, ':') : std::nullopt;
    const auto seconds = minutes ? take_seconds(cell) : std::nullopt;
    if (!seconds || *hours > 24 || *minutes > 59)
        return std::nullopt;
    // All times of a file have one zone: an offset changes no step.
    return *date + 3600.0 * *hours + 60.0 * *minutes + *seconds;
}

} // namespace stltsa::clip
