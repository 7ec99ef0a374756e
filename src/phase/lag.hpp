// SPDX-License-Identifier: BSD-3-Clause
// The delay of one closed curve relative to another.
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa::phase {

/// Below this correlation, one curve explains less than half of the variance of the other, so it is
/// not clear which parts of the curves correspond.
inline constexpr double least_correlation = 0.7;

/// Curves over a cycle at evenly spaced phases: samples x columns. The first sample is not repeated
/// at the end. Columns are the coordinates of one curve, such as those of a joint or of the body.
struct Lag {
    double samples = 0;     ///< delay of the second curve; NaN: no peak
    double correlation = 0; ///< after this delay is removed; NaN: a curve does not move
    /// The next highest peak of the correlation; NaN: there is no other within `most`.
    double runner_up = 0;
};

/// The lag, at most `most` samples, at which the curves match best once their means are subtracted:
/// the peak of the parabola through the highest correlation and its two neighbors.
Lag lag_between(ConstMatrixView first, ConstMatrixView second, std::int64_t most);

/// Each sample has the value from `shift` samples later; linear between samples, cyclic.
Matrix later(ConstMatrixView curves, double shift);

/// Change per sample: central differences, cyclic.
Matrix slope(ConstMatrixView curves);

} // namespace stltsa::phase
