// SPDX-License-Identifier: BSD-3-Clause
#include "recording/stretch_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "motion/curve/extrema.hpp"
#include "motion/curve/smoothing.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::recording {
namespace {

// The values of motion/margins.cpp and motion/evidence.cpp; the two of a single clip.
constexpr double curve_smoothing = 0.06;
constexpr double prominence = 0.25;
constexpr double like_swing = 0.6;
constexpr double like_swing_cut = 0.4;
constexpr double most_swing = 2;
constexpr double like_steepness = 0.7;
constexpr double shortest_cycle = 0.7;
constexpr double longest_cycle = 1.4;
constexpr double least_cyclicity = 0.65;
constexpr double least_quality = 0.4;
constexpr double least_quality_of_few = 0.5;
constexpr std::size_t few_cycles = 2;
constexpr std::size_t margins_of_a_cycle = 3;
/// No margin is found nearer to the ends of the curve than this share of a period.
constexpr double at_end = 2.0 / samples_per_period;
constexpr double steady = 0.08;
/// The height of the curve is that of so many periods to each side.
constexpr std::int64_t height_periods = 8;

struct Margin {
    double at = 0; ///< warped samples
    double swing = 0;
    double steepness = 0;
    bool rising = false;
    bool cut = false; ///< the curve ends within its swing
};

/// The curve divided by its height around each sample, from the 5th to the 95th percentile.
std::vector<double> leveled(const std::vector<double>& curve) {
    const auto n = static_cast<std::int64_t>(curve.size());
    constexpr std::int64_t hop = samples_per_period;
    constexpr std::int64_t reach = height_periods * samples_per_period;
    std::vector<double> result(curve.size());
    for (std::int64_t a = 0; a < n; a += hop) {
        const std::int64_t first = std::max<std::int64_t>(0, a - reach);
        const auto around = std::span(curve).subspan(
            static_cast<std::size_t>(first),
            static_cast<std::size_t>(std::min(n, a + reach + hop) - first));
        const double height = motion::quantile(around, 0.95) - motion::quantile(around, 0.05);
        for (std::int64_t i = a; i < std::min(n, a + hop) && height > 0; ++i)
            result[static_cast<std::size_t>(i)] = curve[static_cast<std::size_t>(i)] / height;
    }
    return result;
}

/// The steepest sample between two extrema; none at the very ends, where it may lie beyond.
std::vector<Margin> find_margins(const std::vector<double>& curve) {
    const auto extrema = motion::alternating_extrema(curve, prominence);
    const std::vector<double> slopes = motion::slope(curve);
    const auto steep = [&](std::int64_t i) {
        return std::abs(slopes[static_cast<std::size_t>(i)]);
    };
    std::vector<Margin> margins;
    for (std::size_t e = 0; e + 1 < extrema.size(); ++e) {
        std::int64_t at = extrema[e].at;
        for (std::int64_t i = at; i <= extrema[e + 1].at; ++i)
            if (steep(i) > steep(at))
                at = i;
        if (at < 2 || at + 2 >= static_cast<std::int64_t>(curve.size()))
            continue;
        const double offset = motion::parabola_vertex(steep(at - 1), steep(at), steep(at + 1));
        margins.push_back({static_cast<double>(at) + offset,
                           std::abs(curve[static_cast<std::size_t>(extrema[e + 1].at)] -
                                    curve[static_cast<std::size_t>(extrema[e].at)]),
                           steep(at), extrema[e + 1].peak,
                           extrema[e].at == 0 ||
                               extrema[e + 1].at + 1 == static_cast<std::int64_t>(curve.size())});
    }
    return margins;
}

template <class Value, class Which>
double median_of(const std::vector<Margin>& margins, Value value, Which which) {
    std::vector<double> values;
    for (const Margin& margin : margins)
        if (which(margin))
            values.push_back(value(margin));
    return motion::median(values);
}

using Sequence = std::vector<Margin>;

/// The regular sequences: swings as high as the others, one period from margin i to i + 2.
std::vector<Sequence> regular_sequences(const std::vector<Margin>& margins) {
    const double swing = median_of(
        margins, [](const Margin& m) { return m.swing; }, [](const Margin&) { return true; });
    const double steepness[] = {median_of(
                                    margins, [](const Margin& m) { return m.steepness; },
                                    [](const Margin& m) { return !m.rising; }),
                                median_of(
                                    margins, [](const Margin& m) { return m.steepness; },
                                    [](const Margin& m) { return m.rising; })};
    std::vector<Sequence> sequences;
    Sequence sequence;
    const auto close = [&] {
        if (sequence.size() >= margins_of_a_cycle)
            sequences.push_back(sequence);
        sequence.clear();
    };
    constexpr double period = samples_per_period;
    for (const Margin& margin : margins) {
        if (margin.swing < (margin.cut ? like_swing_cut : like_swing) * swing ||
            margin.swing > most_swing * swing ||
            margin.steepness < like_steepness * steepness[margin.rising ? 1 : 0]) {
            close();
            continue;
        }
        if (sequence.size() == 1 && margin.at - sequence[0].at > longest_cycle * period)
            sequence.clear();
        if (sequence.size() > 1) {
            const double cycle = margin.at - sequence[sequence.size() - 2].at;
            if (cycle < shortest_cycle * period || cycle > longest_cycle * period) {
                const Margin last = sequence.back();
                close();
                if (margin.at - last.at <= longest_cycle * period)
                    sequence.push_back(last);
            }
        }
        sequence.push_back(margin);
    }
    close();
    return sequences;
}

double row_of(const std::vector<double>& places, double sample) {
    const auto before = std::min(static_cast<std::size_t>(sample), places.size() - 2);
    const double part = sample - static_cast<double>(before);
    return (1 - part) * places[before] + part * places[before + 1];
}

/// The margin before the first, or none if the next two cycles differ in length.
std::optional<double> margin_before(std::span<const double> margins) {
    const double period = margins[3] - margins[1];
    if (std::abs(margins[2] - margins[0] - period) > steady * std::abs(period))
        return {};
    return margins[1] - period;
}

/// Adds the margins at the very ends of the rows, where the curve does not show them, if the period
/// is steady there. The rows may end half a row before the motion does.
void add_end_margins(Rows range, std::vector<double>& margins) {
    if (margins.size() < margins_of_a_cycle + 1)
        return;
    const auto begin = static_cast<double>(range.begin), end = static_cast<double>(range.end);
    const double reach = at_end * (margins[3] - margins[1]);
    if (const auto first = margin_before(margins);
        first && *first >= begin - 0.5 && *first < begin + reach)
        margins.insert(margins.begin(), std::max(*first, begin));
    const std::size_t n = margins.size();
    const double from_end[] = {margins[n - 1], margins[n - 2], margins[n - 3], margins[n - 4]};
    if (const auto last = margin_before(from_end);
        last && *last <= end + 0.5 && *last > end - reach)
        margins.push_back(std::min(*last, end));
}

bool holds_rest(const Interval& cycle, const std::vector<Rows>& rests) {
    return std::ranges::any_of(rests, [&](const Rows& rest) {
        return static_cast<double>(rest.begin) >= cycle.begin - 1 &&
               static_cast<double>(rest.end) <= cycle.end + 1;
    });
}

std::string doubt_about(const CyclicStretch& cut, const StillRows& still, double rate) {
    const double seconds = motion::median(cut.stretch.period) / rate;
    if (cut.phase.curve.empty())
        return format_text("a repetition after {:.2f} s lasts less than one and a half periods",
                           seconds);
    if (cut.cyclicity < least_cyclicity)
        return format_text("low cyclicity: the motion repeats after {:.2f} s (quality {:.2f}), but "
                           "the curve has a cyclicity of only {:.3f}, below {:.2f}",
                           seconds, cut.stretch.quality, cut.cyclicity, least_cyclicity);
    const bool few = cut.cycles.size() <= few_cycles;
    const double needed = few ? least_quality_of_few : least_quality;
    if (cut.stretch.quality < needed)
        return format_text("low quality: it resembles itself most after {:.2f} s, but with a "
                           "quality of only {:.3f}, below {:.2f} (1: it repeats)",
                           seconds, cut.stretch.quality, needed);
    if (cut.cycles.empty())
        return format_text("less than one cycle: it resembles itself most after {:.2f} s "
                           "(quality {:.2f}; 1: it repeats), but completes no cycle",
                           seconds, cut.stretch.quality);
    const bool rested = std::ranges::any_of(
        cut.cycles, [&](const Interval& cycle) { return holds_rest(cycle, still.rests); });
    if ((few && rested) || paused(cut.cycles, still.pauses))
        return format_text("a rest within each repetition: the motion repeats after {:.2f} s",
                           seconds);
    return {};
}

} // namespace

