// SPDX-License-Identifier: BSD-3-Clause
// The seams between runs: their cuts, and the distance of the postures there.
#pragma once

#include <span>
#include <vector>

#include "synthesis/cuts.hpp"
#include "synthesis/plan.hpp"
#include "synthesis/synthesis.hpp"

namespace stltsa::synthesis {

struct ChosenCut {
    Cut cut;
    std::int64_t wanted_crossfade = 0; ///< frames to each side
    double posture = 0;                ///< the cut's distance relative to that between repetitions
};

/// One cut between each run and the next. All seams between repetitions of one piece have the same
/// cut.
std::vector<ChosenCut> choose_cuts(std::span<const Track> tracks, std::span<const Part> parts,
                                   std::span<const Run> runs, const Options& options,
                                   const Progress& progress);

} // namespace stltsa::synthesis
