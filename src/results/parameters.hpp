// SPDX-License-Identifier: BSD-3-Clause
// Chooses the parameters that the caller leaves to the library.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "ltsa/mapping/mapping.hpp"
#include "ltsa/parameters.hpp"
#include "results/facts.hpp"

namespace stltsa::results {

/// The range of the search for the period, in the unit of results::PeriodFacts.
struct PeriodRange {
    double shortest = 0;
    double longest = 0;
};

/// What the caller says of that range.
struct PeriodSearch {
    std::optional<double> shortest; ///< empty: 0.3 s, or 4 frames; at most the longest
    std::optional<double> longest;  ///< empty: 6 s, or half of the frames up to 1000; at least the
                                    ///< shortest
};

/// The range for this rate and number of frames that follow one another. Throws Status::argument if
/// it is empty.
PeriodRange range_of(const PeriodSearch& search, double fps, std::int64_t frames);

/// The period in that range, with the facts to keep of it.
PeriodFacts look_for_period(ConstMatrixView samples, double fps, const PeriodRange& range);

struct FitOptions {
    std::optional<std::int64_t> neighbors; ///< empty: motion::choose_neighbors()
    std::optional<std::int64_t> window;    ///< empty: as neighbors
    std::optional<std::int64_t> exclusion; ///< empty: as window
    std::int64_t links = 4;
    std::optional<int> dimension; ///< empty: the caller's `standard_dimension`
    ltsa::Mode mode = ltsa::Mode::temporal;
    bool include_self = true;
    PeriodSearch search; ///< for the choice of the neighbors
    int threads = 1;
};

/// Sets source.period if it searches for a period.
ltsa::Parameters choose_parameters(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                                   const FitOptions& options, int standard_dimension,
                                   Source& source);

struct MapRequest {
    std::optional<std::int64_t> neighbors; ///< empty: the dimension and 5 more, at least 10
    std::int64_t blend = 3;
    std::optional<std::int64_t> hint_window; ///< empty: a fifth of the neighbors of the fit
};
ltsa::MapParameters choose_map_parameters(const MapRequest& asked, const ltsa::Parameters& fitted);

} // namespace stltsa::results
