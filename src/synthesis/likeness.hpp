// SPDX-License-Identifier: BSD-3-Clause
// How alike postures are when a motion repeats itself: the ruler for the postures at a seam.
#pragma once

#include <cstdint>

#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// Seconds after which the motion of frames [begin, end) and what is around them repeats itself; 0
/// where it does not.
double period_near(const Track& track, std::int64_t begin, std::int64_t end);

/// Median distance of the frames of [begin, end) to the frame that is most alike in the cycle
/// before or after. Where there is no such cycle, what is typical of motions that have one.
double repetition_distance(const Track& track, std::int64_t begin, std::int64_t end,
                           double period_s, double velocity_s);

} // namespace stltsa::synthesis
