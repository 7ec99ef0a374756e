// SPDX-License-Identifier: BSD-3-Clause
// What keeps standing feet from sliding while one posture turns into another.
#pragma once

#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// How much further along the body's axes the later clip has, in its frame b, what stands still in
/// the earlier one's frame a: the mean over all joints, each counting the more the less it moves
/// through the world in both. The body must give way by as much for a standing foot to stay.
Vec3 standing_offset(const Track& earlier, std::int64_t a, const Track& later, std::int64_t b);

} // namespace stltsa::synthesis
