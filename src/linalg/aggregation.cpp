// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/aggregation.hpp"

#include <algorithm>
#include <cmath>

namespace stltsa {

template <class Work>
void Aggregation::for_runs(const Machine& machine, const Work& work) const {
    for_row_blocks(runs(), machine, [&](std::int64_t, std::int64_t first, std::int64_t count) {
        for (std::int64_t run = first; run < first + count; ++run) {
            const std::int64_t begin = run * length_;
            const std::int64_t rows = std::min(length_, rows_ - begin);
            work(run, begin, rows, 1 / std::sqrt(static_cast<double>(rows)));
        }
    });
}

void Aggregation::spread(ConstMatrixView coarse, MatrixView panel, const Machine& machine) const {
    for_runs(machine, [&](std::int64_t run, std::int64_t begin, std::int64_t rows, double scale) {
        for (std::int64_t i = begin; i < begin + rows; ++i)
            for (std::int64_t c = 0; c < panel.cols; ++c)
                panel(i, c) = scale * coarse(run, c);
    });
}

void Aggregation::gather(ConstMatrixView panel, MatrixView coarse, const Machine& machine) const {
    for_runs(machine, [&](std::int64_t run, std::int64_t begin, std::int64_t rows, double scale) {
        for (std::int64_t c = 0; c < panel.cols; ++c) {
            double sum = 0;
            for (std::int64_t i = begin; i < begin + rows; ++i)
                sum += panel(i, c);
            coarse(run, c) = scale * sum;
        }
    });
}

} // namespace stltsa
