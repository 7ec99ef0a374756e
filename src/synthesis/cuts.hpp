// SPDX-License-Identifier: BSD-3-Clause
// Where two stretches of motion are cut, so that one can go on as the other.
#pragma once

#include <cstdint>
#include <limits>

#include "base/progress.hpp"
#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// How many frames there may be from `begin` to `end` in one motion, with both ends of the range;
/// below 0 where `begin` is the later, and frames are left out.
struct Lengths {
    std::int64_t least = std::numeric_limits<std::int64_t>::min();
    std::int64_t most = std::numeric_limits<std::int64_t>::max();

    bool allow(std::int64_t frames) const { return frames >= least && frames <= most; }
};

/// Of a stretch of so many frames that is repeated: about as many.
Lengths lengths_repeated(std::int64_t length);

/// Where a motion goes on elsewhere in itself, having left out so many frames (below 0) or playing
/// them twice. At least half of them stay out (or are played twice), so that a cycle can meet the
/// next but one at their common posture; of less than half a cycle all do: there the motion is the
/// more like itself the less is left out, and most like itself with nothing left out.
Lengths lengths_left_out(std::int64_t length, double cycle);

/// What is to be joined: the earlier stretch would end before frame `end` of its clip, the later
/// one begin at frame `begin`.
struct Join {
    const Track* earlier = nullptr;
    const Track* later = nullptr;
    std::int64_t end = 0;
    std::int64_t begin = 0;
    std::int64_t earlier_length = 0; ///< frames of the stretches
    std::int64_t later_length = 0;
    Lengths lengths; ///< that `end` - `begin` may come to have
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
