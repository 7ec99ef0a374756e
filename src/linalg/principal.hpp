// SPDX-License-Identifier: BSD-3-Clause
// Means of rows, and the directions in which they vary most.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa {

std::vector<double> column_means(ConstMatrixView rows);

/// Mean squared distance of the rows from their mean.
double total_variance(ConstMatrixView rows);

/// Of centered rows: the lower triangle by columns.
void set_covariance(ConstMatrixView centered, double* matrix);

struct PrincipalDirections {
    Matrix directions;             ///< orthonormal rows, that of the largest variance first
    std::vector<double> variances; ///< along them, not negative
};

/// At most `most`, of centered rows.
PrincipalDirections principal_directions(ConstMatrixView centered, std::int64_t most);

} // namespace stltsa
