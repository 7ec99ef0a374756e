// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/date_time.hpp"

#include <chrono>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

constexpr double seconds_a_minute = 60, seconds_an_hour = 3600, seconds_a_day = 86400;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Reads a cell from left to right; nothing is taken if it is not what is asked for.
class Reading {
  public:
    explicit Reading(std::string_view text) : rest_(text) {}

    bool skip(char c) {
        const bool there = rest_.starts_with(c);
        rest_.remove_prefix(there ? 1 : 0);
        return there;
    }

    std::optional<int> digits(std::size_t least, std::size_t most) {
        std::size_t count = 0;
        int value = 0;
        while (count < most && count < rest_.size() && is_digit(rest_[count]))
            value = 10 * value + (rest_[count++] - '0');
        if (count < least)
            return std::nullopt;
        rest_.remove_prefix(count);
        return value;
    }

    /// Two digits that are less than the limit.
    std::optional<int> below(int limit, std::size_t least = 2) {
        const auto value = digits(least, 2);
        return value && *value < limit ? value : std::nullopt;
    }

    /// The digits after a point, or after the comma of some countries.
    double fraction() {
        double value = 0, unit = 1;
        if (!skip('.') && !skip(','))
            return 0;
        while (!rest_.empty() && is_digit(rest_[0])) {
            unit /= 10;
            value += unit * (rest_[0] - '0');
            rest_.remove_prefix(1);
        }
        return value;
    }

    bool at_end() const { return rest_.empty(); }

  private:
    std::string_view rest_;
};

/// Seconds from 1970 to the beginning of the day.
std::optional<double> date_of(Reading& in) {
    const auto year = in.digits(4, 4);
    const char between = in.skip('-') ? '-' : in.skip('/') ? '/' : '\0';
    const auto month = year && between != '\0' ? in.below(13) : std::nullopt;
    const auto date = month && in.skip(between) ? in.below(32) : std::nullopt;
    if (!date)
        return std::nullopt;
    const std::chrono::year_month_day found{std::chrono::year(*year),
                                            std::chrono::month(static_cast<unsigned>(*month)),
                                            std::chrono::day(static_cast<unsigned>(*date))};
    if (!found.ok())
        return std::nullopt;
    return seconds_a_day *
           static_cast<double>(std::chrono::sys_days(found).time_since_epoch().count());
}

/// Seconds since midnight.
std::optional<double> time_of_day(Reading& in) {
    const auto hours = in.below(24, 1);
    const auto minutes = hours && in.skip(':') ? in.below(60) : std::nullopt;
    if (!minutes)
        return std::nullopt;
    double seconds = seconds_an_hour * *hours + seconds_a_minute * *minutes;
    if (!in.skip(':'))
        return seconds;
    const auto whole = in.below(61); // a leap second is the 60th
    if (!whole)
        return std::nullopt;
    seconds += *whole;
    return seconds + in.fraction();
}

/// Seconds by which the zone at the end is before UTC.
std::optional<double> zone_of(Reading& in) {
    in.skip(' ');
    if (in.at_end() || in.skip('Z') || in.skip('z'))
        return 0;
    const double sign = in.skip('+') ? 1 : in.skip('-') ? -1 : 0;
    const auto hours = sign != 0 ? in.below(24) : std::nullopt;
    if (!hours)
        return std::nullopt;
    in.skip(':');
    const int minutes = in.below(60).value_or(0);
    return sign * (seconds_an_hour * *hours + seconds_a_minute * minutes);
}

} // namespace

std::optional<double> parse_date_time(std::string_view cell) {
    const std::string_view text = trim(cell);
    Reading in(text);
    const auto date = date_of(in);
    if (date && in.at_end())
        return date;
    if (!date)
        in = Reading(text);
    else if (!in.skip('T') && !in.skip('t') && !in.skip(' '))
        return std::nullopt;
    const auto time = time_of_day(in);
    const auto zone = time ? zone_of(in) : std::nullopt;
    if (!zone || !in.at_end())
        return std::nullopt;
    return date.value_or(0) + *time - *zone;
}

} // namespace stltsa::clip
