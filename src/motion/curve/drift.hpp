// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Share of the samples' variance that a straight line over time explains, 0 to 1.
double drift_share(ConstMatrixView samples);

} // namespace stltsa::motion
