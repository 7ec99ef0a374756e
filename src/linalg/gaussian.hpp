// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa {

/// How the kernel continues beyond the first and the last row.
enum class Beyond {
    nothing,   ///< truncated and normalized: little noise, but a motion slows down at the ends
    reflection ///< 2 x_0 - x_i, through the end row: a steady motion keeps its speed
};

/// Every step-th row, from the first on, smoothed over time by a Gaussian of `sigma` rows,
/// truncated at four sigma. Constant rows keep their bits, so that standing stays standing.
Matrix gaussian_smoothed(ConstMatrixView rows, double sigma, Beyond beyond, std::int64_t step = 1);

/// Every row, into a matrix of others.
void smooth_to(MatrixView smoothed, ConstMatrixView rows, double sigma, Beyond beyond);

/// The same without a second matrix of that size.
void smooth_in_place(Matrix& rows, double sigma, Beyond beyond);

} // namespace stltsa
