// SPDX-License-Identifier: BSD-3-Clause
// What the curves of few columns look like, where windowed means and deviations say too little: two
// shapes may have both in common.
#pragma once

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Moments in a usual period.
inline constexpr std::int64_t moments_of_period = 4;

struct Shapes {
    Matrix rows;           ///< moments x at most 12 principal directions
    std::int64_t step = 1; ///< poses from one moment to the next
};

/// The share of time in which each of some convolutions is above a quantile, in a Gaussian window
/// of 1.5 periods (random convolutions: Dempster, Schmidt, Webb, KDD 2021). They are the same on
/// every run. No rows if there are fewer than 128 poses.
Shapes make_shapes(ConstMatrixView poses);

} // namespace stltsa::motion
