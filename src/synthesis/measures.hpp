// SPDX-License-Identifier: BSD-3-Clause
// Measures how visible a seam is.
#pragma once

#include <cstdint>

#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// Pose step |p_t - p_(t-1)| and second difference |p_(t+1) - 2 p_t + p_(t-1)|: the largest in a
/// range of frames, or the 95th percentile.
struct Roughness {
    double step = 0;
    double acceleration = 0;
};

/// The 95th percentile of frames [begin, end); above 0.
Roughness usual_roughness(const Track& track, std::int64_t begin, std::int64_t end);
/// The largest within an eighth of a second around frame `seam`.
Roughness roughness_near(const Track& track, std::int64_t seam);

} // namespace stltsa::synthesis
