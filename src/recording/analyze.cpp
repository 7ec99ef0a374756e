// SPDX-License-Identifier: BSD-3-Clause
#include "recording/analyze.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "linalg/simd.hpp"
#include "ltsa/frames.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/decompose.hpp"
#include "recording/answer.hpp"
#include "recording/change_points.hpp"
#include "recording/holes.hpp"
#include "recording/merging.hpp"
#include "recording/repetitions.hpp"

namespace stltsa::recording {
namespace {

/// Clips up to this length are also taken as one motion, whose answer stands if it explains them.
constexpr double longest_single_s = 30;
/// Shorter recordings are not searched for changes of behavior.
constexpr double shortest_divided_s = 6;
/// Motion before or after the cycles that a single motion may have, in periods and seconds.
constexpr double most_initial_periods = 1.2;
constexpr double most_initial_s = 0.5;
/// Longer time before or after it at rest must be still for this share.
constexpr double least_still = 0.7;
/// A part without cycles is taken as one motion if it is at most so long.
constexpr double longest_part_s = 12;
/// Fewer samples are one motion.
constexpr std::int64_t least_rows = 12;
/// A closed clip: its last row is at most so far from where the first row goes on, as a share of a
/// step from row to row there and of the clip's extent; and it moves there at this share of its
/// usual speed.
constexpr double most_apart = 0.8;
constexpr double most_gap = 0.1;
constexpr double in_motion = 0.4;
/// If more segments are wanted, the price of a border falls by this factor, down to the least.
constexpr double cheaper = 0.5;
constexpr double least_price = 0.1;

/// Whether the body keeps still for most of the samples.
bool rests_within(const std::vector<Rows>& rests, double begin, double end, std::int64_t step) {
    double still = 0;
    for (const Rows& rest : rests)
        still += std::max(0.0, std::min(end, static_cast<double>(rest.end * step)) -
                                   std::max(begin, static_cast<double>(rest.begin * step)));
    return still >= least_still * (end - begin);
}

bool explains(const motion::Decomposition& single, const Signal& signal,
              const std::vector<Rows>& rests, const Pauses& pauses, double fps) {
    std::vector<Interval> cycles;
    for (const motion::Cycle& cycle : single.cycles)
        cycles.push_back({cycle.begin / static_cast<double>(signal.step),
                          cycle.end / static_cast<double>(signal.step)});
    if (cycles.empty() || paused(cycles, pauses.rests))
        return false;
    return std::ranges::none_of(single.units, [&](const motion::Unit& unit) {
        using enum motion::UnitKind;
        const bool beside = unit.kind == initial || unit.kind == final;
        const bool is_long =
            unit.end - unit.begin > most_initial_periods * single.period + most_initial_s * fps;
        if (beside || unit.kind == cyclic)
            return beside && is_long;
        return unit.kind == action ||
               (is_long && !rests_within(rests, unit.begin, unit.end, signal.step));
    });
}

/// The coordinate of samples from `first` on as a curve of rows, as high as traced ones, with the
/// same a quarter of a period earlier as its partner.
PhaseCurve curve_of(const motion::Decomposition& found, double first, double step) {
    PhaseCurve phase;
    phase.curve = found.curve;
    const double height = motion::quantile(phase.curve, 0.95) - motion::quantile(phase.curve, 0.05);
    for (std::size_t i = 0; i < phase.curve.size(); ++i) {
        phase.places.push_back((static_cast<double>(i) + first) / step);
        phase.curve[i] = height > 0 ? phase.curve[i] / height : 0;
    }
    phase.partner =
        earlier_curve(phase.curve, static_cast<std::size_t>(std::lround(found.period / 4)));
    return phase;
}

/// The claims of the method for one motion in a short part in which the track claims none.
void decide_as_single(ConstMatrixView samples, double fps, const Options& options,
                      const Signal& signal, const Pauses& pauses, const Progress& progress,
                      Part& part) {
    if (!part.cycles().empty() ||
        static_cast<double>(part.rows.count()) > longest_part_s * signal.rate)
        return;
    const std::int64_t first = part.rows.begin * signal.step;
    const std::int64_t last = std::min(samples.rows, part.rows.end * signal.step);
    if (last - first < 4)
        return;
    motion::DecomposeOptions of_part = options.single;
    of_part.estimate.reset();
    const auto found = motion::decompose(samples.block(first, last - first), fps, of_part,
                                         progress.within(Stage::units, 1));
    if (found.cycles.empty())
        return;
    CyclicStretch cut;
    const auto step = static_cast<double>(signal.step);
    cut.stretch.rows = part.rows;
    cut.stretch.quality = found.lag_quality;
    cut.stretch.period.assign(static_cast<std::size_t>(part.rows.count()), found.period / step);
    cut.cyclicity = found.cyclicity;
    cut.phase = curve_of(found, static_cast<double>(first), step);
    std::vector<double> margins;
    const auto row = [&](double sample) { return (sample + static_cast<double>(first)) / step; };
    for (const motion::Unit& unit : found.units)
        if (unit.kind == motion::UnitKind::cyclic) {
            margins = {row(unit.begin)};
            for (const motion::Cycle& cycle : found.cycles) {
                cut.cycles.push_back({row(cycle.begin), row(cycle.end)});
                margins.push_back((cut.cycles.back().begin + cut.cycles.back().end) / 2);
                margins.push_back(cut.cycles.back().end);
            }
        }
    if (paused(cut.cycles, pauses.rests))
        return;
    cut.margins = {margins};
    part.stretches = {std::move(cut)};
}

/// Whether options speak of the embedding of the whole clip.
bool wants_one_embedding(const motion::DecomposeOptions& options) {
    return options.neighbors || options.window || options.dimension ||
           options.mode != ltsa::Mode::temporal;
}

/// A clip that was cut to one cycle, to be played in a loop: it ends where it begins, in the same
/// motion, one row earlier. Nothing in it repeats, so that no lag shows it.
bool is_closed(const Signal& signal, const motion::DecomposeOptions& options) {
    const std::int64_t n = signal.rows();
    const double seconds = static_cast<double>(n) / signal.rate;
    if (n < least_rows || seconds < options.shortest_period || seconds > options.longest_period)
        return false;
    double extent = 0;
    for (std::int64_t i = 0; i < n; ++i)
        extent = std::max(
            extent, squared_distance(signal.poses.row(i), signal.poses.row(0), signal.cols()));
    const auto p = static_cast<std::size_t>(signal.cols());
    std::vector<double> step(p), gap(p); // from row to row beside the ends, and over them
    for (std::size_t c = 0; c < p; ++c) {
        const auto at = static_cast<std::int64_t>(c);
        step[c] = (signal.poses(2, at) - signal.poses(0, at) + signal.poses(n - 1, at) -
                   signal.poses(n - 3, at)) /
                  4;
        gap[c] = signal.poses(0, at) - signal.poses(n - 1, at);
    }
    // The last row may be the first one again, or the one before it.
    const double length = dot(step.data(), step.data(), signal.cols());
    const double along = dot(gap.data(), step.data(), signal.cols()) / length;
    axpy(-std::clamp(along, 0.0, 1.5), step.data(), gap.data(), signal.cols());
    const double apart = dot(gap.data(), gap.data(), signal.cols());
    const double usual = in_motion * signal.usual.front();
    return length > usual * usual && apart < most_apart * most_apart * length &&
           apart < most_gap * most_gap * extent;
}

/// The whole clip as one cycle.
motion::Decomposition one_cycle(motion::Decomposition single) {
    const auto end = static_cast<double>(single.curve.size());
    single.period = end;
    single.units = {{motion::UnitKind::cyclic, 0, end}};
    single.margins = {0, end / 2, end};
    single.cycles = {{0, end}};
    single.representative = single.best = 0;
    single.reason.clear();
    return single;
}

/// Cycles and repetitions.
std::size_t repeats_in(const std::vector<Draft>& drafts) {
    std::size_t count = 0;
    for (const Draft& draft : drafts)
        count +=
            draft.kind == SegmentKind::repetitions ? draft.motions.size() : draft.cycles().size();
    return count;
}

/// As many segments in motion as wanted: finer divisions, of which neighbors are merged.
void fit_number(const KernelFeatures& features, std::int64_t wanted,
                const std::function<std::vector<Draft>(double price)>& drafts_at,
                std::vector<Draft>& drafts) {
    std::int64_t most = moving(drafts);
    for (double price = border_price; most < wanted && price > least_price;) {
        price *= cheaper;
        std::vector<Draft> finer = drafts_at(price);
        if (const std::int64_t found = moving(finer); found > most) {
            most = found;
            drafts.swap(finer);
        }
    }
    if (most < wanted)
        fail(Status::argument,
             "option segments is {}, but only {} segments in motion could be told apart: ask for "
             "at most {}",
             wanted, most, most);
    merge_to(features, wanted, drafts);
}

/// The ranges of rows that holes touch, in ascending order and disjoint.
std::vector<Rows> rows_of(const std::vector<Hole>& holes, const Signal& signal) {
    std::vector<Rows> result;
    const auto step = static_cast<double>(signal.step);
    for (const Hole& hole : holes) {
        const auto begin = static_cast<std::int64_t>(std::floor(hole.begin / step));
        const auto end = static_cast<std::int64_t>(std::ceil(hole.end / step));
        if (begin >= signal.rows())
            continue;
        const Rows rows{begin, std::min(signal.rows(), std::max(begin + 1, end))};
        if (!result.empty() && rows.begin <= result.back().end)
            result.back().end = std::max(result.back().end, rows.end);
        else
            result.push_back(rows);
    }
    return result;
}

} // namespace

Recording analyze(ConstMatrixView samples, double fps, const Options& options,
                  const Progress& progress) {
    ltsa::check_frames(samples, {&samples.rows, 1});
    if (const int power = ltsa::power_if_tiny(samples); power != 0) {
        Options of_scaled = options;
        of_scaled.size = std::scalbn(options.size, power);
        return analyze(ltsa::scaled(samples, power).view(), fps, of_scaled, progress);
    }
    const double seconds = static_cast<double>(samples.rows) / fps;
    const bool whole = wants_one_embedding(options.single);
    const bool is_short = seconds <= longest_single_s;
    const Signal signal = make_signal(samples, fps, options.smoothed_s, options.size, progress);
    const std::vector<Rows> holes = rows_of(options.holes, signal);
    std::vector<Rows> rests = find_rests(signal);
    Pauses pauses = find_pauses(signal, rests);
    add_holes(holes, rests, pauses);
    motion::Decomposition single;
    if (whole || is_short || options.single.estimate) {
        single = motion::decompose(samples, fps, options.single, progress);
        const bool one = !options.segments && holes.empty();
        if (whole || (one && explains(single, signal, rests, pauses, fps)) ||
            samples.rows < least_rows)
            return answer_of(signal, std::move(single), samples, options, progress);
        if (one && single.cycles.empty() && is_closed(signal, options.single))
            return answer_of(signal, one_cycle(std::move(single)), samples, options, progress);
    }
    const auto poll_at = [&](double fraction) {
        return [&progress, fraction] { progress.report(Stage::units, fraction); };
    };
    const KernelFeatures features(signal, poll_at(0));
    const auto drafts_at = [&](double price) {
        std::vector<Part> parts =
            divide(signal, {seconds > shortest_divided_s ? &features : nullptr, price, holes},
                   {rests, pauses.rests},
                   {options.single.shortest_period, options.single.longest_period}, progress);
        for (Part& part : parts)
            // A single part was decided above.
            if (seconds <= long_recording_s && !part.is_hole && !(is_short && parts.size() == 1))
                decide_as_single(samples, fps, options, signal, pauses, progress, part);
        return make_drafts(signal, parts, pauses, poll_at(1));
    };
    std::vector<Draft> drafts = drafts_at(border_price);
    if (options.segments)
        fit_number(features, *options.segments, drafts_at, drafts);
    else if (is_short && holes.empty() && repeats_in(drafts) < single.cycles.size())
        return answer_of(signal, std::move(single), samples, options, progress);
    set_labels(signal, features, drafts, poll_at(1));
    if (!options.segments)
        join_neighbors(drafts);
    divide_at_holes(holes, signal.rate, drafts);
    return answer_of({signal, features, pauses}, std::move(drafts), std::move(single), samples,
                     options, progress);
}

} // namespace stltsa::recording
