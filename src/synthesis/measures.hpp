// SPDX-License-Identifier: BSD-3-Clause
// Measures how visible a seam is.
#pragma once

#include <cstdint>

#include "synthesis/cuts.hpp"
#include "synthesis/synthesis.hpp"
#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// Relative to the usual roughness; above this a seam may be visible.
inline constexpr double visible_step = 1.4;
inline constexpr double visible_acceleration = 3;
/// The same for the distance of the postures: half of its upper limit.
double visible_posture(const Options& options);

/// Pose step |p_t - p_(t-1)| and second difference |p_(t+1) - 2 p_t + p_(t-1)|: the largest in a
/// range of frames, or the 95th percentile.
struct Roughness {
    double step = 0;
    double acceleration = 0;
};

/// The 95th percentile of frames [begin, end); above 0.
Roughness usual_roughness(const Track& track, std::int64_t begin, std::int64_t end);
/// The largest within an eighth of a second around frame `seam`. Of a loop, the first frame follows
/// the last.
Roughness roughness_near(const Track& track, std::int64_t seam, bool loop = false);
/// The largest step in the world near the wrap of a loop in place, over the 95th percentile of its
/// steps outside of the crossfade.
double wrap_step(const clip::Clip& loop, std::int64_t crossfade);
/// Roughness across a cut of one track that is not made yet: postures in place of poses are
/// blended.
Roughness roughness_across(const Track& track, const Cut& cut);

} // namespace stltsa::synthesis
