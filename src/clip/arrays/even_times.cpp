// SPDX-License-Identifier: BSD-3-Clause
#include "clip/arrays/even_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "clip/clip.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

/// Single steps that are shorter tell no rate; longer ones are gaps. In median steps.
constexpr double shortest_step = 0.5;
constexpr double longest_step = 1.5;
/// Times that jitter by up to half a step have steps up to twice as long as usual.
constexpr double longest_jittered = 2.5;
/// Steps jitter if the middle half of them differ by more than this share of the median.
constexpr double most_jitter = 0.2;
/// More rows than this share of those given are not made up.
constexpr double most_missing = 1;

/// Frames by which rows may be away from their places: if something else tells that these are
/// consecutive, and if only their times do.
constexpr double farthest_known = 0.5;
constexpr double farthest_inferred = 0.1;
/// The same for times with few digits, if these explain it.
constexpr double farthest_rounded = 0.75;

using Places = std::vector<std::int64_t>;

double duration(std::span<const double> times) {
    return times.back() - times.front();
}

/// The unit of the last digit with which all times were written; 0: they have many digits.
double digit_of(std::span<const double> times) {
    constexpr int most_digits = 6;
    constexpr double error = 1e-3; // of the unit
    double scale = 1;
    for (int digits = 0; digits <= most_digits; ++digits, scale *= 10)
        if (std::ranges::all_of(times, [scale](double time) {
                return std::abs(time * scale - std::round(time * scale)) <= error;
            }))
            return 1 / scale;
    return 0;
}

/// Frames by which the times are at most away from even ones, of which the first and the last are
/// given.
double farthest(std::span<const double> times, std::span<const std::int64_t> places) {
    const double step = duration(times) / static_cast<double>(places.back());
    double away = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
        away = std::max(
            away, std::abs((times[i] - times.front()) / step - static_cast<double>(places[i])));
    return away;
}

/// Whether the times are those of places that the file counts, but rounded.
bool follow_rounded(std::span<const double> times, std::span<const std::int64_t> counts) {
    const double step = duration(times) / static_cast<double>(counts.back());
    return farthest(times, counts) <= digit_of(times) / step;
}

Places consecutive(std::size_t count) {
    Places places(count);
    std::iota(places.begin(), places.end(), std::int64_t{0});
    return places;
}

/// Places a whole number of usual steps apart; none if they were far more than the rows.
Places places_by_steps(std::span<const double> times, double usual) {
    Places places{0};
    const double most = (1 + most_missing) * static_cast<double>(times.size());
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double steps = std::max(1.0, std::round((times[i] - times[i - 1]) / usual));
        if (!(static_cast<double>(places.back()) + steps <= most))
            return {};
        places.push_back(places.back() + static_cast<std::int64_t>(steps));
    }
    return places;
}

/// The line of least squares through the times of places.
struct TimeLine {
    double step = 0;   ///< seconds from one place to the next
    double spread = 0; ///< between the earliest and the latest time, from the line
};

TimeLine line_through(std::span<const double> times, std::span<const std::int64_t> places) {
    const auto count = static_cast<double>(times.size());
    double time = 0, place = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        time += (times[i] - times.front()) / count;
        place += static_cast<double>(places[i]) / count;
    }
    const auto late = [&](std::size_t i) { return times[i] - times.front() - time; };
    const auto far = [&](std::size_t i) { return static_cast<double>(places[i]) - place; };
    double products = 0, squares = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        products += far(i) * late(i);
        squares += far(i) * far(i);
    }
    TimeLine line{products / squares, 0};
    double least = 0, most = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        least = std::min(least, late(i) - line.step * far(i));
        most = std::max(most, late(i) - line.step * far(i));
    }
    line.spread = most - least;
    return line;
}

/// The line through the rows with which rounded times change. The rows before the first and after
/// the last change are fewer than the others of their times, so that all rows would tilt it.
double step_of_rounded(std::span<const double> times, std::span<const std::int64_t> places) {
    std::vector<double> changes;
    Places rows;
    for (std::size_t i = times[1] > times[0] ? 0 : 1; i < times.size(); ++i)
        if (i == 0 || times[i] > times[i - 1]) {
            changes.push_back(times[i]);
            rows.push_back(places[i]);
        }
    return changes.size() > 1 ? line_through(changes, rows).step
                              : duration(times) / static_cast<double>(places.back());
}

