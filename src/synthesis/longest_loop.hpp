// SPDX-License-Identifier: BSD-3-Clause
// Which of a clip's cycles make its loop: the most whose ends meet well. The smallest seam would
// choose the least motion.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "synthesis/synthesis.hpp"

namespace stltsa::synthesis {

/// Frames [begin, end) of a cycle.
struct CycleFrames {
    std::int64_t begin = 0;
    std::int64_t end = 0;
};

struct LongestLoop {
    Piece piece;
    std::string note; ///< what was chosen, and why
};

/// A range of consecutive cycles; the whole clip if there are none. A seam is good if, near it, the
/// largest step of the posture (positions of the joints relative to the root) is at most 1.2 times
/// the 95th percentile of the clip's steps, the largest step in the world at most as many times
/// that of the loop in place, and if synthesize() would not warn of it. If no range has a good
/// seam, the one with the smallest seam is chosen. Throws Status::argument (a cycle exceeds the
/// clip), unsupported.
LongestLoop longest_loop(const clip::Clip& clip, std::span<const CycleFrames> cycles,
                         const Options& options);

} // namespace stltsa::synthesis
