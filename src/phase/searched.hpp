// SPDX-License-Identifier: BSD-3-Clause
// A motion in which events are looked for, and where marks lie in it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "phase/fine.hpp"
#include "phase/phases.hpp"

namespace stltsa::phase {

/// Farther than this from the mean cycle, as a share of the deviation of the motion, it is another
/// motion, such as the start of a walk, and has no event. Live, other motions are told by 0.65.
inline constexpr double other_motion = 0.8;

struct Searched {
    MeanCycle mean;
    std::vector<Run> runs;                     ///< may go beyond the cycles
    std::vector<Range> known;                  ///< of each run, the rows within cycles
    std::vector<std::vector<double>> distance; ///< of each run: residuals(), smoothed
    double usual_distance = 0;                 ///< median within cycles
    double rate = 0;                           ///< rows per second
    bool cyclic = true;                        ///< see Phases
    FineRows fine;
};

/// `both`: pose_and_velocity() of the rows. `runs`: those of the phases, one for one, continued
/// beyond the cycles where the motion goes on.
Searched searched(ConstMatrixView rows, ConstMatrixView both, double rate, const Phases& phases,
                  std::vector<Run> runs);

/// A value at a place between indices, which is clamped to them.
double interpolated(const std::vector<double>& values, double place);

/// A distance from the mean cycle in units of the usual one, at least 1.
double remoteness(const Searched& in, double distance);

/// The distance of a row from a range; 0 within the range.
double rows_beyond(Range range, double row);

/// A mark within a run.
struct Mark {
    double row = 0; ///< not rounded
    double phase = 0;
    double distance = 0;
    double beyond = 0; ///< rows outside cycles
};

std::optional<Mark> mark_at(const Searched& in, double row);

/// Marks at one place of the cycle, by phase, which is counted on beyond 1.
using Place = std::vector<Mark>;

/// Sorts marks by their place in the cycle or repetition: those of one place scatter, between
/// places are gaps. Throws Status::argument for marks that are spread over so much of a cycle that
/// they have no place.
std::vector<Place> places_of(const Searched& in, std::vector<Mark> marks);

} // namespace stltsa::phase
