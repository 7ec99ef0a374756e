// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// The frame after the largest step between two frames, if it is too large for a body: large
/// relative to the variation of all frames and to the steps before and after it. 0: there is none.
/// `features`: not smoothed.
std::int64_t find_jump(ConstMatrixView features);

} // namespace stltsa::clip
