// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clip/clip.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {

/// Reads a BVH file up to and including the word MOTION.
Skeleton read_bvh_hierarchy(TextCursor& in);

} // namespace stltsa::clip
