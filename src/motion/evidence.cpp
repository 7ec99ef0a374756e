// SPDX-License-Identifier: BSD-3-Clause
#include "motion/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "motion/coordinate.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/period.hpp"

namespace stltsa::motion {
namespace {

/// Quality is 2 r - 1, where r is the correlation of the motion with itself one period later: at
/// least 0.7, or 0.75 for a single cycle.
constexpr double least_quality = 0.4;
constexpr double least_quality_of_one = 0.5;
constexpr double least_cyclicity = 0.65;
/// Allowed relative difference between the curve's cycles and the motion's period.
constexpr double most_disagreement = 0.15;
/// The cycles have a period of their own if they contain this share of the clip's motion.
constexpr double least_share = 0.5;
constexpr std::size_t margins_of_a_cycle = 3;

/// The samples between the margins, and a quarter of a period more to each side.
Span around(const std::vector<double>& margins, double period, std::int64_t samples) {
    const auto first = static_cast<std::int64_t>(std::max(0.0, margins.front() - period / 4));
    const auto end = std::min(samples, static_cast<std::int64_t>(margins.back() + period / 4) + 1);
    return {first, end - first};
}

double share_of_motion(Span span, const Activity& activity) {
    double inside = 0;
    double all = 0;
    for (std::int64_t i = 0; i < activity.samples(); ++i) {
        if (!activity.moving(i))
            continue;
        ++all;
        if (i >= span.first && i < span.first + span.count)
            ++inside;
    }
    return all > 0 ? inside / all : 0;
}

double median_cycle(const std::vector<double>& margins) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i + 2 < margins.size(); ++i)
        lengths.push_back(margins[i + 2] - margins[i]);
    return median(lengths);
}

} // namespace

Evidence weigh(const std::vector<double>& margins, ConstMatrixView samples,
               const Activity& activity, const std::vector<double>& coordinate, double cyclicity,
               const Period& period, double fps, const Progress& progress) {
    Evidence evidence{period, cyclicity, margins.size(), median_cycle(margins)};
    if (margins.size() <= margins_of_a_cycle)
        return evidence;
    const Span span = around(margins, period.samples, samples.rows);
    if (share_of_motion(span, activity) < least_share)
        return evidence;
    const auto level = activity.levels(span.first, span.count);
    const auto refined =
        refine_period(samples.block(span.first, span.count), level, period.samples, fps, progress);
    if (refined) {
        evidence.period = *refined;
        evidence.cyclicity = motion::cyclicity(std::span(coordinate)
                                                   .subspan(static_cast<std::size_t>(span.first),
                                                            static_cast<std::size_t>(span.count)),
                                               level, refined->samples);
    }
    return evidence;
}

std::string doubt(const Evidence& evidence, double fps) {
    const double period_s = evidence.period.samples / fps;
    if (evidence.margins < margins_of_a_cycle)
        return format_text("less than one cycle: the clip resembles itself most after {:.2f} s "
                           "(quality {:.2f}; 1: it repeats), but its curve completes no cycle",
                           period_s, evidence.period.quality);
    const double quality_needed =
        evidence.margins > margins_of_a_cycle ? least_quality : least_quality_of_one;
    if (evidence.period.quality < quality_needed)
        return format_text("low quality: the clip resembles itself most after {:.2f} s, but with "
                           "a quality of only {:.3f}, below {:.2f} (1: it repeats)",
                           period_s, evidence.period.quality, quality_needed);
    if (evidence.cyclicity < least_cyclicity)
        return format_text("low cyclicity: the motion repeats after {:.2f} s (quality {:.2f}), but "
                           "the curve has a cyclicity of only {:.3f}, below {:.2f}",
                           period_s, evidence.period.quality, evidence.cyclicity, least_cyclicity);
    if (std::abs(evidence.cycle / evidence.period.samples - 1) > most_disagreement)
        return format_text("cycles of uneven length: the motion repeats best after {:.2f} s "
                           "(quality {:.2f}), but the curve's cycles last {:.2f} s",
                           period_s, evidence.period.quality, evidence.cycle / fps);
    return {};
}

} // namespace stltsa::motion
