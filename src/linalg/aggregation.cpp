// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/aggregation.hpp"

#include <cmath>
#include <numeric>
#include <vector>

namespace stltsa {

Aggregation::Entries Aggregation::entries_of(std::int64_t length) {
    const auto n = static_cast<double>(length);
    const double squares = n * (n * n - 1) / 12; // sum of (i - middle)^2
    return {1 / std::sqrt(n), length > 1 ? 1 / std::sqrt(squares) : 0, (n - 1) / 2};
}

void Aggregation::spread(ConstMatrixView coarse, MatrixView panel, const Machine& machine) const {
    const bool sloped = terms() > 1;
    for_blocks(machine, [&](std::int64_t, std::int64_t first, std::int64_t end) {
        for (std::int64_t run = first; run < end; ++run) {
            const Entries& q = entries(run);
            const double* mean = coarse.row(run * terms());
            const double* slope = sloped ? coarse.row(run * terms() + 1) : mean; // times 0
            for (std::int64_t i = begin(run); i < begin(run + 1); ++i) {
                const double at = q.slope * (static_cast<double>(i - begin(run)) - q.middle);
                for (std::int64_t c = 0; c < panel.cols; ++c)
                    panel(i, c) = q.mean * mean[c] + at * slope[c];
            }
        }
    });
}

double Aggregation::variation_within(ConstMatrixView panel, std::int64_t column,
                                     const Machine& machine) const {
    std::vector<double> squares(static_cast<std::size_t>(blocks()));
    for_blocks(machine, [&](std::int64_t block, std::int64_t first, std::int64_t end) {
        double sum = 0;
        for (std::int64_t run = first; run < end; ++run) {
            const Entries& q = entries(run);
            const auto at = [&](std::int64_t i) {
                return q.slope * (static_cast<double>(i - begin(run)) - q.middle);
            };
            double mean = 0, slope = 0; // Q^T x
            for (std::int64_t i = begin(run); i < begin(run + 1); ++i) {
                mean += q.mean * panel(i, column);
                slope += at(i) * panel(i, column);
            }
            for (std::int64_t i = begin(run); i < begin(run + 1); ++i)
                sum += std::pow(panel(i, column) - q.mean * mean - at(i) * slope, 2);
        }
        squares[static_cast<std::size_t>(block)] = sum;
    });
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
}

} // namespace stltsa
