// SPDX-License-Identifier: BSD-3-Clause
// The two sides of a body of points, told by names as LHEE and RHEE.
#pragma once

#include <cstddef>
#include <vector>

#include "clip/body/up_axis.hpp"
#include "clip/clip.hpp"

namespace stltsa::clip {

/// Two points of a clip whose names differ in the side only.
struct SidePair {
    std::size_t one = 0, other = 0;
};

/// None if a point has no name.
std::vector<SidePair> side_pairs(const Clip& clip);

/// Weights of the columns of points in space whose sum tells which leg is forward: of the lowest
/// points with names of two sides, those of one side less those of the other. Empty without such
/// names, and for points in a plane. The same sides in every clip with these names.
std::vector<double> point_side_weights(const Clip& clip, Axis up, ConstMatrixView samples);

} // namespace stltsa::clip
