// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/date_time.hpp"

#include <chrono>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

constexpr double seconds_a_minute = 60, seconds_an_hour = 3600;

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

    bool skip_word(std::string_view word) {
        const bool there = equals_ignoring_case(rest_.substr(0, word.size()), word);
        rest_.remove_prefix(there ? word.size() : 0);
        return there;
    }

    bool is_at_point() const { return rest_.starts_with('.') || rest_.starts_with(','); }

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

/// Seconds from 1970 to the beginning of the day: 2024-01-31, 31.1.2024, or 1/31/2024. If 12 or
/// less is first before a slash, it is the month.
std::optional<double> date_of(Reading& in) {
    const auto first = in.digits(1, 4);
    const char between = in.skip('-') ? '-' : in.skip('/') ? '/' : in.skip('.') ? '.' : '\0';
    const auto second = first && between != '\0' ? in.below(32, 1) : std::nullopt;
    const auto third = second && in.skip(between) ? in.digits(1, 4) : std::nullopt;
    constexpr int least_year = 1000;
    if (!third || (*first < least_year) == (*third < least_year))
        return std::nullopt;
    const bool year_first = *first >= least_year, month_first = between == '/' && *first <= 12;
    const int year = year_first ? *first : *third;
    const int month = year_first || !month_first ? *second : *first;
    const int date = year_first ? *third : month_first ? *second : *first;
    const std::chrono::year_month_day found{std::chrono::year(year),
                                            std::chrono::month(static_cast<unsigned>(month)),
                                            std::chrono::day(static_cast<unsigned>(date))};
    if (!found.ok())
        return std::nullopt;
    return seconds_a_day *
           static_cast<double>(std::chrono::sys_days(found).time_since_epoch().count());
}

/// Seconds since midnight, or, as 00:12.345 is, since the beginning.
std::optional<double> time_of_day(Reading& in) {
    const auto hours = in.below(60, 1);
    const auto minutes = hours && in.skip(':') ? in.below(60) : std::nullopt;
    if (!minutes)
        return std::nullopt;
    if (in.is_at_point())
        return seconds_a_minute * *hours + *minutes + in.fraction();
    if (*hours >= 24)
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

/// Moves the hours of "11:30 PM" to those of the day.
double of_day(double seconds, Reading& in) {
    constexpr double noon = 12 * seconds_an_hour;
    in.skip(' ');
    const bool am = in.skip_word("am"), pm = !am && in.skip_word("pm");
    const bool is_twelve = seconds >= noon && seconds < noon + seconds_an_hour;
    return am && is_twelve ? seconds - noon : pm && seconds < noon ? seconds + noon : seconds;
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
    if (!time)
        return std::nullopt;
    const double seconds = of_day(*time, in);
    const auto zone = zone_of(in);
    if (!zone || !in.at_end())
        return std::nullopt;
    return date.value_or(0) + seconds - *zone;
}

} // namespace stltsa::clip