double CyclicStretch::period() const {
    std::vector<double> lengths;
    for (const Interval& cycle : cycles)
        lengths.push_back(cycle.length());
    return motion::median(lengths);
}

bool paused(const std::vector<Interval>& cycles, const std::vector<Rows>& pauses) {
    const auto held = std::ranges::count_if(
        cycles, [&](const Interval& cycle) { return holds_rest(cycle, pauses); });
    return 2 * held > static_cast<std::ptrdiff_t>(cycles.size());
}

CyclicStretch cut_stretch(const Signal& signal, const Stretch& stretch, const StillRows& still,
                          const Anchor* like, RowProgress& progress) {
    CyclicStretch cut{stretch, trace_phase(signal, stretch, like, progress), 0, {}, {}, {}};
    if (!cut.phase.curve.empty()) {
        cut.cyclicity = cut.phase.typical_cyclicity();
        for (std::vector<double>* curve : {&cut.phase.curve, &cut.phase.partner})
            *curve = leveled(motion::smooth(*curve, curve_smoothing * samples_per_period));
        for (const Sequence& sequence : regular_sequences(find_margins(cut.phase.curve))) {
            std::vector<double> rows;
            for (const Margin& margin : sequence)
                rows.push_back(row_of(cut.phase.places, margin.at));
            add_end_margins(stretch.rows, rows);
            // Cycles begin on the same side of the coordinate everywhere.
            if (like != nullptr && !sequence.front().rising)
                rows.erase(rows.begin());
            if (rows.size() < margins_of_a_cycle)
                continue;
            for (std::size_t i = 0; i + 2 < rows.size(); i += 2)
                cut.cycles.push_back({rows[i], rows[i + 2]});
            cut.margins.push_back(std::move(rows));
        }
    }
    cut.doubt = doubt_about(cut, still, signal.rate);
    return cut;
}

} // namespace stltsa::recording
