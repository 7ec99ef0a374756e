// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/parts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "motion/curve/statistics.hpp"
#include "motion/cycles/closed_clip.hpp"

namespace stltsa::motion {
namespace {

/// A stretch of less than so many periods of a longer one beside it, and of a shorter period than
/// this share of it, is a part of it, such as one of several turns within it. If longer ones are no
/// cycles, lags below this share of them are searched.
constexpr double min_periods_beside = 1.3;
constexpr double shorter_period = 0.8;
/// No behavior changes nearer to a hole than this, because the features of a border cover this much
/// on each side. With holes of 1 s in walks (measure/gaps), 0.4 cycles fewer are lost than the hole
/// touches; without separate parts, 1.0 more.
constexpr double beside_hole_s = 1;
/// The same beside a rest.
constexpr double beside_rest_s = 0.5;

/// Rows around the stretch that no other one has taken; empty if one has taken all of it.
Rows free_rows(Rows part, const Stretch& stretch, const std::vector<CyclicStretch>& taken) {
    Rows free = part;
    for (const CyclicStretch& cut : taken) {
        const Run& run = cut.growth.run;
        Rows used{run.begin, run.end()};
        if (cut.claimed()) // borders may lie beyond the rows of the phase
            used = {
                std::min(used.begin, static_cast<std::int64_t>(std::floor(cut.borders.front()))),
                std::max(used.end, static_cast<std::int64_t>(std::ceil(cut.borders.back())))};
        if (run.begin + run.end() < stretch.rows.begin + stretch.rows.end)
            free.begin = std::max(free.begin, used.end);
        else
            free.end = std::min(free.end, used.begin);
    }
    return free;
}

/// The rows of the stretch within the range.
Stretch within(Stretch stretch, Rows range) {
    const Rows rows{std::max(range.begin, stretch.rows.begin),
                    std::min(range.end, stretch.rows.end)};
    if (rows.count() < 1)
        return {};
    const auto first = stretch.period.begin() + (rows.begin - stretch.rows.begin);
    return {rows, {first, first + rows.count()}, stretch.quality, stretch.other_period};
}

/// Refuses loops within a longer period beside them.
void refuse_nested(double rate, std::vector<CyclicStretch>& cuts) {
    for (CyclicStretch& cut : cuts)
        for (const CyclicStretch& other : cuts) {
            const double period = cut.growth.mean.period, longer = other.growth.mean.period;
            const auto apart =
                static_cast<double>(std::max(cut.growth.run.begin - other.growth.run.end(),
                                             other.growth.run.begin - cut.growth.run.end()));
            if (cut.claimed() && other.growth.turns() >= min_periods_beside &&
                period < shorter_period * longer && apart < longer / 2 &&
                static_cast<double>(cut.growth.run.rows()) < min_periods_beside * longer)
                cut.doubt = format_text("part of a longer cycle: {:.2f} s within {:.2f} s",
                                        period / rate, longer / rate);
        }
}

/// Gives cycles of neighbors that were moved over each other one border between them.
void part_neighbors(std::vector<CyclicStretch>& cuts) {
    CyclicStretch* before = nullptr;
    for (CyclicStretch& cut : cuts) {
        if (!cut.claimed())
            continue;
        if (before != nullptr && before->borders.back() > cut.borders.front()) {
            const double middle = (before->borders.back() + cut.borders.front()) / 2;
            if (middle <= before->borders[before->borders.size() - 2] || middle >= cut.borders[1]) {
                cut.doubt = "it overlaps the cycles before";
                continue;
            }
            before->borders.back() = cut.borders.front() = middle;
        }
        before = &cut;
    }
}

/// The shortest usual lag of the stretches in seconds, infinite without any.
double shortest_lag(const std::vector<CyclicStretch>& cuts, double rate) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const CyclicStretch& cut : cuts)
        shortest = std::min(shortest, median(cut.stretch.period) / rate);
    return shortest;
}

bool pauses_within(const StillRows& still, Rows rows) {
    return std::ranges::any_of(still.pauses, [&](const Rows& pause) {
        return pause.begin < rows.end && pause.end > rows.begin;
    });
}

