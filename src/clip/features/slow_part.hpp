// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// The rows smoothed over time by a Gaussian of `sigma` rows. The time taken does not grow with
/// sigma: it is sampled eight times in a sigma, with straight lines between.
Matrix slow_part(const Matrix& rows, double sigma);

} // namespace stltsa::clip
