// SPDX-License-Identifier: BSD-3-Clause
// By how much one closed curve comes later than another.
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa::phase {

/// Below this correlation, one curve explains less than half of the variance of the other, so it is
/// not clear which of their features correspond.
inline constexpr double least_correlation = 0.7;

/// Curves over a cycle at evenly spaced phases: samples x columns. The first sample is not repeated
/// at the end. Columns are the coordinates of one curve, such as those of a joint or of the body.
struct Lag {
    double samples = 0;     ///< delay of the second curve; NaN: none fits best
    double correlation = 0; ///< of the curves after this shift is removed; NaN: one does not move
    /// The next highest peak of the correlation over all shifts; NaN: there is none within `most`.
    double runner_up = 0;
};

/// The lag at which the curves, each less its mean, match best, at most `most` samples: the peak of
/// the parabola through the best correlation and its two neighbors.
Lag lag_between(const Matrix& first, const Matrix& second, std::int64_t most);

/// Each sample has the value from `shift` samples later; linear between samples, cyclic.
Matrix later(const Matrix& curves, double shift);

/// Change per sample: central differences, cyclic.
Matrix slope(const Matrix& curves);

} // namespace stltsa::phase
