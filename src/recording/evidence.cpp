// SPDX-License-Identifier: BSD-3-Clause
#include "recording/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "linalg/simd.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::recording {
namespace {

constexpr std::int64_t phases = 24;
/// Logistic regression on candidate cycles of mixtures, clips and noise.
constexpr double base = -6.34;
constexpr double of_match = 8.01;
constexpr double of_cyclicity = 5.96;
constexpr double of_length = -39.7;
/// The same for borders beside no, one and two single actions. Most of the last are in noise and
/// sway, which are divided somewhere.
struct LogisticOfGain {
    double base, slope;
};
constexpr LogisticOfGain of_gain[] = {{1.1, 3}, {2, 0.6}, {-3.6, 1.5}};
constexpr double at_rest = 0.97;
constexpr double at_rest_between_actions = 0.6;
/// Share of right answers among segments up to this length.
struct ShareOfLength {
    double seconds, right;
};
constexpr double any = std::numeric_limits<double>::infinity();
constexpr ShareOfLength of_action[] = {{1, 0.85}, {4, 0.5}, {any, 0.05}};
constexpr ShareOfLength of_rest[] = {{1, 0.6}, {2, 0.8}, {any, 0.92}};
/// Cycles are neighbors if less than this share of their length lies between them.
constexpr double most_apart = 0.05;
/// A window beside a cycle may reach beyond the end of the recording by this share.
constexpr double beyond_end = 0.3;

double share_of(std::span<const ShareOfLength> shares, double seconds) {
    return std::ranges::find_if(
               shares, [&](const ShareOfLength& share) { return seconds <= share.seconds; })
        ->right;
}

double logistic(double x) {
    return 1 / (1 + std::exp(-x));
}

Matrix scaled_velocities(const Signal& signal, const Interval& cycle) {
    Matrix v = rows_at(signal.velocity.view(), cycle.begin, cycle.end, phases);
    for (std::int64_t i = 0; i < v.rows() * v.cols(); ++i)
        v.data()[i] *= cycle.length();
    return v;
}

/// 1: the same velocities at each phase.
double match(const Matrix& a, const Matrix& b) {
    const std::int64_t n = a.rows() * a.cols();
    const double energy = dot(a.data(), a.data(), n) + dot(b.data(), b.data(), n);
    return energy > 0 ? 2 * dot(a.data(), b.data(), n) / energy : 0;
}

struct Neighbors {
    std::optional<Interval> before, after;
};

Neighbors neighbors_of(const std::vector<Interval>& cycles, std::size_t i) {
    Neighbors beside;
    const double apart = most_apart * cycles[i].length();
    if (i > 0 && std::abs(cycles[i - 1].end - cycles[i].begin) < apart)
        beside.before = cycles[i - 1];
    if (i + 1 < cycles.size() && std::abs(cycles[i + 1].begin - cycles[i].end) < apart)
        beside.after = cycles[i + 1];
    return beside;
}

/// The better match with the cycle before or after, or with what is there.
double best_match(const Signal& signal, const Interval& cycle, const Neighbors& beside) {
    const double length = cycle.length();
    const auto rows = static_cast<double>(signal.rows());
    const Matrix own = scaled_velocities(signal, cycle);
    double best = -0.2;
    const Interval windows[] = {beside.before.value_or(Interval{cycle.begin - length, cycle.begin}),
                                beside.after.value_or(Interval{cycle.end, cycle.end + length})};
    for (const Interval& window : windows)
        if (window.begin >= -beyond_end * length && window.end <= rows - 1 + beyond_end * length)
            best = std::max(best, match(own, scaled_velocities(signal, window)));
    return best;
}

/// Deviation of the length from those beside, or from the median, on a log scale.
double length_deviation(const Interval& cycle, const Neighbors& beside, double median) {
    const double own = std::log(cycle.length());
    double least = std::abs(own - median);
    if (beside.before && beside.after)
        least = std::min(least, std::abs(own - (std::log(beside.before->length()) +
                                                std::log(beside.after->length())) /
                                                   2));
    return least;
}

} // namespace

std::vector<double> cycle_confidences(const Signal& signal, const CyclicStretch& cut) {
    std::vector<double> lengths, confidences;
    for (const Interval& cycle : cut.cycles)
        lengths.push_back(std::log(cycle.length()));
    const double median = motion::median(lengths);
    for (std::size_t i = 0; i < cut.cycles.size(); ++i) {
        const Neighbors beside = neighbors_of(cut.cycles, i);
        confidences.push_back(
            logistic(base + of_match * best_match(signal, cut.cycles[i], beside) +
                     of_cyclicity * cut.cyclicity +
                     of_length * length_deviation(cut.cycles[i], beside, median)));
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

} // namespace stltsa::recording
