// SPDX-License-Identifier: BSD-3-Clause
// Chooses the parameters that the caller leaves to the library.
#pragma once

#include <cstdint>
#include <span>

#include "base/progress.hpp"
#include "ltsa/mapping/mapping.hpp"
#include "ltsa/parameters.hpp"
#include "results/facts.hpp"

namespace stltsa::results {

/// The range of the search for the period, in seconds.
struct PeriodSearch {
    double shortest = 0.3;
    double longest = 6;
};

struct FitOptions {
    std::int64_t neighbors = 0; ///< 0: motion::choose_neighbors()
    std::int64_t window = 0;    ///< 0: as neighbors
    std::int64_t exclusion = 0; ///< 0: as window
    std::int64_t links = 4;
    int dimension = 0; ///< 0: the caller's `standard_dimension`
    ltsa::Mode mode = ltsa::Mode::temporal;
    bool include_self = true;
    PeriodSearch search; ///< for the choice of the neighbors
    int threads = 1;
};

/// Sets source.period if it searches for a period.
ltsa::Parameters choose_parameters(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                                   const FitOptions& options, int standard_dimension,
                                   Source& source, const Progress& progress);

/// `asked` with each 0 replaced: local maps of the dimension and 5 more rows, at least 10; hints
/// that reach a fifth of the neighbors.
ltsa::MapParameters choose_map_parameters(ltsa::MapParameters asked,
                                          const ltsa::Parameters& fitted);

} // namespace stltsa::results
