// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/stretch_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <tuple>

#include "linalg/principal.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/extrema.hpp"
#include "motion/curve/smoothing.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/cycles/border_alignment.hpp"
#include "motion/cycles/evidence.hpp"
#include "motion/cycles/sides.hpp"

namespace stltsa::motion {
namespace {

/// A cycle may lack so much of a turn: phases at the ends are not known better.
constexpr double turn_tolerance = 0.02;
/// From one strike of a foot to the next is a turn, give or take this share.
constexpr double strike_tolerance = 0.25;
/// So much of a cycle before it strikes, a foot swings forward.
constexpr double swing_before_strike = 0.2;
/// The mean cycle passes through a posture of rest, and is slow there, if its squared distance from
/// it, velocities included, is at most this share of its variance: 0.6 and more in walks, 0.15 in
/// punches, less than 0.1 in squats.
constexpr double same_posture = 0.3;
/// A motion begins at a rest if no more than this share of a cycle lies between, and in its posture
/// if the mean cycle is near it within this share of the phase there.
constexpr double near_rest = 0.5;
constexpr double near_phase = 0.25;
constexpr std::int64_t posture_phases = 96;
/// Time before and after a motion in which its posture of rest is read.
constexpr double posture_s = 0.3;
/// A stretch that is longer than this share of its part is the only one.
constexpr double most_of_part = 0.7;
/// Two stretches may be one motion if the ratio of their periods is at most this, and if their mean
/// cycles differ by less than so many standard deviations, or by less than so much of their mean
/// variance. Twice least_difference changes no result; without most_deviations, the recording 13_30
/// loses a behavior (measure/recordings).
constexpr double most_length_ratio = 1.2;
constexpr double most_deviations = 3;
constexpr double least_difference = 0.15;
/// Sigma of the smoothing of the coordinate as a share of a cycle.
constexpr double curve_smoothing = 0.06;
/// Least height of a swing of the coordinate between its margins, as a share of its extent.
constexpr double prominence = 0.25;
/// The height of the curve is that of so many periods to each side.
constexpr std::int64_t height_periods = 8;

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
        const double height = quantile(around, 0.95) - quantile(around, 0.05);
        for (std::int64_t i = a; i < std::min(n, a + hop) && height > 0; ++i)
            result[static_cast<std::size_t>(i)] = curve[static_cast<std::size_t>(i)] / height;
    }
    return result;
}

/// Takes the rows at rest off both ends.
void trim(const std::vector<Rows>& rests, Growth& growth) {
    Run& run = growth.run;
    std::int64_t begin = run.begin, end = run.end();
    for (const Rows& rest : rests) {
        if (rest.begin <= begin && rest.end > begin)
            begin = std::min(rest.end, end);
        if (rest.end >= end && rest.begin < end)
            end = std::max(rest.begin, begin);
    }
    const auto keep = [&](std::vector<double>& values) {
        values = {values.begin() + (begin - run.begin), values.begin() + (end - run.begin)};
    };
    keep(growth.deviation);
    keep(run.phase);
    run.begin = begin;
}

/// The rows of a rest in which its posture is read by a motion before it, and by one after it.
Rows first_of(Rows rest, double rate) {
    return {rest.begin, std::min(rest.end, rest.begin + std::max<std::int64_t>(
                                                            1, std::lround(posture_s * rate)))};
}
Rows last_of(Rows rest, double rate) {
    return {
        std::max(rest.begin, rest.end - std::max<std::int64_t>(1, std::lround(posture_s * rate))),
        rest.end};
}

/// The rests beside the motion, which touch the rows it may have. One whose posture was not
/// recorded is a hole, at which the motion is cut off.
struct Beside {
    std::optional<Rows> before, after;
};