/// Times with few digits leave several rates open, and the first and the last of them are less
/// exact than all.
double rate_of_places(std::span<const std::int64_t> places, const Clock& clock) {
    constexpr double exact = 5e-4; // as rate_of()
    const double seconds = duration(clock.times), digit = digit_of(clock.times);
    const double step = digit > 0 ? step_of_rounded(clock.times, places)
                                  : seconds / static_cast<double>(places.back());
    const double rate = 1 / step;
    if (!std::isfinite(rate))
        return 0;
    // The change of a rounded time is known to within one row.
    const double error = std::clamp(std::min(digit, step) / seconds, exact, same_rate);
    const auto open = [&](double other) { return std::abs(other - rate) <= error * rate; };
    if (clock.fps > 0 && open(clock.fps))
        return clock.fps;
    return open(std::round(rate)) ? std::round(rate) : rate;
}

[[noreturn]] void fail_missing(const std::string& where, const std::string& what,
                               std::string_view remedy) {
    fail(Status::format,
         "{}: {}, and more frames are missing than there are: cut the recording at its breaks, or "
         "{}",
         where, what, remedy);
}
constexpr std::string_view ignore_times = "set option fps to treat the rows as evenly spaced";
constexpr std::string_view ignore_counts = "remove the column that counts the frames";

Matrix placed(const Matrix& rows, std::span<const std::int64_t> places) {
    Matrix even(places.back() + 1, rows.cols());
    std::fill_n(even.data(), even.rows() * even.cols(), std::numeric_limits<double>::quiet_NaN());
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        std::copy_n(rows.row(i), rows.cols(), even.row(places[static_cast<std::size_t>(i)]));
    return even;
}

/// `by`: what tells that rows are missing.
EvenRows placed_rows(Matrix rows, std::span<const std::int64_t> places, double fps,
                     std::string_view by, const std::string& where) {
    const std::int64_t count = places.back() + 1, missing = count - rows.rows();
    if (static_cast<double>(missing) > most_missing * static_cast<double>(rows.rows()))
        fail_missing(where, format_text("{} rows span {} frames", rows.rows(), count),
                     fps > 0 ? ignore_times : ignore_counts);
    if (missing == 0)
        return {std::move(rows), fps, {}};
    return {
        placed(rows, places), fps,
        format_text("rows are missing by {}: {} of {} frames have no value", by, missing, count)};
}

/// Whether each step is much like one beside it, as those of an integrator are: none is a gap.
bool vary_slowly(std::span<const double> times) {
    const auto step = [times](std::size_t i) { return times[i + 1] - times[i]; };
    const std::size_t count = times.size() - 1;
    for (std::size_t i = 0; i < count; ++i)
        if (step(i) >
            longest_jittered * std::max(i > 0 ? step(i - 1) : 0, i + 1 < count ? step(i + 1) : 0))
            return false;
    return true;
}

/// What is missing has no number that could be taken for one.
void mark_missing(Matrix& rows, int width) {
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        for (double* group = rows.row(i); group < rows.row(i) + rows.cols(); group += width)
            if (is_missing(group, width))
                std::fill_n(group, width, std::numeric_limits<double>::quiet_NaN());
}

EvenRows resampled(Matrix rows, const Clock& clock, TimeSteps steps, const std::string& where) {
    mark_missing(rows, clock.width);
    const std::span<const double> times = clock.times;
    if (vary_slowly(times)) {
        steps.usual = steps.mean;
        steps.longest = steps.most;
    }
    const double fps = rate_of(steps.usual);
    const double count = std::floor(duration(times) * fps + 1e-6) + 1;
    if (!(count <= (1 + most_missing) * static_cast<double>(rows.rows())))
        fail_missing(
            where,
            format_text("the steps of time range from {:.6g} to {:.6g} s", steps.least, steps.most),
            ignore_times);
    Matrix even(static_cast<std::int64_t>(count), rows.cols());
    std::size_t next = 1;
    std::int64_t missing = 0;
    for (std::int64_t i = 0; i < even.rows(); ++i) {
        const double time = times.front() + static_cast<double>(i) / fps;
        while (next + 1 < times.size() && times[next] < time)
            ++next;
        const double step = times[next] - times[next - 1];
        const double share = std::clamp((time - times[next - 1]) / step, 0.0, 1.0);
        // Beside a break, the rows at its ends are still good within half a step.
        const double away = std::min(share, 1 - share) * step * fps;
        const bool absent = step > steps.longest && away > 0.5;
        missing += absent ? 1 : 0;
        const double* before = rows.row(static_cast<std::int64_t>(next) - 1);
        const double* after = rows.row(static_cast<std::int64_t>(next));
        for (std::int64_t c = 0; c < even.cols(); ++c)
            even(i, c) = absent                 ? std::numeric_limits<double>::quiet_NaN()
                         : step > steps.longest ? (share < 0.5 ? before[c] : after[c])
                                                : (1 - share) * before[c] + share * after[c];
    }
    return {std::move(even), fps,
            format_text("steps of time from {:.6g} to {:.6g} s: resampled to {:.6g} frames a "
                        "second, of which {} have no value",
                        steps.least, steps.most, fps, missing)};
}

} // namespace

