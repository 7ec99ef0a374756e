// SPDX-License-Identifier: BSD-3-Clause
// Fits a smooth curve to noisy values over time; the values determine the amount of smoothing.
#pragma once

#include <span>
#include <vector>

namespace stltsa::motion {

struct SplineOptions {
    double knot_step = 4; ///< rows between knots, which limits the detail of the curve
    bool robust = false;  ///< values far from their neighbors do not distort the curve
};

struct Spline {
    std::vector<double> curve;     ///< one value per row
    double lambda = 0;             ///< weight of the penalty; infinite: a straight line
    double degrees_of_freedom = 0; ///< effective degrees of freedom: 2 for a straight line
};

/// The penalized cubic spline (spline_system.hpp) whose lambda minimizes the generalized
/// cross-validation score (Craven, Wahba, Numer. Math. 31, 1979). `values`: at least two, finite.
/// Scaling them by a power of two scales the curve exactly.
Spline fit_spline(std::span<const double> values, const SplineOptions& options);

/// The e with 2^(e-1) <= largest |value| < 2^e; 0 if all values are 0.
int binary_exponent(std::span<const double> values);

} // namespace stltsa::motion
