// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/time_column.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "clip/arrays/even_times.hpp"
#include "clip/csv/date_time.hpp"
#include "clip/csv/point_columns.hpp"
#include "clip/csv/row_count.hpp"
#include "clip/csv/time_names.hpp"
#include "clip/features/point_names.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

struct Unit {
    double seconds;
    std::string_view name;
};
constexpr Unit units[] = {
    {1, "seconds"}, {1e-3, "milliseconds"}, {1e-6, "microseconds"}, {1e-9, "nanoseconds"}};

/// The unit in which the time is a date between 1990 and 2100, counted from 1970.
const Unit* unit_since_1970(double time) {
    constexpr double year = 365.25 * seconds_a_day;
    for (const Unit& unit : units)
        if (time * unit.seconds > 20 * year && time * unit.seconds < 130 * year)
            return &unit;
    return nullptr;
}

std::vector<double> column_of(const Matrix& values, std::int64_t column) {
    std::vector<double> result;
    for (std::int64_t i = 0; i < values.rows(); ++i)
        result.push_back(values(i, column));
    return result;
}

/// A torque rises as often as it falls; time falls by mistake only.
bool mostly_increases(const std::vector<double>& values) {
    constexpr double least_share = 0.75;
    std::size_t rises = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        rises += values[i] > values[i - 1] ? 1 : 0;
    return static_cast<double>(rises) >= least_share * static_cast<double>(values.size() - 1);
}

