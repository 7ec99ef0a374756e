// SPDX-License-Identifier: BSD-3-Clause
// The cycles of a stretch that repeats, cut where the smoothed coordinate is steepest between its
// peaks and valleys (paper, section 3.1).
#pragma once

#include <string>
#include <vector>

#include "recording/phase_curve.hpp"

namespace stltsa::recording {

/// [begin, end), not rounded.
struct Interval {
    double begin = 0;
    double end = 0;

    double length() const { return end - begin; }
};

struct CyclicStretch {
    Stretch stretch;
    PhaseCurve phase;
    double cyclicity = 0;
    std::vector<std::vector<double>> margins; ///< rows, of each regular sequence of at least three
    std::vector<Interval> cycles;             ///< rows, from margin i to margin i + 2
    std::string doubt;                        ///< why no cycle is claimed; empty if cycles are

    bool claimed() const { return doubt.empty(); }
    double period() const; ///< median length of the cycles, rows
    double first_margin() const { return margins.front().front(); } ///< if claimed
    double last_margin() const { return margins.back().back(); }
};

/// Where the body keeps still: at all, and between motions (find_rests(), find_pauses()).
struct StillRows {
    const std::vector<Rows>& rests;
    const std::vector<Rows>& pauses;
};

/// Whether most of the cycles contain a pause: these are repetitions.
bool paused(const std::vector<Interval>& cycles, const std::vector<Rows>& pauses);

/// `like`: see trace_phase().
CyclicStretch cut_stretch(const Signal& signal, const Stretch& stretch, const StillRows& still,
                          const Anchor* like, RowProgress& progress);

} // namespace stltsa::recording