Beside rests_beside(const StillRows& still, const Growth& growth, Rows within, double rate) {
    const auto is_recorded = [&](Rows rows) {
        return std::ranges::none_of(still.holes, [rows](const Rows& hole) {
            return hole.begin < rows.end && rows.begin < hole.end;
        });
    };
    const auto reach = static_cast<std::int64_t>(near_rest * growth.mean.period);
    const std::int64_t begin = growth.run.begin, end = growth.run.end();
    Beside beside;
    for (const Rows& rest : still.rests) {
        if (rest.begin < begin && rest.end >= std::max(begin - reach, within.begin) &&
            is_recorded(last_of(rest, rate)))
            beside.before = rest;
        if (rest.end > end && rest.begin <= std::min(end + reach, within.end) && !beside.after &&
            is_recorded(first_of(rest, rate)))
            beside.after = rest;
    }
    return beside;
}

/// A posture of rest through which the mean cycle passes.
struct Home {
    double phase = 0; ///< at which the mean cycle is in that posture
    /// Row and phase at which the motion leaves it, and at which it is back.
    std::optional<std::pair<double, double>> from, to;
};

/// Squared distances of the mean cycle from standing in the mean pose of the rows, at equal phases.
std::vector<double> distances_from(const Signal& signal, const Loop& loop, Rows rows) {
    std::vector<double> standing =
        column_means(signal.poses.view().block(rows.begin, rows.count()));
    standing.resize(static_cast<std::size_t>(loop.cols())); // velocities are 0
    const Matrix cycle = loop.sampled(posture_phases);
    std::vector<double> distances;
    for (std::int64_t p = 0; p < posture_phases; ++p)
        distances.push_back(squared_distance(cycle.row(p), standing.data(), loop.cols()));
    return distances;
}

/// Difference of two phases, from -1/2 to 1/2.
double turned(double from, double to) {
    return to - from - std::round(to - from);
}

std::optional<Home> home_of(const Signal& signal, const Beside& beside, const Growth& growth) {
    const Run& run = growth.run;
    std::optional<Home> home;
    const auto meet = [&](Rows rows, std::int64_t row, auto end) {
        const double phase =
            row <= run.begin
                ? run.phase.front() - static_cast<double>(run.begin - row) / growth.mean.period
                : run.phase.back() + static_cast<double>(row - run.end()) / growth.mean.period;
        const std::vector<double> distances = distances_from(signal, growth.mean.loop, rows);
        double least = same_posture * growth.mean.loop.variance();
        std::optional<double> at;
        for (std::size_t p = 0; p < distances.size(); ++p) {
            const double there = static_cast<double>(p) / posture_phases;
            if (distances[p] <= least && std::abs(turned(phase, there)) <= near_phase) {
                least = distances[p];
                at = there;
            }
        }
        if (!at)
            return;
        if (!home)
            home = Home{*at, {}, {}};
        (*home).*end = {static_cast<double>(row), phase};
    };
    if (beside.before)
        meet(last_of(*beside.before, signal.rate), beside.before->end, &Home::from);
    if (beside.after)
        meet(first_of(*beside.after, signal.rate), beside.after->begin, &Home::to);
    return home;
}

/// Cycles from the posture of rest to itself. The first leaves it with the rest, whatever the phase
/// there, and the last ends with the next rest.
std::vector<double> borders_from_home(const Growth& growth, const Home& home) {
    const Run& run = growth.run;
    const double begin = home.from ? std::round(home.from->second - home.phase)
                                   : std::ceil(run.phase.front() - home.phase);
    const double end = home.to ? std::round(home.to->second - home.phase)
                               : std::floor(run.phase.back() - home.phase);
    std::vector<double> borders;
    for (double turn = begin; turn <= end; ++turn)
        borders.push_back(turn == begin && home.from ? home.from->first
                          : turn == end && home.to   ? home.to->first
                                                     : growth.row_of(home.phase + turn));
    return std::ranges::is_sorted(borders) ? borders : std::vector<double>();
}

