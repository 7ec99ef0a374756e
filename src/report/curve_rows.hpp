// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/decomposed.hpp"

namespace stltsa::report {

/// Of every step-th sample the coordinate that was cut and, beside it, the two of the loop; NaN
/// where nothing was fitted.
Matrix curve_rows(const results::Decomposed& decomposed, std::int64_t step);

} // namespace stltsa::report
