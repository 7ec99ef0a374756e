// SPDX-License-Identifier: BSD-3-Clause
// The exact nearest rows of every row of a matrix among all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "linalg/matrix.hpp"
#include "linalg/pack.hpp"
#include "ltsa/search/nearest_rows.hpp"

namespace stltsa::ltsa {

/// The query, and the function that takes its answers.
struct NearestOfAll {
    std::int64_t count;                                ///< of each row
    std::function<RowRange(std::int64_t row)> zone_of; ///< rows that are not candidates
    /// Takes the nearest of a row: nearest first, ties by row. Called on any thread, once a row.
    std::function<void(std::int64_t row, std::vector<Candidate> found)> store;
    int threads;
    Simd simd;
};

/// `poll` gets the share that is done.
void find_nearest_of_all(ConstMatrixView x, const NearestOfAll& wanted,
                         const std::function<void(double share)>& poll);

} // namespace stltsa::ltsa
