// SPDX-License-Identifier: BSD-3-Clause
// The seams between runs: where they are cut and how alike the postures are there.
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
    double posture = 0;                ///< the cut's distance over that between repetitions
};

/// One cut between each run and the next. Seams of a piece with its own repetition are all cut
/// alike.
std::vector<ChosenCut> choose_cuts(std::span<const Track> tracks, std::span<const Part> parts,
                                   std::span<const Run> runs, const Options& options,
                                   const Progress& progress);

} // namespace stltsa::synthesis
