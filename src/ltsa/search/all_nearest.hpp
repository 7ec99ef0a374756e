// SPDX-License-Identifier: BSD-3-Clause
// For every row of a matrix, the exact nearest rows among all rows.
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
    std::int64_t count;                                ///< nearest rows per row
    std::function<RowRange(std::int64_t row)> zone_of; ///< rows that are not candidates
    /// Takes the result for a row: nearest first, ties by row. Called once per row, on any thread.
    std::function<void(std::int64_t row, std::vector<Candidate> found)> store;
    int threads;
    Simd simd;
};

/// The work of stage "neighbors".
void find_nearest_of_all(ConstMatrixView x, const NearestOfAll& wanted);

} // namespace stltsa::ltsa
