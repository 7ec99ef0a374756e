// SPDX-License-Identifier: BSD-3-Clause
// What a model keeps for streams.
#pragma once

#include <string>
#include <vector>

#include "clip/features/frame_features.hpp"
#include "phase/live.hpp"

namespace stltsa::results {

struct PhasedMark {
    std::string name;
    double phase = 0;
};

struct Live {
    bool has_cycle = false; ///< else nothing below is there
    std::int32_t label = 0; ///< of the motion in its clip
    clip::Body body;        ///< what a frame's features need
    phase::LiveCycle cycle;
    std::vector<PhasedMark> marks;
};

} // namespace stltsa::results
