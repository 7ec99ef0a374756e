// SPDX-License-Identifier: BSD-3-Clause
// Compares the two halves of a cycle if they are the same motion of opposite sides of a body.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::phase {

/// A column of signals over a cycle: mean and standard deviation across the cycles, at evenly
/// spaced phases. The first sample is not repeated at the end.
struct CycleCurve {
    std::vector<double> mean, deviation;
};

/// `mean`, `deviation`: samples x columns; the last sample repeats the first.
CycleCurve curve_of(const Matrix& mean, const Matrix& deviation, std::int64_t column);

/// The curve shifted by half a cycle: each sample has the value from half a cycle later.
CycleCurve half_a_cycle_later(const CycleCurve& curve);

/// The difference of a left and a right curve. All fields are NaN if a mean lacks a sample.
struct CurveDifference {
    double rms = 0;    ///< root mean square of left minus right
    double chance = 0; ///< `rms` expected from the spread of the cycles; NaN for one cycle
    double mean = 0;   ///< mean of left minus mean of right
    double left_range = 0, right_range = 0; ///< highest minus lowest value
    /// Delay of the right curve as a share of the cycle, and the correlation of the curves after
    /// this shift is removed. NaN if a curve does not move or the curves are not alike.
    double shift = 0, correlation = 0;
};

CurveDifference difference(const CycleCurve& left, const CycleCurve& right, std::int64_t cycles,
                           PacedPoll& polls);

} // namespace stltsa::phase
