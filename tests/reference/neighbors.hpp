// SPDX-License-Identifier: BSD-3-Clause
// Frames and their neighbors, found by plain sorting: the reference shares no code with the
// library.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "table.hpp"

namespace reference {

using Frames = Table<double>;         ///< frames x features
using Neighbors = Table<std::size_t>; ///< row i: the k neighbors of frame i, ascending

inline double squared_distance(const Frames& x, std::size_t i, std::size_t j) {
    double sum = 0;
    for (std::size_t c = 0; c < x.cols; ++c)
        sum += (x(i, c) - x(j, c)) * (x(i, c) - x(j, c));
    return sum;
}

/// The k nearest to frame i among begin .. end - 1, including itself; ties go to the lower index.
inline void nearest(const Frames& x, std::size_t i, std::size_t begin, std::size_t end,
                    Neighbors& result) {
    std::vector<std::pair<double, std::size_t>> candidates;
    for (std::size_t j = begin; j < end; ++j)
        candidates.emplace_back(squared_distance(x, i, j), j);
    std::sort(candidates.begin(), candidates.end());
    for (std::size_t j = 0; j < result.cols; ++j)
        result(i, j) = candidates.at(j).second;
    std::sort(result.row(i), result.row(i) + result.cols);
}

/// Neighbors among the existing frames of i-w .. i+w (Li, Niu, Zhang, Hu 2012, section 2.1).
inline Neighbors temporal_neighbors(const Frames& x, std::size_t k, std::size_t w) {
    Neighbors result(x.rows, k);
    for (std::size_t i = 0; i < x.rows; ++i)
        nearest(x, i, i - std::min(i, w), std::min(x.rows, i + w + 1), result);
    return result;
}

/// Neighbors among all frames: classical LTSA.
inline Neighbors spatial_neighbors(const Frames& x, std::size_t k) {
    Neighbors result(x.rows, k);
    for (std::size_t i = 0; i < x.rows; ++i)
        nearest(x, i, 0, x.rows, result);
    return result;
}

} // namespace reference
