// SPDX-License-Identifier: BSD-3-Clause
// What a BVH file can say, and clips of other skeletons in these terms.
#pragma once

#include "clip/clip.hpp"

namespace stltsa::clip {

/// How the position channels of a BVH file's joints below the root are meant: whether they add to
/// the joints' OFFSETs. Nothing in the file says so but the numbers.
bool positions_add_to_offsets(const Skeleton& skeleton, const SharedMatrix& values);

/// The same motion by rotations about moving axes, with a meaning of position channels that the
/// rule above gives back. A clip that was read from BVH is as it was.
Clip in_bvh_form(const Clip& clip);

} // namespace stltsa::clip
