// SPDX-License-Identifier: BSD-3-Clause
#include "phase/searched.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/gaussian.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::phase {
namespace {

/// Distances below this say nothing of the error: motion without noise has 0.01, recorded 0.2.
constexpr double least_usual = 0.1;
/// Neighboring marks of one place lie closer, as a share of a cycle: foot strikes that a person
/// annotated scatter by 0.02 (standard deviation), left and right ones lie 0.5 apart.
constexpr double one_place = 0.1;
/// Marks that cover more have no place.
constexpr double most_spread = 0.3;

/// Sorts by phase; on the circle, from the widest gap on, which is within no place.
void sort_by_phase(bool cyclic, std::vector<Mark>& marks) {
    if (cyclic)
        for (Mark& mark : marks)
            mark.phase -= std::floor(mark.phase);
    std::ranges::sort(marks, {}, &Mark::phase);
    if (!cyclic)
        return;
    std::size_t first = 0;
    double widest = marks.front().phase + 1 - marks.back().phase;
    for (std::size_t i = 1; i < marks.size(); ++i)
        if (const double gap = marks[i].phase - marks[i - 1].phase; gap > widest) {
            widest = gap;
            first = i;
        }
    for (std::size_t i = 0; i < first; ++i)
        ++marks[i].phase;
    std::rotate(marks.begin(), marks.begin() + static_cast<std::ptrdiff_t>(first), marks.end());
}

void check_spread(const Place& place) {
    const double spread = place.back().phase - place.front().phase;
    if (spread > most_spread)
        fail(Status::argument,
             "{} marks are spread over {:.2f} of a cycle without a gap, so they mark no place in "
             "it: give each place a name of its own",
             place.size(), spread);
}

} // namespace

Searched searched(ConstMatrixView rows, ConstMatrixView both, double rate, const Phases& phases,
                  std::vector<Run> runs) {
    const double period = phases.mean.period;
    Searched made{
        phases.mean, std::move(runs), {}, {}, 0, rate, phases.cyclic, FineRows(rows, rate, period)};
    std::vector<double> within;
    for (std::size_t r = 0; r < phases.runs.size(); ++r) {
        made.known.push_back({phases.runs[r].begin, phases.runs[r].end()});
        std::ranges::copy(phases.distances[r], std::back_inserter(within));
    }
    made.usual_distance = motion::median(within);
    for (const Run& run : made.runs) {
        std::vector<double> distance = residuals(both, made.mean, run);
        const Matrix smooth =
            gaussian_smoothed({distance.data(), run.rows(), 1, 1}, period / 20, Beyond::nothing, 1);
        made.distance.emplace_back(smooth.data(), smooth.data() + run.rows());
    }
    return made;
}

double interpolated(const std::vector<double>& values, double place) {
    const double at = std::clamp(place, 0.0, static_cast<double>(values.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(at), values.size() - 1);
    const auto next = std::min(i + 1, values.size() - 1);
    return values[i] + (at - static_cast<double>(i)) * (values[next] - values[i]);
}

double remoteness(const Searched& in, double distance) {
    return std::max(1.0, distance / std::max(in.usual_distance, least_usual));
}

double rows_beyond(Range range, double row) {
    return std::max(
        {0.0, static_cast<double>(range.begin) - row, row - static_cast<double>(range.end - 1)});
}

std::optional<Mark> mark_at(const Searched& in, double row) {
    for (std::size_t r = 0; r < in.runs.size(); ++r) {
        const Run& run = in.runs[r];
        const double place = row - static_cast<double>(run.begin);
        if (place < 0 || row > static_cast<double>(run.end() - 1))
            continue;
        return Mark{row, run.phase_at(row), interpolated(in.distance[r], place),
                    rows_beyond(in.known[r], row)};
    }
    return std::nullopt;
}

std::vector<Place> places_of(const Searched& in, std::vector<Mark> marks) {
    if (marks.empty())
        return {};
    sort_by_phase(in.cyclic, marks);
    std::vector<Place> places{{marks.front()}};
    for (std::size_t i = 1; i < marks.size(); ++i) {
        if (marks[i].phase - marks[i - 1].phase > one_place)
            places.emplace_back();
        places.back().push_back(marks[i]);
    }
    std::ranges::for_each(places, check_spread);
    return places;
}

} // namespace stltsa::phase
