// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/band.hpp"

#include <vector>

#include <lapacke.h>

#include "base/parallel.hpp"

namespace stltsa {

BandMatrix::BandMatrix(std::int64_t order, std::int64_t bandwidth)
    : order_(order), bandwidth_(bandwidth) {
    entries_.resize(checked_size(order, bandwidth + 1));
}

bool BandMatrix::factor(double smallest) {
    std::vector<double> diagonal(static_cast<std::size_t>(order_));
    for (std::int64_t j = 0; j < order_; ++j)
        diagonal[static_cast<std::size_t>(j)] = *column(j);
    if (LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', static_cast<lapack_int>(order_),
                            static_cast<lapack_int>(bandwidth_), entries_.data(),
                            static_cast<lapack_int>(bandwidth_ + 1)) != 0)
        return false;
    for (std::int64_t j = 0; j < order_; ++j)
        if (!(*column(j) * *column(j) > smallest * diagonal[static_cast<std::size_t>(j)]))
            return false;
    return true;
}

void BandMatrix::solve(MatrixView rows, const Machine& machine) const {
    constexpr std::int64_t few = 4096; // a solve is faster than starting threads
    parallel_blocks(rows.rows, threads_for(order_, few, machine), [&](std::int64_t row) {
        LAPACKE_dpbtrs_work(LAPACK_COL_MAJOR, 'L', static_cast<lapack_int>(order_),
                            static_cast<lapack_int>(bandwidth_), 1, entries_.data(),
                            static_cast<lapack_int>(bandwidth_ + 1), rows.row(row),
                            static_cast<lapack_int>(order_));
    });
}

} // namespace stltsa
