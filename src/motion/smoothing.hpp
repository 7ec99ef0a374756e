// SPDX-License-Identifier: BSD-3-Clause
// Gaussian smoothing over time and the slope of a curve.
#pragma once

#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Every column smoothed over the rows; sigma in samples. At the ends, where the kernel reaches
/// out, what is left of it is scaled to sum to 1.
Matrix smooth(ConstMatrixView samples, double sigma);
std::vector<double> smooth(std::span<const double> curve, double sigma);

/// Central differences per sample, one-sided at the ends.
std::vector<double> slope(std::span<const double> curve);

} // namespace stltsa::motion
