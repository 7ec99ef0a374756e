// SPDX-License-Identifier: BSD-3-Clause
// Keeps standing feet from sliding while one posture blends into another.
#pragma once

#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// Offset, in the body's axes, from the joints of frame a of the earlier clip to those of frame b
/// of the later: the mean over all joints, weighted towards joints that move little in the world
/// in both. Shifting the body back by this offset keeps a standing foot in place.
Vec3 standing_offset(const Track& earlier, std::int64_t a, const Track& later, std::int64_t b);

} // namespace stltsa::synthesis
