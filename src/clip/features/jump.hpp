// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// The row after the largest step between two rows, if it is too large for a body: large relative
/// to the steps before and after it, and to those of all rows. 0: there is none. So it does not
/// matter how far the body travels. `rows`: not smoothed; missing groups of `width` columns do not
/// count.
std::int64_t find_jump(ConstMatrixView rows, int width);

} // namespace stltsa::clip
