// SPDX-License-Identifier: BSD-3-Clause
// A smooth curve through noisy values over time, as smooth as the values themselves ask for.
#pragma once

#include <span>
#include <vector>

namespace stltsa::motion {

struct SplineOptions {
    double knot_step = 4; ///< rows between knots: no detail of the curve is finer
    bool robust = false;  ///< values far from their neighbors do not pull at the curve
};

struct Spline {
    std::vector<double> curve;     ///< a value per row
    double lambda = 0;             ///< weight of the penalty; infinite: a straight line
    double degrees_of_freedom = 0; ///< effective degrees of freedom: 2 for a straight line
};

/// The penalized cubic spline (spline_system.hpp) whose lambda has the least score of generalized
/// cross-validation (Craven, Wahba, Numer. Math. 31, 1979). Values are finite; two at least.
/// Multiplying them by a power of two does so to the curve, to the bit.
Spline fit_spline(std::span<const double> values, const SplineOptions& options);

/// e such that all values are below 2^e in size, and not all below 2^(e-1); 0 where all are 0.
int binary_exponent(std::span<const double> values);

} // namespace stltsa::motion
