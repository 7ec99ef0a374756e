// SPDX-License-Identifier: BSD-3-Clause
// Finds the frames at which to cut two stretches of motion so that one continues as the other.
#pragma once

#include <cstdint>
#include <limits>

#include "base/progress.hpp"
#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// Allowed range of frames from `begin` to `end` in one motion, both ends included; negative if
/// `begin` is later, that is, if frames are left out.
struct Lengths {
    std::int64_t least = std::numeric_limits<std::int64_t>::min();
    std::int64_t most = std::numeric_limits<std::int64_t>::max();

    bool allow(std::int64_t frames) const { return frames >= least && frames <= most; }
};

/// Range for a repeated stretch: about its own length.
Lengths lengths_repeated(std::int64_t length);

/// Range for a motion that leaves out `length` frames of itself (negative) or plays them twice. At
/// least half of them stay out (or are played twice), so that a cycle can meet the next but one at
/// their common posture. If they are less than half a cycle, all of them do: so close together, the
/// best match would always be to leave out nothing.
Lengths lengths_left_out(std::int64_t length, double cycle);

/// A join before its cut is chosen: the earlier stretch ends before frame `end` of its clip, the
/// later one begins at frame `begin`.
struct Join {
    const Track* earlier = nullptr;
    const Track* later = nullptr;
    std::int64_t end = 0;
    std::int64_t begin = 0;
    std::int64_t earlier_length = 0; ///< frames of the stretches
    std::int64_t later_length = 0;
    Lengths lengths; ///< allowed range of `end` - `begin`
};

struct CutOptions {
    std::int64_t search = 0;    ///< frames by which a cut may move
    std::int64_t crossfade = 0; ///< wanted frames to each side
    double velocity_s = 0;      ///< weight of velocities
};

struct Cut {
    std::int64_t end = 0;
    std::int64_t begin = 0;
    std::int64_t crossfade = 0; ///< available frames to each side
    double distance = 0;        ///< of the postures and velocities
};

/// The most similar pair of frames, judged with the frames around them that the crossfade will
/// blend. A pair near the end of a clip, with fewer frames to blend, must be more similar. Each
/// stretch keeps at least half of its length. If no pair is allowed, the cuts stay.
Cut find_cut(const Join& join, const CutOptions& options, const Progress& progress);

} // namespace stltsa::synthesis
