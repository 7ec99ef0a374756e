// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Frames at the start that belong to a T-pose snapping into the motion (0 where there is none).
std::int64_t tpose_frames(ConstMatrixView features);

} // namespace stltsa::clip
