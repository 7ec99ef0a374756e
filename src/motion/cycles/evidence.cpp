// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "linalg/simd.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// Logistic regression on the candidate cycles of the first half of the sets of measure/cycles, in
/// which those of loops within a period count a tenth and recorded moves three times. On the other
/// half, measure/cycles prints how many cycles of each confidence are right.
constexpr double base = -0.66;
constexpr double of_deviation = -0.99;
constexpr double of_length = -13.21;
constexpr double of_mismatch = -0.82;
/// Least deviation, and least mismatch one period apart, that are told from none.
constexpr double min_deviation = 0.01;
constexpr double min_mismatch = 0.02;
/// The logistic regression for borders beside no, one and two single actions, on the logarithm of
/// the gain. Beside one action, the gain says nothing. Borders between two actions are mostly in
/// noise and sway, where any border is arbitrary.
struct LogisticOfGain {
    double base, slope;
};
constexpr LogisticOfGain of_gain[] = {{1.1, 3}, {1.7, 0}, {-3.6, 1.5}};
constexpr double at_rest = 0.97;
constexpr double at_rest_between_actions = 0.6;
/// Share of right answers among segments up to this length.
struct ShareOfLength {
    double seconds, right;
};
constexpr double any = std::numeric_limits<double>::infinity();
constexpr ShareOfLength of_action[] = {{1, 0.85}, {4, 0.5}, {any, 0.05}};
constexpr ShareOfLength of_rest[] = {{1, 0.6}, {2, 0.8}, {any, 0.92}};
double share_of(std::span<const ShareOfLength> shares, double seconds) {
    return std::ranges::find_if(
               shares, [&](const ShareOfLength& share) { return seconds <= share.seconds; })
        ->right;
}

double logistic(double x) {
    return 1 / (1 + std::exp(-x));
}

/// The rows of the run within the cycle, counted from its begin.
Range rows_in(const Run& run, const Interval& cycle) {
    const auto row = [&](double at) {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::ceil(at)) - run.begin, 0,
                                        run.rows());
    };
    return {row(cycle.begin), row(cycle.end)};
}

/// Mean squared deviation of the rows of the cycle from the mean cycle, of which n cycles are a
/// part: times n / (n - 1), which the weights above were fitted with. NaN if no row has another
/// cycle.
double deviation_of(const Growth& growth, const Interval& cycle) {
    const Run& run = growth.run;
    double sum = 0, count = 0;
    const Range rows = rows_in(run, cycle);
    for (std::int64_t i = rows.begin; i < rows.end; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double phase = run.phase[at];
        const double seen =
            std::floor(run.phase.back() - phase) + std::floor(phase - run.phase.front()) + 1;
        if (seen < 2)
            continue;
        sum += growth.deviation[at] * seen / (seen - 1);
        ++count;
    }
    return sum / count;
}

/// Length of the cycle in tracked periods, on a log scale. A cycle at a rest lacks the time of the
/// pauses between the others.
double length_deviation(const CyclicStretch& cut, const Interval& cycle) {
    const Stretch& tracked = cut.stretch;
    double periods = 0;
    for (double row = cycle.begin; row < cycle.end; ++row)
        periods += std::min(1.0, cycle.end - row) / tracked.period_at(row);
    const bool ends_at_rest = (cut.from_rest && cycle.begin == cut.borders.front()) ||
                              (cut.to_rest && cycle.end == cut.borders.back());
    return ends_at_rest ? std::max(std::log(periods), 0.0) : std::abs(std::log(periods));
}

} // namespace

double mean_of(std::span<const double> values) {
    return values.empty() ? 0
                          : sum(values.data(), static_cast<std::int64_t>(values.size())) /
                                static_cast<double>(values.size());
}

double likeness_of(const CyclicStretch& cut, const Interval& cycle) {
    const Range rows = rows_in(cut.growth.run, cycle);
    if (rows.rows() < 1)
        return 0;
    const double mean = mean_of(
        std::span(cut.growth.deviation)
            .subspan(static_cast<std::size_t>(rows.begin), static_cast<std::size_t>(rows.rows())));
    return std::clamp(1 - mean / 2, 0.0, 1.0);
}

std::vector<double> cycle_confidences(const CyclicStretch& cut) {
    const std::vector<Interval> cycles = cut.cycles();
    std::vector<double> confidences;
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        const double deviation = deviation_of(cut.growth, cycles[i]);
        confidences.push_back(
            std::isnan(deviation)
                ? 0
                : logistic(base + of_deviation * std::log(deviation + min_deviation) +
                           of_length * length_deviation(cut, cycles[i]) +
                           of_mismatch * std::log(1 + min_mismatch - cut.stretch.quality)));
    }
    return confidences;
}

double border_confidence(double gain, int actions) {
    const LogisticOfGain& law = of_gain[std::clamp(actions, 0, 2)];
    return gain > 0 ? logistic(law.base + law.slope * std::log(gain)) : 0;
}

double rest_border_confidence(int actions) {
    return actions < 2 ? at_rest : at_rest_between_actions;
}

double repetition_confidence(double unlikeness) {
    return std::clamp(1 - 0.4 * unlikeness, 0.0, 1.0);
}

double action_confidence(double seconds) {
    return share_of(of_action, seconds);
}

double rest_confidence(double seconds) {
    return share_of(of_rest, seconds);
}

} // namespace stltsa::motion
