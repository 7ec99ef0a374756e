// SPDX-License-Identifier: BSD-3-Clause
// Distance of postures between repetitions of a motion: the unit for posture distances at a seam.
#pragma once

#include <cstdint>

#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// Period in seconds of the motion in and around frames [begin, end); 0 if there is none.
double period_near(const Track& track, std::int64_t begin, std::int64_t end);

/// Median distance of frames [begin, end) from the most similar frame in the previous or next
/// cycle. Without such a cycle, a typical value for motions that have one.
double repetition_distance(const Track& track, std::int64_t begin, std::int64_t end,
                           double period_s, double velocity_s);

} // namespace stltsa::synthesis
