// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa {

/// Every step-th row, from the first on, smoothed over time by a Gaussian of `sigma` rows, cut at
/// four sigma. At the ends, where the kernel reaches out, what is left of it is scaled to sum to 1.
/// Rows that do not change come out bit for bit as they are, so that standing still stays that.
Matrix gaussian_smoothed(ConstMatrixView rows, double sigma, std::int64_t step = 1);

} // namespace stltsa
