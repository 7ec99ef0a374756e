// SPDX-License-Identifier: BSD-3-Clause
// The cycles of a stretch that repeats: whole turns of its phase. They begin in the posture of
// rest if the motion passes through it, or else where the STLTSA coordinate is steepest between a
// peak and a valley (paper, section 3.1).
#pragma once

#include <string>
#include <vector>

#include "motion/cycles/growth.hpp"
#include "motion/cycles/phase_curve.hpp"

namespace stltsa::motion {

/// [begin, end), not rounded.
struct Interval {
    double begin = 0;
    double end = 0;

    double length() const { return end - begin; }
};

/// Where the feet strike the ground, in ascending order: cycles begin with one side.
struct Strikes {
    int label = -1; ///< of the motion
    int side = -1;  ///< with which cycles begin, 0 or 1; -1: unknown
    std::vector<double> begins;
    std::vector<double> middles; ///< of the other side; empty: unknown
};

struct CyclicStretch {
    Stretch stretch;
    Growth growth;
    PhaseCurve phase;
    std::vector<double> borders; ///< rows: cycle i lasts from border i to i + 1
    bool from_rest = false; ///< the first border is where the motion leaves its posture of rest
    bool to_rest = false;   ///< the last one is where it is back
    std::vector<double> confidences; ///< of the cycles
    std::string doubt;               ///< why no cycle is claimed; empty if cycles are
    bool at_strikes = false;         ///< the borders are foot strikes
    int side = -1;                   ///< of the foot that strikes there; -1: unknown
    std::vector<double> middles;     ///< where the other one does, in each cycle; empty: unknown

    bool claimed() const { return doubt.empty(); }
    std::vector<Interval> cycles() const;
    double period() const; ///< median length of the cycles, rows
};

/// Whether two neighbors may be of one motion: the nearest cycles of both are about as long, and
/// the mean cycles alike, whatever the phase at which they begin.
bool may_follow(const CyclicStretch& before, const CyclicStretch& after);

/// Where the body keeps still: at all, and between motions (find_rests(), find_pauses()).
struct StillRows {
    const std::vector<Rows>& rests;
    const std::vector<Rows>& pauses;
    const std::vector<Rows>& holes; ///< parts of both, in which nobody knows whether it does;
                                    ///< ascending and disjoint
};

/// The cycles of the stretch, which may grow to the rows `within` of its part.
CyclicStretch cut_stretch(const Signal& signal, const Stretch& stretch, Rows part, Rows within,
                          const StillRows& still);

/// Lets the cycles begin at the strikes within the rows, where the motion repeats. False, and
/// nothing changes, if the strikes are not one turn apart, or no sure cycle lies between two.
bool begin_at_strikes(const Signal& signal, const Strikes& strikes, Interval within,
                      const StillRows& still, CyclicStretch& cut);

} // namespace stltsa::motion
