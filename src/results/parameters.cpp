// SPDX-License-Identifier: BSD-3-Clause
#include "results/parameters.hpp"

#include <algorithm>

#include "motion/choose_neighbors.hpp"

namespace stltsa::results {
namespace {

motion::Period find_period(ConstMatrixView samples, const PeriodSearch& search, Source& source,
                           const Progress& progress) {
    const double fps = source.samples.fps;
    if (!(fps > 0))
        return {};
    const motion::Period found =
        motion::find_period(samples, fps, search.shortest, search.longest, progress);
    source.period = {found.samples / fps, found.quality, search.shortest, search.longest};
    return found;
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

ltsa::Parameters choose_parameters(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                                   const FitOptions& options, int standard_dimension,
                                   Source& source, const Progress& progress) {
    ltsa::Parameters p;
    p.dimension = options.dimension.value_or(standard_dimension);
    p.mode = options.mode;
    p.include_self = options.include_self;
    p.links = options.links;
    p.threads = options.threads;
    p.neighbors =
        options.neighbors
            ? *options.neighbors
            : motion::choose_neighbors(
                  find_period(samples, options.search, source, progress), source.samples.fps,
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
