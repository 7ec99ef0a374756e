// SPDX-License-Identifier: BSD-3-Clause
// The few directions in which a recording moves.
#pragma once

#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Orthonormal columns that contain most of the variance of poses and of velocities, with equal
/// weights, because a tapping foot has little variance of pose on a swaying body. Velocities are
/// relative to the usual step from row to row (`usual`), because a tapping foot has little variance
/// of velocity beside a run.
Matrix leading_directions(ConstMatrixView x, const std::vector<double>& usual);

} // namespace stltsa::motion
