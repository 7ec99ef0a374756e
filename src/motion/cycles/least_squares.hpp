// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// The x that minimizes |A x - b|^2 + ridge * trace(A^T A) / cols * |x|^2, for few columns. A has
/// at least as many rows as `b`.
std::vector<double> least_squares(ConstMatrixView a, std::span<const double> b, double ridge);

} // namespace stltsa::motion
