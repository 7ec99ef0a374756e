// SPDX-License-Identifier: BSD-3-Clause
#include "clip/arrays/even_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

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

EvenRows even_rows(Matrix rows, std::span<const double> times, const std::string& where) {
    const TimeSteps steps(times);
    if (steps.even())
        return {std::move(rows), rate_of(steps.mean), {}};
    const double fps = rate_of(steps.usual);
    const double count = std::floor((times.back() - times.front()) * fps + 1e-6) + 1;
    if (!(count <= (1 + most_missing) * static_cast<double>(rows.rows())))
        fail(Status::format,
             "{}: the steps of time range from {:.6g} to {:.6g} s, and more frames are missing "
             "than there are: cut the recording at its breaks, or set option fps to treat the "
             "rows as evenly spaced",
             where, steps.least, steps.most);
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

} // namespace stltsa::clip
