// SPDX-License-Identifier: BSD-3-Clause
// What a BVH file can say, and clips of other skeletons in these terms.
#pragma once

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Whether the position channels of a BVH clip's joints add to the joints' OFFSETs. Nothing in a
/// file says so but the numbers.
bool positions_add_to_offsets(const Clip& clip);

/// The same motion by rotations about moving axes, with positions that replace the joints' OFFSETs,
/// as other programs take them. Where the rule above would misread these, they add.
Clip in_bvh_form(const Clip& clip);

} // namespace stltsa::clip
