// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clip/body/up_axis.hpp"

namespace stltsa::clip {

/// Coordinate axes of the body root: 0, 1, 2 for x, y, z.
struct LevelAxes {
    std::size_t lateral = 0;
    std::size_t forward = 0;
};

/// Of the two level axes, the lateral one is that along which the neutral joints lie on both sides
/// alike. It follows from the skeleton alone, so that clips agree.
LevelAxes level_axes(const Skeleton& skeleton, std::size_t root, Axis up);

} // namespace stltsa::clip
