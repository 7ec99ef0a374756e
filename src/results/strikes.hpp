// SPDX-License-Identifier: BSD-3-Clause
// The foot strikes that a file states, found in every cycle.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "clip/foot_strikes.hpp"
#include "motion/recording/recording.hpp"
#include "results/decomposed.hpp"

namespace stltsa::results {

/// Of one motion in cycles, in frames, in order of time.
struct MotionStrikes {
    std::int64_t label = 0;
    Side side = Side::neither; ///< with which cycles begin
    std::vector<double> begins;
    std::vector<double> middles; ///< of the other side; empty: the file states none
    std::size_t stated_begins = 0, stated_middles = 0;
};

struct FoundStrikes {
    std::vector<MotionStrikes> motions; ///< those with strikes that agree with their cycles
    std::vector<std::string> notes;     ///< on the strikes that do not
};

/// A stated strike is one mark, or the mean of several within a quarter of a cycle. The strikes of
/// a side in the cycles without one are found as those of any event. Cycles begin with the side
/// that they begin with already, unless only the other one has two strikes or more.
FoundStrikes find_strikes(std::span<const clip::FootStrike> stated, const Decomposed& decomposed);

/// Says which events the cycles begin with, and which of them do not.
void note_strikes(const FoundStrikes& strikes, const motion::Recording& found,
                  std::vector<std::string>& notes);

} // namespace stltsa::results