TimeSteps::TimeSteps(std::span<const double> times) {
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < times.size(); ++i)
        steps.push_back(times[i + 1] - times[i]);
    std::sort(steps.begin(), steps.end());
    least = steps.front();
    median = steps[steps.size() / 2];
    most = steps.back();
    mean = (times.back() - times.front()) / static_cast<double>(steps.size());
    usual = mean;
    if (!(least > 0)) // these are no times
        return;
    // Rounded up, so that one of three steps is an exception.
    const std::size_t quarter = (steps.size() + 2) / 4;
    const double spread = steps[steps.size() - 1 - quarter] - steps[quarter];
    const bool jitters = spread > most_jitter * median;
    longest = (jitters ? longest_jittered : longest_step) * median;
    // The median is not the mean of steps that jitter, nor of rounded ones.
    const auto begin = std::ranges::lower_bound(steps, jitters ? 0 : shortest_step * median);
    const auto end = std::ranges::upper_bound(steps, longest);
    usual = std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
}

bool TimeSteps::even() const {
    return least >= shortest_step * median && most <= longest_step * median;
}

bool are_rounded(std::span<const double> times) {
    // Fewer steps that are longer or shorter than most are more likely lost or repeated rows.
    constexpr double least_share = 0.1, least_count = 3;
    constexpr double rounding = 1.25; // units between two errors: 1, and the error of the line
    const auto steps = static_cast<double>(times.size() - 1);
    const double digit = digit_of(times), units = duration(times) / steps / digit;
    if (!(digit > 0) || !(units > 0 && units < 2) || duration(times) < (least_count - 0.5) * digit)
        return false;
    const double odd = std::abs(units - 1);
    if ((units >= 1 && odd < least_share) || steps * std::min(odd, 2 - units) < least_count)
        return false;
    return line_through(times, consecutive(times.size())).spread <= rounding * digit;
}

bool are_equal_steps(std::span<const double> times) {
    constexpr double exact = 1e-3, rounding = 2; // two steps differ by twice the error of a time
    const TimeSteps steps(times);
    const double digit = std::min(digit_of(times), steps.mean / 10);
    return steps.most - steps.least <= std::max(exact * steps.mean, rounding * digit);
}

EvenRows even_rows(Matrix rows, const Clock& clock, const std::string& where) {
    const std::span<const double> times = clock.times;
    const TimeSteps steps(times);
    const Places all = consecutive(times.size());
    const bool even = steps.even() && farthest(times, all) <= farthest_known;
    const bool counted =
        !clock.counts.empty() && (farthest(times, clock.counts) <= farthest_known ||
                                  (!even && follow_rounded(times, clock.counts)));
    if (counted)
        return placed_rows(std::move(rows), clock.counts, rate_of_places(clock.counts, clock),
                           "the count of frames", where);
    if (even || are_rounded(times))
        return {std::move(rows), rate_of_places(all, clock), {}};
    const Places places = places_by_steps(times, steps.usual);
    const double rounded = std::min(digit_of(times) / steps.usual, farthest_rounded);
    if (!places.empty() && farthest(times, places) <= std::max(rounded, farthest_inferred))
        return placed_rows(std::move(rows), places, rate_of_places(places, clock), "the times",
                           where);
    return resampled(std::move(rows), clock, steps, where);
}

EvenRows counted_rows(Matrix rows, std::span<const std::int64_t> counts, const std::string& where) {
    return placed_rows(std::move(rows), counts, 0, "the count of frames", where);
}

} // namespace stltsa::clip
