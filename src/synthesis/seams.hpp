// SPDX-License-Identifier: BSD-3-Clause
// The seams between runs: their cuts, and the distances of the postures at the cuts.
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
    double posture = 0;                ///< distance of the postures relative to that of repetitions
};

/// One cut between each run and the next; the same between all repetitions of one piece. Of a loop
/// the last is the wrap's, from the last run to the first.
std::vector<ChosenCut> choose_cuts(std::span<const Track> tracks, std::span<const Part> parts,
                                   std::span<const Run> runs, const Options& options);

/// The cut between a piece of a track and its repetition; `part.track` is 0.
ChosenCut repetition_cut(const Track& track, const Part& part, const Options& options);

} // namespace stltsa::synthesis
