// SPDX-License-Identifier: BSD-3-Clause
// An event that is marked once or a few times, found wherever the phase comes round again.
#pragma once

#include <span>
#include <vector>

#include "phase/fine.hpp"
#include "phase/phases.hpp"

namespace stltsa::phase {

/// A motion in which events are looked for.
struct Searched {
    MeanCycle mean;
    std::vector<Run> runs;                     ///< may go beyond the cycles
    std::vector<std::vector<double>> distance; ///< of each run: residuals(), smoothed
    double usual_distance = 0;                 ///< median within cycles
    double rate = 0;                           ///< rows per second
    bool cyclic = true;                        ///< see Phases
    FineRows fine;
};

/// `runs`: the runs of the phases, continued beyond the cycles where the motion goes on.
Searched searched(ConstMatrixView rows, double rate, const Phases& phases, std::vector<Run> runs);

struct Event {
    double row = 0;      ///< not rounded
    double error_ms = 0; ///< a guess of the size of its error
};

/// The event at `marks` (rows, not rounded) of a motion, in every cycle of it, in order of time.
/// The mean of three places: where the phase comes round, where velocity and acceleration are like
/// those around the marks, and where they are like those of the other cycles at that place. At
/// least one mark lies within a run.
std::vector<Event> find_events(const Searched& in, std::span<const double> marks);

/// The same in another motion with the same features.
std::vector<Event> find_events(const Searched& from, std::span<const double> marks,
                               const Searched& in);

/// Correlation of the mean cycles at the best shift.
double likeness(const Searched& from, const Searched& in);

} // namespace stltsa::phase
