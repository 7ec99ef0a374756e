// SPDX-License-Identifier: BSD-3-Clause
// Gaussian smoothing over time and the slope of a curve.
#pragma once

#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Smooths every column over the rows; sigma in samples. At the ends the remaining kernel is scaled
/// to sum to 1. Reflecting the samples there, as for features, removes no more false rests in 397
/// walks and runs cut in mid-step, but adds noise to the speed and shifts borders in noisy clips.
Matrix smooth(ConstMatrixView samples, double sigma);
std::vector<double> smooth(std::span<const double> curve, double sigma);

/// First differences f'_y(t) per sample (paper, section 3.1), central, but one-sided at the ends.
std::vector<double> slope(std::span<const double> curve);

} // namespace stltsa::motion
