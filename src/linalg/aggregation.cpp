// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/aggregation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace stltsa {

template <class Work>
void Aggregation::for_runs(const Machine& machine, const Work& work) const {
    for_row_blocks(
        runs(), machine, [&](std::int64_t block, std::int64_t first, std::int64_t count) {
            for (std::int64_t run = first; run < first + count; ++run)
                work(block, run, run * length_, std::min(length_, rows_ - run * length_));
        });
}

namespace {

/// The entries of Q in a run.
double scale_of(std::int64_t rows) {
    return 1 / std::sqrt(static_cast<double>(rows));
}

double column_sum(ConstMatrixView panel, std::int64_t column) {
    double sum = 0;
    for (std::int64_t i = 0; i < panel.rows; ++i)
        sum += panel(i, column);
    return sum;
}

} // namespace

void Aggregation::spread(ConstMatrixView coarse, MatrixView panel, const Machine& machine) const {
    for_runs(machine, [&](std::int64_t, std::int64_t run, std::int64_t begin, std::int64_t rows) {
        const double scale = scale_of(rows);
        for (std::int64_t i = begin; i < begin + rows; ++i)
            for (std::int64_t c = 0; c < panel.cols; ++c)
                panel(i, c) = scale * coarse(run, c);
    });
}

void Aggregation::gather(ConstMatrixView panel, MatrixView coarse, const Machine& machine) const {
    for_runs(machine, [&](std::int64_t, std::int64_t run, std::int64_t begin, std::int64_t rows) {
        for (std::int64_t c = 0; c < panel.cols; ++c)
            coarse(run, c) = scale_of(rows) * column_sum(panel.block(begin, rows), c);
    });
}

double Aggregation::variation_within(ConstMatrixView panel, std::int64_t column,
                                     const Machine& machine) const {
    std::vector<double> squares(static_cast<std::size_t>(row_blocks(runs())));
    for_runs(machine, [&](std::int64_t block, std::int64_t, std::int64_t begin, std::int64_t rows) {
        const double mean =
            column_sum(panel.block(begin, rows), column) / static_cast<double>(rows);
        for (std::int64_t i = begin; i < begin + rows; ++i)
            squares[static_cast<std::size_t>(block)] += std::pow(panel(i, column) - mean, 2);
    });
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
}

} // namespace stltsa