/// Phases at which the coordinate, averaged over the cycles, is steepest between its peaks and
/// valleys: the margins of the paper.
std::vector<double> margins_of(const PhaseCurve& curve) {
    constexpr auto period = static_cast<std::size_t>(samples_per_period);
    std::vector<double> mean(period), counts(period);
    const auto phase_of = [&](std::size_t i) { return i % period; };
    for (std::size_t i = 0; i < curve.curve.size(); ++i) {
        mean[phase_of(i)] += curve.curve[i];
        counts[phase_of(i)] += 1;
    }
    std::vector<double> thrice; // so that extrema and slopes at the seam are whole
    for (std::size_t i = 0; i < 3 * period; ++i)
        thrice.push_back(mean[phase_of(i)] / std::max(1.0, counts[phase_of(i)]));
    const auto [low, high] = std::ranges::minmax(thrice);
    const auto extrema = alternating_extrema(thrice, prominence * (high - low));
    const std::vector<double> slopes = slope(thrice);
    const auto steep = [&](std::int64_t i) {
        return std::abs(slopes[static_cast<std::size_t>(i)]);
    };
    std::vector<double> margins;
    for (std::size_t e = 0; e + 1 < extrema.size(); ++e) {
        std::int64_t at = extrema[e].at;
        for (std::int64_t i = at; i <= extrema[e + 1].at; ++i)
            if (steep(i) > steep(at))
                at = i;
        if (at < samples_per_period || at >= 2 * samples_per_period)
            continue;
        const double offset = parabola_vertex(steep(at - 1), steep(at), steep(at + 1));
        margins.push_back((static_cast<double>(at - samples_per_period) + offset) /
                          samples_per_period);
    }
    return margins;
}

/// How much a margin is preferred over the others of its cycle: where one side of the body comes
/// forward; or, if the sides are unknown, where the columns rise. The coordinate itself has no
/// sign.
double preference_for(const Signal& signal, const Growth& growth, double margin) {
    const auto rows = [&](const auto& visit) {
        const double first = margin + std::ceil(growth.run.phase.front() - margin);
        for (double at = first; at <= growth.run.phase.back(); ++at)
            visit(growth.row_of(at));
    };
    double sum = 0, count = 0;
    if (!signal.side.empty()) {
        rows([&](double row) {
            double value = 0;
            row_at({signal.side.data(), signal.rows(), 1, 1}, row, &value);
            sum -= value;
            ++count;
        });
        return count > 0 ? sum / count : 0;
    }
    std::vector<double> velocity(static_cast<std::size_t>(signal.cols())), mean = velocity;
    rows([&](double row) {
        row_at(signal.velocity.view(), row, velocity.data());
        axpy(1, velocity.data(), mean.data(), signal.cols());
    });
    for (std::int64_t c = 0; c < signal.directions.rows(); ++c) {
        const double rise = dot(mean.data(), signal.directions.row(c), signal.cols());
        const double weight = 1 + fixed_weight(static_cast<std::size_t>(c));
        sum += weight * rise * std::abs(rise);
        count += weight * rise * rise;
    }
    return count > 0 ? sum / count : 0;
}

/// Cycles from one margin to the next of its kind. A motion that is cut off at both ends has as
/// many as it has whole turns: they begin as near to the preferred margin as this allows. Otherwise
/// there are the first and the last steps beside them (initial and final unit).
std::vector<double> borders_at_margins(const Signal& signal, const Growth& growth,
                                       const PhaseCurve& curve, bool cut_off) {
    const double first = growth.run.phase.front(), turns = growth.turns();
    const auto after_of = [&](double phase) { return phase - first - std::floor(phase - first); };
    const auto count_of = [&](double after) { return std::floor(turns - after + turn_tolerance); };
    double after = 0;
    std::pair most{-std::numeric_limits<double>::infinity(), 0.0};
    for (const double margin : margins_of(curve)) {
        const double phase = margin + curve.first_phase;
        // Either half of a cycle may come first: rather that of more cycles.
        const double counts = cut_off || signal.begin_with_side ? 0 : count_of(after_of(phase));
        if (const std::pair value{counts, preference_for(signal, growth, phase)}; value > most) {
            most = value;
            after = after_of(phase);
        }
    }
    double count = count_of(after);
    if (const double whole = std::floor(turns + turn_tolerance); cut_off && count < whole) {
        const double room = std::max(0.0, turns - whole);
        after = after - room < 1 - after ? room : 0;
        count = whole;
    }
    std::vector<double> borders;
    for (double turn = 0; turn <= count; ++turn)
        borders.push_back(growth.row_of(first + after + turn));
    return borders;
}

