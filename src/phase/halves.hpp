// SPDX-License-Identifier: BSD-3-Clause
// The two halves of a cycle against each other, where they are the same motion of the two sides of
// a body.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::phase {

/// A column of signals over a cycle: mean and standard deviation over the cycles at even places of
/// it. The first sample is not repeated at the end.
struct CycleCurve {
    std::vector<double> mean, deviation;
};

/// `mean`, `deviation`: samples x columns, the last sample being the first again.
CycleCurve curve_of(const Matrix& mean, const Matrix& deviation, std::int64_t column);

/// The curve that is half a cycle ahead: at each place what comes half a cycle later.
CycleCurve half_a_cycle_later(const CycleCurve& curve);

/// Two curves over the cycles of their sides. All are NaN if a sample of a mean is missing.
struct CurveDifference {
    double rms = 0;    ///< root mean square of left less right
    double chance = 0; ///< what `rms` would be by the spread of the cycles alone; NaN of one cycle
    double mean = 0;   ///< of left, less that of right
    double left_range = 0, right_range = 0; ///< from lowest to highest
    /// By which share of the cycle the right curve comes later, and the correlation of the curves
    /// with that shift removed. NaN: a curve does not move, or the curves are not alike.
    double shift = 0, correlation = 0;
};

CurveDifference difference(const CycleCurve& left, const CycleCurve& right, std::int64_t cycles);

} // namespace stltsa::phase
