// SPDX-License-Identifier: BSD-3-Clause
// New motion from pieces of clips (paper, section 4): pieces are cut at a common posture, joined,
// and blended across the seam.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "clip/body/up_axis.hpp"
#include "clip/clip.hpp"

namespace stltsa::synthesis {

/// Frames [begin, end) of a clip, `repeat` times.
struct Piece {
    const clip::Clip* clip = nullptr;
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int64_t repeat = 1;
    std::int64_t cycles = 0; ///< of the motion in these frames; 0: unknown
};

struct Options {
    std::optional<double> crossfade; ///< seconds to each side of a seam; empty: chosen for each
    std::optional<double> search;    ///< seconds by which a cut may move; empty: chosen for each
    double posture_limit = 3;        ///< upper limit of a seam's `posture`; 0: no limit
    std::optional<clip::Axis> up;
    bool loop = false;     ///< the last frame meets the first
    bool in_place = false; ///< of a loop: without its travel and turn
};

/// The transition from one piece to another, or to its own repetition. Frame numbers are those
/// after any resampling. The wrap of a loop is its last seam: `frame` is the number of frames.
struct Seam {
    std::int64_t frame = 0;     ///< first frame of the later piece in the new clip
    std::int64_t piece = 0;     ///< index of the earlier piece
    std::int64_t next = 0;      ///< index of the later piece
    std::int64_t cut_end = 0;   ///< the earlier piece ends before this frame of its clip
    std::int64_t cut_begin = 0; ///< the later piece begins at this frame of its clip
    std::int64_t crossfade = 0; ///< frames to each side that are blended
    double posture = 0;         ///< distance at the cuts relative to that of repetitions
    double step = 0; ///< largest pose step near the seam, relative to the pieces' 95th percentile
    double acceleration = 0; ///< the same of the second difference
};

/// How a loop goes on from its last frame to its first.
struct Loop {
    clip::Vec3 travel{}; ///< of one loop in the plane; in place: what was removed
    double turn = 0;     ///< the same of the heading, in radians about the up axis
    double coverage = 0; ///< share of the pieces' frames, or of the source's cycles, in the loop
    std::int64_t cycles = 0;        ///< in the loop, if whole cycles were chosen
    std::int64_t source_cycles = 0; ///< from which they were chosen
};

struct Synthesis {
    clip::Clip clip;
    std::vector<Seam> seams;
    std::optional<Loop> loop; ///< if the clip is one
    std::vector<std::string> notes;
    Warnings warnings;
    clip::Axis up = clip::Axis::none; ///< the axis used
};

/// Throws Status::argument (a piece exceeds its clip, in_place without loop), unsupported (bare
/// numbers, no frame rate, different hierarchies), no_common_posture.
Synthesis synthesize(std::span<const Piece> pieces, const Options& options);

} // namespace stltsa::synthesis
