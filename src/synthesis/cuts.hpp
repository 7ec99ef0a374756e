// SPDX-License-Identifier: BSD-3-Clause
// Where two stretches of motion are cut, so that one can go on as the other.
#pragma once

#include <cstdint>

#include "base/progress.hpp"
#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// What is to be joined: the earlier stretch would end before frame `end` of its clip, the later
/// one begin at frame `begin`.
struct Join {
    const Track* earlier = nullptr;
    const Track* later = nullptr;
    std::int64_t end = 0;
    std::int64_t begin = 0;
    std::int64_t earlier_length = 0; ///< frames of the stretches
    std::int64_t later_length = 0;
    bool repeats = false; ///< the later stretch is the earlier one again
    /// In one motion: of the frames from `end` to `begin`, which are left out or, where `begin` is
    /// the earlier, played again, so many are.
    std::int64_t least_skip = 0;
};

struct CutOptions {
    std::int64_t search = 0;    ///< frames by which a cut may move
    std::int64_t crossfade = 0; ///< frames to each side that are wanted for blending
    double velocity_s = 0;      ///< weight of velocities
};

struct Cut {
    std::int64_t end = 0;
    std::int64_t begin = 0;
    std::int64_t crossfade = 0; ///< frames to each side that there are
    double distance = 0;        ///< of the postures and velocities
};

/// The pair of frames that are most alike, with those around them that the crossfade will mix. A
/// pair at the end of a clip, which has fewer frames to mix, must be the more alike for it. Each
/// stretch keeps at least half of its length. Where no pair is allowed, the cuts stay where they
/// are.
Cut find_cut(const Join& join, const CutOptions& options, const Progress& progress);

} // namespace stltsa::synthesis
