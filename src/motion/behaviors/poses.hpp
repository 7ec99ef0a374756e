// SPDX-License-Identifier: BSD-3-Clause
// Poses by which behaviors are told apart.
#pragma once

#include "motion/period/signal.hpp"

namespace stltsa::motion {

/// Every step-th row of the signal, with the rows of `beside` appended (samples x columns in other
/// units, may be empty; both are scaled to a total variance of 1), along their principal
/// directions. Each direction is divided by the root of its standard deviation, so that quiet but
/// structured motion counts; all are scaled to a mean variance of 1. No columns: nothing moves.
Matrix even_poses(const Signal& signal, const Matrix& beside, std::int64_t step);

/// The poses, then their velocities: rows x 2 columns. A velocity is the change in `seconds`;
/// `rate`: rows a second.
Matrix with_velocities(ConstMatrixView poses, double rate, double seconds);

/// The mean and the standard deviation of each column around each row, in a Gaussian window of
/// `sigma` rows: rows x 2 columns, first the means.
Matrix windowed(ConstMatrixView x, double sigma);

} // namespace stltsa::motion
