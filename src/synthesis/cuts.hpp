// SPDX-License-Identifier: BSD-3-Clause
// Finds the common posture at which one run can continue as another (paper, section 4).
#pragma once

#include <cstdint>
#include <limits>

#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// Allowed range for the number of frames from `begin` to `end` of one motion, both ends included.
/// The number is negative if frames are left out.
struct Lengths {
    std::int64_t least = std::numeric_limits<std::int64_t>::min();
    std::int64_t most = std::numeric_limits<std::int64_t>::max();

    bool allow(std::int64_t frames) const { return frames >= least && frames <= most; }
};

/// Range for a repeated piece: about its own length.
Lengths lengths_repeated(std::int64_t length);

/// Range for a motion that leaves out `length` frames of itself (negative) or plays them twice
/// (positive). At least half of them must be left out (or played twice), which lets a cycle join
/// the next but one at their common posture. Fewer frames than half a cycle are all left out:
/// otherwise the best match would always be to leave out none.
Lengths lengths_left_out(std::int64_t length, double cycle);

/// A join before its cut is chosen: the earlier run ends before frame `end` of its clip, the later
/// one begins at frame `begin`.
struct Join {
    const Track* earlier = nullptr;
    const Track* later = nullptr;
    std::int64_t end = 0;
    std::int64_t begin = 0;
    std::int64_t earlier_length = 0; ///< frames of the runs
    std::int64_t later_length = 0;
    Lengths lengths; ///< allowed range of `end` - `begin`
};

struct CutOptions {
    std::int64_t search = 0;    ///< frames by which a cut may move
    std::int64_t crossfade = 0; ///< requested frames to each side
    double velocity_s = 0;      ///< weight of velocities
};

struct Cut {
    std::int64_t end = 0;
    std::int64_t begin = 0;
    std::int64_t crossfade = 0; ///< available frames to each side
    double distance = 0;        ///< of the postures and velocities
};

/// The most similar pair of frames, including the frames around them that the crossfade will blend.
/// A pair near the end of a clip, with fewer frames to blend, must be more similar. Each run keeps
/// at least half of its length. If no pair is allowed, the cuts stay where they are.
Cut find_cut(const Join& join, const CutOptions& options);

} // namespace stltsa::synthesis
