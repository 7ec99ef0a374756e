// SPDX-License-Identifier: BSD-3-Clause
// New motion from pieces of clips (paper, section 4): the pieces are cut where they have a posture
// in common, joined there, and blended across the seam.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "clip/clip.hpp"
#include "clip/features.hpp"

namespace stltsa::synthesis {

/// Frames [begin, end) of a clip, `repeat` times.
struct Piece {
    const clip::Clip* clip = nullptr;
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int64_t repeat = 1;
};

struct Options {
    double crossfade = -1;    ///< seconds to each side of a seam; below 0: chosen
    double search = -1;       ///< seconds by which a cut may move; below 0: chosen
    double posture_limit = 3; ///< most that a seam's `posture` may be; 0: no limit
    clip::Axis up = clip::Axis::automatic;
};

/// Where one piece gives way to another, or to its own repetition. Frames of clips that were
/// resampled are counted after that.
struct Seam {
    std::int64_t frame = 0;     ///< first frame of the new clip that is the later piece's
    std::int64_t piece = 0;     ///< index of the earlier piece
    std::int64_t next = 0;      ///< index of the later piece
    std::int64_t cut_end = 0;   ///< the earlier piece ends before this frame of its clip
    std::int64_t cut_begin = 0; ///< the later piece begins at this frame of its clip
    std::int64_t crossfade = 0; ///< frames to each side that are blended
    double posture = 0;         ///< distance at the cuts over what is common between repetitions
    double step = 0;         ///< largest pose step near the seam over the pieces' 95th percentile
    double acceleration = 0; ///< the same of the second difference
};

struct Synthesis {
    clip::Clip clip;
    std::vector<Seam> seams;
    std::vector<std::string> warnings;
    clip::Axis up = clip::Axis::automatic; ///< the axis used
};

/// Throws Status::argument (pieces that are not within their clips), unsupported (bare numbers, no
/// frame rate, other hierarchies), no_common_posture.
Synthesis synthesize(std::span<const Piece> pieces, const Options& options,
                     const Progress& progress);

} // namespace stltsa::synthesis