/// Takes unsure cycles off both ends; what is left is claimed if it is sure on the average.
std::string decide(const StillRows& still, double rate, CyclicStretch& cut) {
    std::vector<double>& sure = cut.confidences;
    const double seconds = cut.growth.mean.period / rate;
    if (sure.empty())
        return format_text("less than one cycle: the motion repeats after {:.2f} s, but holds none "
                           "from margin to margin",
                           seconds);
    std::size_t first = 0, last = sure.size();
    while (first < last && sure[first] < min_confidence)
        ++first;
    while (last > first && sure[last - 1] < min_confidence)
        --last;
    const double mean = mean_of(first < last ? std::span(sure).subspan(first, last - first) : sure);
    if (mean < min_confidence || first == last)
        return format_text("cycles unlike each other: the motion repeats after {:.2f} s (quality "
                           "{:.2f}), but the confidence of its {} is only {:.2f}",
                           seconds, cut.stretch.quality, sure.size() == 1 ? "cycle" : "cycles",
                           mean);
    cut.from_rest = cut.from_rest && first == 0;
    cut.to_rest = cut.to_rest && last == sure.size();
    cut.borders = {cut.borders.begin() + static_cast<std::ptrdiff_t>(first),
                   cut.borders.begin() + static_cast<std::ptrdiff_t>(last) + 1};
    sure = {sure.begin() + static_cast<std::ptrdiff_t>(first),
            sure.begin() + static_cast<std::ptrdiff_t>(last)};
    const auto held = std::ranges::count_if(still.pauses, [&](const Rows& pause) {
        const double middle = static_cast<double>(pause.begin + pause.end) / 2;
        return middle > cut.borders.front() && middle < cut.borders.back();
    });
    if (2 * held > static_cast<std::ptrdiff_t>(sure.size()) - 1)
        return format_text("a rest within each repetition: the motion repeats after {:.2f} s",
                           seconds);
    return {};
}

/// Lengths of cycles that may be of one motion.
bool near(double a, double b) {
    const auto [less, more] = std::minmax(a, b);
    return more <= most_length_ratio * less;
}

bool alike(const Growth& a, const Growth& b) {
    const Loop &first = a.mean.loop, &second = b.mean.loop;
    const double one = first.variance(), other = second.variance();
    const double apart =
        one + other - 2 * offset_between(first, second).likeness * std::sqrt(one * other);
    const double deviation = one * mean_of(a.deviation) + other * mean_of(b.deviation);
    return apart < most_deviations * most_deviations * deviation / 2 ||
           apart < least_difference * (one + other) / 2;
}

bool turns_apart(const Run& run, const std::vector<double>& borders) {
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        const double turns = run.phase_at(borders[i + 1]) - run.phase_at(borders[i]);
        if (std::abs(turns - 1) > strike_tolerance)
            return false;
    }
    return true;
}

/// The one row of `rows` in each cycle; empty if one has none, or several.
std::vector<double> one_in_each(const std::vector<Interval>& cycles,
                                const std::vector<double>& rows) {
    std::vector<double> found;
    for (const Interval& cycle : cycles) {
        const auto first = std::ranges::upper_bound(rows, cycle.begin);
        const auto last = std::ranges::lower_bound(rows, cycle.end);
        if (last - first != 1)
            return {};
        found.push_back(*first);
    }
    return found;
}

