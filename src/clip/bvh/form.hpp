// SPDX-License-Identifier: BSD-3-Clause
// The meaning of BVH channels, and conversion of other clips to them.
#pragma once

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Seconds that a frame of a BVH file may take. A body that is seen less often does not seem to
/// move, and a greater number is a rate (30) or milliseconds (33.3).
constexpr double shortest_frame_s = 1e-6, longest_frame_s = 1;

/// A skeleton whose positions have the meaning of BVH: those of the root replace its OFFSET, those
/// of the joints below it add to theirs if `below`, and otherwise replace them.
Skeleton with_positions(Skeleton skeleton, bool below);

/// Whether position channels of joints below the root add to OFFSET, which only their values can
/// tell.
bool positions_add_to_offsets(const Clip& clip);

/// The same motion as other programs expect it: joints in depth-first order, rotations about moving
/// axes, and positions that replace the joints' OFFSETs. If the rule above would misread these,
/// they add.
Clip in_bvh_form(const Clip& clip);

} // namespace stltsa::clip
