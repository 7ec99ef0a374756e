// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/principal.hpp"

#include <algorithm>

#include "base/checkpoint.hpp"
#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"
#include "linalg/weighted_rows.hpp"

namespace stltsa {

std::vector<double> column_means(ConstMatrixView rows) {
    std::vector<double> means(static_cast<std::size_t>(rows.cols));
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        axpy(1 / static_cast<double>(rows.rows), rows.row(i), means.data(), rows.cols);
        checkpoint(rows.cols);
    }
    return means;
}

double total_variance(ConstMatrixView rows) {
    const std::vector<double> means = column_means(rows);
    double squares = 0;
    for (std::int64_t i = 0; i < rows.rows; ++i)
        squares += squared_distance(rows.row(i), means.data(), rows.cols);
    return rows.rows > 0 ? squares / static_cast<double>(rows.rows) : 0;
}

void set_covariance(ConstMatrixView centered, double* matrix) {
    constexpr std::int64_t rows_at_once = 32;
    const std::int64_t p = centered.cols;
    std::fill_n(matrix, p * p, 0.0);
    Matrix shares(rows_at_once, p);
    for (std::int64_t i = 0; i < centered.rows; i += rows_at_once) {
        checkpoint(rows_at_once * p * p / 2);
        const ConstMatrixView block = centered.block(i, std::min(rows_at_once, centered.rows - i));
        for (std::int64_t r = 0; r < block.rows; ++r)
            for (std::int64_t c = 0; c < p; ++c)
                shares(r, c) = block(r, c) / static_cast<double>(centered.rows);
        for (std::int64_t c = 0; c < p; ++c)
            add_weighted({block.data + c, block.rows, p - c, block.stride}, shares.data() + c, p,
                         matrix + c * p + c);
    }
}

PrincipalDirections principal_directions(ConstMatrixView centered, std::int64_t most) {
    const std::int64_t p = centered.cols;
    const std::int64_t count = std::min({most, p, centered.rows});
    TopEigenpairs pairs(p, count);
    set_covariance(centered, pairs.matrix());
    pairs.solve();
    PrincipalDirections found{Matrix(count, p), {}};
    for (std::int64_t d = 0; d < count; ++d) {
        std::copy_n(pairs.vector(d), p, found.directions.row(d));
        found.variances.push_back(std::max(pairs.value(d), 0.0));
    }
    return found;
}

} // namespace stltsa
