// SPDX-License-Identifier: BSD-3-Clause
#include "motion/margins.hpp"

#include <algorithm>
#include <cmath>

#include "motion/curve/extrema.hpp"
#include "motion/curve/smoothing.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// The curve has an extremum where it then changes by this share of its height.
constexpr double prominence = 0.25;
/// Least ratio, either way, between the height of a swing and the median height of the swings of
/// cycles; swings that the start or the end of the clip cuts off are lower.
constexpr double like_swing = 0.6;
/// The same for swings that the start or the end of the clip cuts off. Behind its steepest point a
/// swing has half of its height left; noise takes some of that.
constexpr double like_cut_swing = 0.4;
/// The half swing out of standing has about half of the height, or more with noise.
constexpr double like_swing_beside_rest = 0.8;
/// Least steepness relative to swings in the same direction: first steps are slow.
constexpr double like_steepness = 0.7;
constexpr double like_cut_steepness = 0.5;
/// Length of a cycle in periods.
constexpr double shortest_cycle = 0.7;
constexpr double longest_cycle = 1.4;

/// Range from the 5th to the 95th percentile of the moving samples.
double height(std::span<const double> curve, const Activity& activity) {
    std::vector<double> moving;
    for (std::size_t i = 0; i < curve.size(); ++i)
        if (activity.moving(static_cast<std::int64_t>(i)))
            moving.push_back(curve[i]);
    return quantile(moving, 0.95) - quantile(moving, 0.05);
}

/// The candidate margin between a peak and a valley: the steepest point of the curve.
Margin between(const Extremum& before, const Extremum& after, std::span<const double> curve,
               std::span<const double> slopes, const Activity& activity) {
    const auto steep = [&](std::int64_t i) {
        return std::abs(slopes[static_cast<std::size_t>(i)]);
    };
    std::int64_t steepest = before.at;
    for (std::int64_t i = before.at; i <= after.at; ++i)
        if (steep(i) > steep(steepest))
            steepest = i;
    Margin margin;
    margin.at = static_cast<double>(steepest);
    margin.rising = !before.peak;
    margin.from_rest = !activity.moving(before.at);
    margin.to_rest = !activity.moving(after.at);
    margin.cut = (before.at == 0 && !margin.from_rest) ||
                 (after.at + 1 == activity.samples() && !margin.to_rest);
    // At the end of the clip: the true steepest point may lie beyond it.
    if (steepest < 2 || steepest + 2 >= activity.samples() || !activity.moving(steepest))
        return margin;
    margin.at += parabola_vertex(steep(steepest - 1), steep(steepest), steep(steepest + 1));
    margin.swing = std::abs(curve[static_cast<std::size_t>(after.at)] -
                            curve[static_cast<std::size_t>(before.at)]);
    margin.steepness = steep(steepest);
    return margin;
}

template <class Value, class Which>
double median_of(const std::vector<Margin>& margins, Value value, Which which) {
    std::vector<double> values;
    for (const Margin& margin : margins)
        if (which(margin))
            values.push_back(value(margin));
    return median(values);
}

/// Which margins belong to swings as high and as steep as the others.
std::vector<bool> similar(const std::vector<Margin>& margins) {
    const double swing = median_of(
        margins, [](const Margin& m) { return m.swing; },
        [](const Margin& m) { return m.swing > 0; });
    const auto like_others = [&](const Margin& m) {
        return m.swing > 0 && m.swing >= (m.cut ? like_cut_swing : like_swing) * swing &&
               swing >= like_swing * m.swing;
    };
    const auto steepness = [&](bool rising) {
        return median_of(
            margins, [](const Margin& m) { return m.steepness; },
            [&](const Margin& m) { return like_others(m) && m.rising == rising; });
    };
    const double falling_steepness = steepness(false);
    const double rising_steepness = steepness(true);
    std::vector<bool> result;
    for (const Margin& m : margins) {
        const double least = m.cut ? like_cut_steepness : like_steepness;
        const double usual = m.rising ? rising_steepness : falling_steepness;
        result.push_back(like_others(m) && m.steepness >= least * usual);
    }
    return result;
}

using Sequence = std::vector<Margin>;

/// Whether `next` may follow the sequence: about one period after the margin before the last.
bool continues(const Sequence& sequence, const Margin& next, double period) {
    if (sequence.empty())
        return true;
    if (sequence.size() == 1)
        return next.at - sequence.back().at <= longest_cycle * period;
    const double cycle = next.at - sequence[sequence.size() - 2].at;
    return cycle >= shortest_cycle * period && cycle <= longest_cycle * period;
}

void drop_half_swings(Sequence& sequence) {
    const double least =
        like_swing_beside_rest *
        median_of(
            sequence, [](const Margin& m) { return m.swing; }, [](const Margin&) { return true; });
    if (!sequence.empty() && sequence.front().from_rest && sequence.front().swing < least)
        sequence.erase(sequence.begin());
    if (!sequence.empty() && sequence.back().to_rest && sequence.back().swing < least)
        sequence.pop_back();
}

} // namespace

std::vector<Margin> find_margins(std::span<const double> curve, const Activity& activity) {
    const auto extrema = alternating_extrema(curve, prominence * height(curve, activity));
    const std::vector<double> slopes = slope(curve);
    std::vector<Margin> margins;
    for (std::size_t e = 0; e + 1 < extrema.size(); ++e)
        margins.push_back(between(extrema[e], extrema[e + 1], curve, slopes, activity));
    return margins;
}

std::vector<double> longest_sequence(const std::vector<Margin>& margins, double period) {
    const std::vector<bool> usable = similar(margins);
    Sequence longest;
    Sequence sequence;
    for (std::size_t i = 0; i < margins.size(); ++i) {
        if (!usable[i]) {
            sequence.clear();
            continue;
        }
        if (!continues(sequence, margins[i], period))
            sequence.erase(sequence.begin(), sequence.end() - 1);
        if (!continues(sequence, margins[i], period))
            sequence.clear();
        sequence.push_back(margins[i]);
        if (sequence.size() > longest.size())
            longest = sequence;
    }
    drop_half_swings(longest);
    std::vector<double> positions;
    for (const Margin& margin : longest)
        positions.push_back(margin.at);
    return positions;
}

} // namespace stltsa::motion
