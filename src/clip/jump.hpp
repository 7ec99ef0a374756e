// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// The frame that follows the largest step between two frames, if no body moves like that: far
/// against all motion and against the steps just before and after it. 0: there is none.
/// `features`: as they are, not smoothed.
std::int64_t find_jump(ConstMatrixView features);

} // namespace stltsa::clip