int striking_side(const Signal& signal, const CyclicStretch& cut) {
    std::vector<double> before;
    for (const double border : cut.borders)
        before.push_back(border - swing_before_strike * cut.growth.mean.period);
    return signal.side.empty() ? -1 : leading_side(signal.side, before);
}

} // namespace

std::vector<Interval> CyclicStretch::cycles() const {
    std::vector<Interval> all;
    for (std::size_t i = 0; i + 1 < borders.size(); ++i)
        all.push_back({borders[i], borders[i + 1]});
    return all;
}

double CyclicStretch::period() const {
    std::vector<double> lengths;
    for (const Interval& cycle : cycles())
        lengths.push_back(cycle.length());
    return median(lengths);
}

bool may_follow(const CyclicStretch& before, const CyclicStretch& after) {
    const std::vector<double>& last = before.borders;
    const std::vector<double>& first = after.borders;
    return near(last.back() - last[last.size() - 2], first[1] - first[0]) &&
           alike(before.growth, after.growth);
}

CyclicStretch cut_stretch(const Signal& signal, const Stretch& stretch, Rows part, Rows within,
                          const StillRows& still) {
    CyclicStretch cut;
    cut.stretch = stretch;
    cut.growth = grow(signal, stretch, within);
    Growth& growth = cut.growth;
    if (growth.run.rows() > 1)
        trim(still.rests, growth);
    if (const auto home =
            growth.run.rows() > 1
                ? home_of(signal, rests_beside(still, growth, within, signal.rate), growth)
                : std::nullopt) {
        cut.borders = borders_from_home(growth, *home);
        cut.from_rest = home->from.has_value();
        cut.to_rest = home->to.has_value();
    }
    if (cut.borders.size() < 3 && growth.turns() < min_turns) {
        cut.borders.clear();
        cut.doubt = format_text("a repetition after {:.2f} s lasts less than {} periods",
                                median(stretch.period) / signal.rate, min_turns);
        return cut;
    }
    cut.phase = trace_phase(signal, growth);
    if (cut.borders.size() < 2) {
        cut.from_rest = cut.to_rest = false;
        const Beside beside = rests_beside(still, growth, within, signal.rate);
        const bool cut_off = !beside.before && !beside.after &&
                             static_cast<double>(growth.run.rows()) >
                                 most_of_part * static_cast<double>(part.count());
        cut.borders =
            align_borders(signal, within, borders_at_margins(signal, growth, cut.phase, cut_off));
    }
    for (std::vector<double>* curve : {&cut.phase.curve, &cut.phase.partner})
        *curve = leveled(smooth(*curve, curve_smoothing * samples_per_period));
    cut.confidences = cycle_confidences(cut);
    cut.doubt = decide(still, signal.rate, cut);
    return cut;
}

bool begin_at_strikes(const Signal& signal, const Strikes& strikes, Interval within,
                      const StillRows& still, CyclicStretch& cut) {
    const Run& run = cut.growth.run;
    const double first = std::max(within.begin, static_cast<double>(run.begin));
    const double last = std::min(within.end, static_cast<double>(run.end()));
    auto state = std::tie(cut.borders, cut.confidences, cut.from_rest, cut.to_rest);
    const std::tuple before(cut.borders, cut.confidences, cut.from_rest, cut.to_rest);
    cut.borders.clear();
    std::ranges::copy_if(strikes.begins, std::back_inserter(cut.borders),
                         [&](double row) { return row >= first && row <= last; });
    cut.from_rest = cut.to_rest = false;
    cut.confidences = cycle_confidences(cut);
    cut.at_strikes = turns_apart(run, cut.borders) && decide(still, signal.rate, cut).empty();
    if (!cut.at_strikes) {
        state = before;
        return false;
    }
    cut.side = strikes.side >= 0 ? strikes.side : striking_side(signal, cut);
    cut.middles = one_in_each(cut.cycles(), strikes.middles);
    return true;
}

} // namespace stltsa::motion
