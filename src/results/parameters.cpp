// SPDX-License-Identifier: BSD-3-Clause
#include "results/parameters.hpp"

#include <algorithm>

#include "motion/period/choose_neighbors.hpp"

namespace stltsa::results {
namespace {

constexpr motion::PeriodRange usual;

/// In frames, if the rate is unknown. Fewer than 4 frames show no course of a cycle; the cost grows
/// with the longest lag.
constexpr double shortest_frames = 4;
constexpr std::int64_t longest_frames = 1000;
/// The search smooths and thins out at a rate: with this one it keeps every frame.
constexpr double frames_a_second = 30;
/// So many frames hold the longest period 20 times: of a longer recording the middle is searched.
constexpr std::int64_t most_frames = 20 * longest_frames;

PeriodFacts look_in_frames(ConstMatrixView samples, const PeriodRange& range) {
    const std::int64_t rows = std::min(samples.rows, most_frames);
    const motion::Period found =
        motion::find_period(samples.block((samples.rows - rows) / 2, rows), frames_a_second,
                            {range.shortest / frames_a_second, range.longest / frames_a_second});
    return {found.samples, found.quality, range.shortest, range.longest};
}

/// Neighbors come from the same run, so the shortest limits their number.
std::int64_t distinct_in_reach(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                               ltsa::Mode mode) {
    if (mode == ltsa::Mode::spatial)
        return motion::distinct_frames(samples);
    std::int64_t least = samples.rows;
    std::int64_t first = 0;
    for (const std::int64_t length : lengths) {
        least = std::min(least, motion::distinct_frames(samples.block(first, length)));
        first += length;
    }
    return least;
}

} // namespace

PeriodRange range_of(const PeriodSearch& search, double fps, std::int64_t frames) {
    const bool known = fps > 0;
    const auto half = static_cast<double>(std::min(frames / 2, longest_frames));
    const double shortest = known ? usual.shortest_s : shortest_frames;
    const double longest = known ? usual.longest_s : std::max(half, shortest_frames);
    // A default yields to the other end of the range that the caller gave.
    const PeriodRange range = {
        search.shortest.value_or(std::min(shortest, search.longest.value_or(shortest))),
        search.longest.value_or(std::max(longest, search.shortest.value_or(longest)))};
    if (range.shortest > range.longest)
        fail(Status::argument, "option period_min is {}{}, longer than option period_max, {}{}",
             range.shortest, known ? " s" : " frames", range.longest, known ? " s" : " frames");
    return range;
}

PeriodFacts look_for_period(ConstMatrixView samples, double fps, const PeriodRange& range) {
    if (!(fps > 0))
        return look_in_frames(samples, range);
    const motion::Period found = motion::find_period(samples, fps, {range.shortest, range.longest});
    return {found.samples / fps, found.quality, range.shortest, range.longest};
}

ltsa::Parameters choose_parameters(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                                   const FitOptions& options, int standard_dimension,
                                   Source& source) {
    ltsa::Parameters p;
    p.dimension = options.dimension.value_or(standard_dimension);
    p.mode = options.mode;
    p.include_self = options.include_self;
    p.links = options.links;
    p.threads = options.threads;
    const double fps = source.samples.fps;
    const bool has_time = fps > 0 || p.mode != ltsa::Mode::spatial;
    if (!options.neighbors && has_time)
        source.period =
            look_for_period(samples, fps, range_of(options.search, fps, std::ranges::max(lengths)));
    p.neighbors =
        options.neighbors
            ? *options.neighbors
            : motion::choose_neighbors(
                  {rows_of_period(source.period, source.samples), source.period.lag_quality}, fps,
                  {distinct_in_reach(samples, lengths, p.mode), p.dimension, p.dimension});
    p.window = options.window.value_or(p.neighbors);
    p.exclusion = options.exclusion.value_or(p.window);
    return p;
}

ltsa::MapParameters choose_map_parameters(const MapRequest& asked, const ltsa::Parameters& fitted) {
    return {asked.neighbors.value_or(std::max<std::int64_t>(fitted.dimension + 5, 10)), asked.blend,
            asked.hint_window.value_or(std::max<std::int64_t>(fitted.neighbors / 5, 1))};
}

} // namespace stltsa::results
