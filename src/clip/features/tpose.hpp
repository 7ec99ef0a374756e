// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Number of frames at the start that belong to a T-pose or to the jump out of it.
std::int64_t tpose_frames(ConstMatrixView features);

} // namespace stltsa::clip