/// The first row that is not later than the one before, or has no value.
std::optional<std::size_t> first_fault(const std::vector<double>& times) {
    for (std::size_t i = 0; i < times.size(); ++i)
        if (std::isnan(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
            return i;
    return std::nullopt;
}

/// Times of day begin again at midnight: adds the days that have passed. Returns their number.
std::int64_t add_days(std::vector<double>& times) {
    std::int64_t days = 0;
    double before = -seconds_a_day;
    for (double& time : times) {
        const double stated = time;
        days += stated < before - seconds_a_day / 2 ? 1 : 0;
        time += seconds_a_day * static_cast<double>(days);
        before = std::isnan(stated) ? before : stated;
    }
    return days;
}

bool are_days(const std::vector<double>& dates) {
    return std::ranges::all_of(dates,
                               [](double date) { return std::fmod(date, seconds_a_day) == 0; });
}

class TimeColumns {
  public:
    TimeColumns(Clip& clip, const TableFacts& facts, const std::string& name,
                const ReadOptions& options)
        : clip_(clip), facts_(facts), name_(name), options_(options), said_(clip.fps),
          removed_(clip.channel_names.size()) {}

    void extract(const std::function<void()>& take_channels) {
        std::vector<std::int64_t> found = candidates();
        std::erase_if(found, [this](std::int64_t column) { return take_days(column); });
        for (const std::int64_t column : found)
            take_time(column);
        take_counts();
        if (!has_clock_ && !options_.fps && said_ == 0)
            guess_clock();
        remove();
        take_channels();
        if (!times_.empty())
            use_times();
        else if (!counts_.empty())
            use_counts();
    }

  private:
    const std::string& title(std::int64_t column) const {
        return clip_.channel_names[static_cast<std::size_t>(column)];
    }
    bool is_dated(std::int64_t column) const {
        return std::ranges::binary_search(facts_.dated, column);
    }
    template <class... Args>
    void note(fmt::format_string<Args...> text, Args&&... args) {
        clip_.notes.push_back(format_text(text, std::forward<Args>(args)...));
    }
    void remove_column(std::int64_t column) { removed_[static_cast<std::size_t>(column)] = true; }

    /// Columns that may be the clock, the likeliest first.
    std::vector<std::int64_t> candidates() const {
        std::vector<std::int64_t> found[3];
        for (std::int64_t column = 0; column < clip_.values.cols(); ++column) {
            const auto named = time_name(title(column));
            if (named || is_dated(column))
                found[named ? (named->letter ? 1 : 0) : 2].push_back(column);
        }
        for (const auto& more : {found[1], found[2]})
            found[0].insert(found[0].end(), more.begin(), more.end());
        return found[0];
    }

    /// A column of dates without the time of the day, which is in another column.
    bool take_days(std::int64_t column) {
        if (!is_dated(column))
            return false;
        std::vector<double> dates = column_of(clip_.values, column);
        if (dates.size() < 2 || !are_days(dates))
            return false;
        remove_column(column);
        note("column {} is the day, not a channel", in_quotes(title(column)));
        days_ = std::move(dates);
        return true;
    }

    /// The first column that can be the clock is; later ones are not channels if they are times.
    void take_time(std::int64_t column) {
        std::vector<double> values = column_of(clip_.values, column);
        if (is_dated(column))
            take_day(column, values);
        const auto fault = first_fault(values);
        const TimeName named = time_name(title(column)).value_or(TimeName{1, false});
        if (has_clock_) {
            if (!fault || is_dated(column)) {
                remove_column(column);
                note("column {} is time, too: left out", in_quotes(title(column)));
            }
            return;
        }
        if (fault && named.letter && !mostly_increases(values))
            return note("column {} does not increase: not taken as time, but kept as a channel "
                        "unless it is left out below",
                        in_quotes(title(column)));
        if (fault && !are_rounded_times(values))
            return take_faulty(column, values, *fault, "is time");
        if (values.size() > 1)
            take_clock(column, std::move(values), is_dated(column) ? 1 : named.unit, named.letter);
        else
            remove_column(column);
    }

    /// Adds the day to times that lack it.
    void take_day(std::int64_t column, std::vector<double>& times) {
        const bool lack_day = std::ranges::all_of(
            times, [](double time) { return !(std::abs(time) >= 2 * seconds_a_day); });
        for (std::size_t i = 0; i < days_.size(); ++i)
            times[i] += times[i] < seconds_a_day ? days_[i] : 0;
        if (lack_day && add_days(times) > 0)
            note("column {} passes midnight", in_quotes(title(column)));
    }

    /// `unit`: 0 if it is not known; `letter`: the column is named t only.
    void take_clock(std::int64_t column, std::vector<double> values, double unit, bool letter) {
        const std::string shown = in_quotes(title(column));
        const auto count = row_count(values);
        const bool counts = count && count->step == 1;
        std::string how;
        if (unit == 0)
            unit = letter || counts ? unit_by_date(values, how) : guessed_unit(values, how);
        const double rate = rate_of(TimeSteps(values).mean * unit);
        if (!options_.fps && !is_plausible_rate(rate)) {
            if (counts)
                return take_count(column, values);
            return note("column {} as time would give {:.3g} frames a second: kept as a channel; "
                        "if it is time, put its unit into the name, as in 'time (ms)', or set "
                        "option fps",
                        shown, rate);
        }
        has_clock_ = true;
        remove_column(column);
        note("column {} is time, not a channel{}", shown, how);
        times_ = std::move(values);
        for (double& time : times_)
            time *= unit;
    }

    static bool are_rounded_times(const std::vector<double>& values) {
        const bool back = std::ranges::adjacent_find(values, [](double a, double b) {
                              return !(b >= a); // also if there is no value
                          }) != values.end();
        return values.size() > 1 && !back && values.back() > values.front() && are_rounded(values);
    }

    static double unit_by_date(const std::vector<double>& values, std::string& how) {
        const Unit* unit = unit_since_1970(values.front());
        if (unit == nullptr)
            return 1;
        how = format_text(", in {} since 1970", unit->name);
        return unit->seconds;
    }

    /// The unit, of which nothing is said, that gives a plausible rate.
    static double guessed_unit(const std::vector<double>& values, std::string& how) {
        if (unit_since_1970(values.front()) != nullptr)
            return unit_by_date(values, how);
        const double step = TimeSteps(values).mean;
        for (const Unit& unit : units)
            if (is_plausible_rate(rate_of(step * unit.seconds))) {
                if (unit.seconds < 1)
                    how = format_text("; taken as {}, since seconds would give {:.3g} frames a "
                                      "second: put the unit into the name, as in 'time (ms)'",
                                      unit.name, rate_of(step));
                return unit.seconds;
            }
        return 1;
    }

    /// A clock that goes back, or has no value, in a row. `what`: it is.
    void take_faulty(std::int64_t column, const std::vector<double>& values, std::size_t fault,
                     std::string_view what) {
        const std::string shown = in_quotes(title(column));
        const std::int64_t line = facts_.lines[fault];
        const bool missing = std::isnan(values[fault]);
        remove_column(column);
        if (std::ranges::all_of(values, [](double value) { return std::isnan(value); }))
            return note("column {} is empty: not used", shown);
        if (said_ > 0 && !missing && std::ranges::count(values, values[0]) == std::ssize(values))
            return note("column {} is {:g} in all rows: not used", shown, values[0]);
        const std::string why = missing ? "has no value"
                                        : format_text("does not increase from {:.15g} to {:.15g}",
                                                      values[fault - 1], values[fault]);
        if (options_.fps)
            return note("column {} {}, but {} at line {}: not used, as option fps is set", shown,
                        what, why, line);
        fail(Status::format,
             "{}:{}: column {} {}, but {}: cut the recording there, or set option fps to treat the "
             "rows as evenly spaced",
             name_, line, shown, what, why);
    }

    void take_counts() {
        std::int64_t subframe = -1;
        for (std::int64_t column = 0; column < clip_.values.cols(); ++column)
            if (is_subframe_name(title(column)))
                subframe = column;
        bool is_first = true;
        for (std::int64_t column = 0; column < clip_.values.cols(); ++column) {
            if (removed_[static_cast<std::size_t>(column)])
                continue;
            const bool unnamed = is_first && trim(title(column)).empty();
            if (unnamed || is_counter_name(title(column)))
                take_count(column, column_of(clip_.values, column), subframe);
            is_first = is_first && removed_[static_cast<std::size_t>(column)];
        }
    }

    void take_count(std::int64_t column, std::vector<double> values, std::int64_t subframe = -1) {
        const std::string shown = in_quotes(title(column));
        bool with_subframe = false;
        if (subframe >= 0)
            with_subframe = add_subframes(values, column_of(clip_.values, subframe));
        const auto count = row_count(values);
        if (!count) {
            const auto fault = first_fault(values);
            if (!has_clock_ && fault && *fault > 0 && is_counter_name(title(column)) &&
                are_whole(values) && mostly_increases(values))
                return take_faulty(column, values, *fault, "counts frames");
            return note("column {} does not count frames: kept as a channel", shown);
        }
        remove_column(column);
        if (with_subframe)
            remove_column(subframe);
        note("column {} counts frames: not a channel", shown);
        if (counts_.empty()) {
            counts_ = count->places;
            count_step_ = count->step;
        }
    }

    /// The first column, if nothing else says the rate, and it increases as only a clock does: in
    /// other languages, time has other names. A letter is rather an axis.
    void guess_clock() {
        constexpr std::int64_t enough_rows = 20;
        const auto first = std::ranges::find(removed_, false);
        if (first == removed_.end() || clip_.values.rows() < enough_rows)
            return;
        const std::int64_t column = first - removed_.begin();
        std::vector<double> values = column_of(clip_.values, column);
        auto unit = unit_after(title(column));
        if (const Unit* dated = unit_since_1970(values.front()))
            unit = dated->seconds;
        if (!unit || trim(title(column)).size() == 1 || first_fault(values) ||
            !are_equal_steps(values) ||
            !coordinate_of(title(column), AxisPlace::last).point.empty())
            return;
        if (!is_plausible_rate(rate_of(TimeSteps(values).mean * *unit)))
            return;
        note("column {} increases by equal steps: taken as time{}", in_quotes(title(column)),
             *unit == 1 ? ", in seconds" : "");
        has_clock_ = true;
        remove_column(column);
        times_ = std::move(values);
        for (double& time : times_)
            time *= *unit;
    }

    void remove() {
        std::vector<std::int64_t> kept;
        for (std::int64_t column = 0; column < clip_.values.cols(); ++column)
            if (!removed_[static_cast<std::size_t>(column)])
                kept.push_back(column);
        if (kept.empty())
            fail(Status::format, "{}: there is no channel besides time and frame numbers", name_);
        if (std::ssize(kept) < clip_.values.cols())
            keep_columns(clip_, kept);
    }

    void take(EvenRows even) {
        clip_.values = std::move(even.rows);
        if (!even.note.empty())
            clip_.notes.push_back(std::move(even.note));
    }

    void use_times() {
        if (times_.size() < 2)
            return;
        const TimeSteps steps(times_);
        if (options_.fps) {
            clip_.fps = rate_of(steps.usual);
            if (!steps.even() && !are_rounded(times_))
                note("the steps of time, from {:.6g} to {:.6g} s, are not used: option fps is set",
                     steps.least, steps.most);
            return;
        }
        const bool holes = !counts_.empty() && counts_.back() >= std::ssize(counts_);
        EvenRows even = even_rows(std::move(clip_.values),
                                  {times_, holes ? counts_ : std::vector<std::int64_t>(), said_,
                                   std::max(1, clip_.space)},
                                  name_);
        clip_.fps = even.fps;
        if (holes && even.rows.rows() != counts_.back() + 1)
            note("the count of frames skips {}, but the times do not: the times are used",
                 counts_.back() + 1 - std::ssize(counts_));
        if (said_ > 0 && std::abs(clip_.fps - said_) > same_rate * said_)
            note("the lines before the table say {:g} frames a second, but the times {:.6g}: the "
                 "times are used",
                 said_, clip_.fps);
        take(std::move(even));
    }

    void use_counts() {
        if (count_step_ > 1)
            note("the count of frames rises by {} a row{}", count_step_,
                 said_ > 0 ? format_text(": {:g} frames a second",
                                         said_ / static_cast<double>(count_step_))
                           : "");
        clip_.fps = said_ / static_cast<double>(count_step_);
        take(counted_rows(std::move(clip_.values), counts_, name_));
    }

    Clip& clip_;
    const TableFacts& facts_;
    const std::string& name_;
    const ReadOptions& options_;
    double said_; ///< frames a second, by the lines before the table
    std::vector<bool> removed_;
    bool has_clock_ = false;
    std::vector<double> times_; ///< seconds of the clock
    std::vector<double> days_;  ///< seconds from 1970 to the day; empty: the day is not apart
    std::vector<std::int64_t> counts_;
    std::int64_t count_step_ = 1;
};

void note_unnamed_time(Clip& clip) {
    const std::vector<double> first = column_of(clip.values, 0);
    if (first_fault(first))
        return;
    if (are_equal_steps(first))
        clip.notes.push_back("column 1 increases by equal steps: if it is time or a frame number, "
                             "remove it, or name it so in a header line");
}

} // namespace

bool is_plausible_rate(double rate) {
    constexpr double least = 2, most = 1e5;
    return rate >= least && rate <= most;
}

void extract_time(Clip& clip, const TableFacts& facts, const std::string& name,
                  const ReadOptions& options, const std::function<void()>& take_channels) {
    const bool unnamed = clip.channel_names.empty();
    if (unnamed && facts.dated.empty() && clip.values.rows() > 1)
        note_unnamed_time(clip);
    if (unnamed && facts.dated.empty())
        return take_channels();
    if (unnamed) // so that the dates can be removed
        clip.channel_names.assign(static_cast<std::size_t>(clip.values.cols()), "x");
    TimeColumns(clip, facts, name, options).extract(take_channels);
    if (unnamed)
        clip.channel_names.clear();
}

} // namespace stltsa::clip
