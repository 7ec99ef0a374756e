// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/aggregation.hpp"

#include <cmath>
#include <numeric>
#include <vector>

namespace stltsa {

template <class Work>
void Aggregation::for_runs(const Machine& machine, const Work& work) const {
    for_row_blocks(runs(), machine,
                   [&](std::int64_t block, std::int64_t first, std::int64_t count) {
                       for (std::int64_t run = first; run < first + count; ++run)
                           work(block, run);
                   });
}

void Aggregation::spread(ConstMatrixView coarse, MatrixView panel, const Machine& machine) const {
    for_runs(machine, [&](std::int64_t, std::int64_t run) {
        for (std::int64_t i = begin(run); i < begin(run + 1); ++i)
            for (std::int64_t c = 0; c < panel.cols; ++c)
                panel(i, c) = entry(run) * coarse(run, c);
    });
}

double Aggregation::variation_within(ConstMatrixView panel, std::int64_t column,
                                     const Machine& machine) const {
    std::vector<double> squares(static_cast<std::size_t>(row_blocks(runs())));
    for_runs(machine, [&](std::int64_t block, std::int64_t run) {
        double sum = 0;
        for (std::int64_t i = begin(run); i < begin(run + 1); ++i)
            sum += panel(i, column);
        const double mean = sum / static_cast<double>(begin(run + 1) - begin(run));
        for (std::int64_t i = begin(run); i < begin(run + 1); ++i)
            squares[static_cast<std::size_t>(block)] += std::pow(panel(i, column) - mean, 2);
    });
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
}

} // namespace stltsa
