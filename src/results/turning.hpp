// SPDX-License-Identifier: BSD-3-Clause
// Turns one body to the heading of another.
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa::results {

/// The columns of points for the two horizontal axes.
struct Level {
    std::int64_t first = 0, second = 0, width = 0; ///< width 0: there are none
};

/// How well `mean`, turned about the up axis by the best angle, matches `to`: the sum of their
/// products.
double likeness_if_turned(ConstMatrixView to, ConstMatrixView mean, const Level& level);

/// Turns the signals about the up axis by the angle that brings `mean`, their mean curves, closest
/// to `to`, the curves of the other body at the same phases. Returns the angle in degrees. NaN
/// values are left out.
double turn_to(ConstMatrixView to, ConstMatrixView mean, const Level& level, Matrix& signals);

} // namespace stltsa::results