/// The cycles of the part: the longest stretches first, as far as they grow. What is left of a
/// stretch is one as well. If none has cycles, shorter lags are tried: a walk that turns twice
/// resembles itself most after both turns. What pauses may be repetitions instead.
Part decide(const Signal& signal, Rows rows, const StillRows& still, const PeriodRange& periods) {
    report_row(signal, static_cast<double>(rows.begin));
    Part part;
    part.rows = rows;
    PeriodTrack track = track_period(signal, rows, periods);
    part.best_match = track.best_match;
    part.best_lag_s = track.best_lag_s;
    const auto weight = [](const Stretch& stretch) {
        return static_cast<double>(stretch.rows.count()) * stretch.quality;
    };
    std::ranges::stable_sort(track.stretches, {}, weight);
    std::vector<CyclicStretch> small; // they may be parts of others, and take no rows from them
    while (!track.stretches.empty()) {
        const Stretch next = std::move(track.stretches.back());
        track.stretches.pop_back();
        const Rows free = free_rows(rows, next, part.stretches);
        const Stretch stretch = within(next, free);
        if (stretch.rows.count() < 2)
            continue;
        CyclicStretch cut = cut_stretch(signal, stretch, rows, free, still);
        const Run& run = cut.growth.run;
        for (const Rows left :
             {Rows{stretch.rows.begin, run.begin}, Rows{run.end(), stretch.rows.end}})
            if (run.rows() > 1 && left.count() < stretch.rows.count())
                if (Stretch rest = within(stretch, left); static_cast<double>(rest.rows.count()) >
                                                          min_periods_beside * median(rest.period))
                    track.stretches.insert(track.stretches.begin(), std::move(rest));
        (cut.borders.empty() ? small : part.stretches).push_back(std::move(cut));
    }
    refuse_nested(signal.rate, part.stretches);
    const double longest_s = shorter_period * std::min(shortest_lag(part.stretches, signal.rate),
                                                       shortest_lag(small, signal.rate));
    if (part.cycles().empty() && longest_s > periods.shortest_s && longest_s < periods.longest_s &&
        !pauses_within(still, rows)) {
        Part shorter = decide(signal, rows, still, {periods.shortest_s, longest_s});
        if (!shorter.cycles().empty())
            return shorter;
    }
    if (rows == Rows{0, signal.rows()} && part.cycles().empty())
        if (auto closed = closed_cycle(signal, periods)) {
            part.stretches = {*std::move(closed)};
            return part;
        }
    std::ranges::move(small, std::back_inserter(part.stretches));
    std::ranges::stable_sort(part.stretches, {},
                             [](const CyclicStretch& cut) { return cut.growth.run.begin; });
    part_neighbors(part.stretches);
    return part;
}

/// A border beside a rest lies at its nearest end: a motion that speeds up or slows down is not
/// another behavior.
std::int64_t moved_to_rest(const Signal& signal, const std::vector<Rows>& rests, std::int64_t row) {
    const auto reach = static_cast<std::int64_t>(beside_rest_s * signal.rate);
    std::int64_t nearest = row, least = reach + 1;
    for (auto rest = std::ranges::lower_bound(rests, row - reach, {}, &Rows::end);
         rest != rests.end() && rest->begin <= row + reach; ++rest)
        if (const std::int64_t at = std::clamp(row, rest->begin, rest->end);
            std::abs(at - row) < least) {
            nearest = at;
            least = std::abs(at - row);
        }
    return nearest;
}

/// The parts without their cycles. The rows between a hole and a border of behaviors next to it are
/// too few for a behavior of their own.
std::vector<Part> undecided(const Signal& signal, const Borders& borders, const StillRows& still) {
    std::vector<std::int64_t> rows{0};
    if (borders.features != nullptr)
        for (const std::int64_t row : behavior_borders(*borders.features, borders.more))
            rows.push_back(moved_to_rest(signal, still.rests, row));
    rows.push_back(signal.rows());
    const auto beside = static_cast<std::int64_t>(beside_hole_s * signal.rate);
    for (const Rows& hole : still.holes)
        std::erase_if(rows, [&](std::int64_t row) {
            return row > 0 && row < signal.rows() && row > hole.begin - beside &&
                   row < hole.end + beside;
        });
    for (const Rows& hole : still.holes)
        rows.insert(rows.end(), {hole.begin, hole.end});
    std::ranges::sort(rows);
    std::vector<Part> parts;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        if (rows[i] == rows[i + 1]) // a hole at an end
            continue;
        Part part;
        part.rows = {rows[i], rows[i + 1]};
        part.is_hole = std::ranges::find(still.holes, part.rows) != still.holes.end();
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Gain of the border between the parts, in units of the price of a border.
double gain_of(const KernelFeatures& features, Rows before, Rows after) {
    const std::int64_t step = features.step(), begin = after.begin / step;
    if (before.begin / step == begin) // less than a moment
        return 0;
    return features.gain(before.begin / step, begin,
                         std::max(begin + 1, std::min(after.end / step, features.count()))) /
           border_price(features);
}

} // namespace

std::vector<Interval> Part::cycles() const {
    std::vector<Interval> all;
    for (const CyclicStretch& cut : stretches)
        if (cut.claimed())
            std::ranges::copy(cut.cycles(), std::back_inserter(all));
    return all;
}

std::vector<Part> divide(const Signal& signal, const Borders& borders, const StillRows& still,
                         const PeriodRange& periods) {
    std::vector<Part> parts;
    for (const Part& part : undecided(signal, borders, still))
        parts.push_back(part.is_hole ? part : decide(signal, part.rows, still, periods));
    if (borders.features == nullptr)
        return parts;
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (!parts[i - 1].is_hole && !parts[i].is_hole)
            parts[i].gain = gain_of(*borders.features, parts[i - 1].rows, parts[i].rows);
    return parts;
}

} // namespace stltsa::motion
