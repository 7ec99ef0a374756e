// SPDX-License-Identifier: BSD-3-Clause
// Where the motion repeats, and its period there, which may change over time.
#pragma once

#include <string>
#include <vector>

#include "motion/period/signal.hpp"

namespace stltsa::motion {

/// Turns that must be seen for the motion to repeat.
constexpr double min_turns = 1.4;

struct PeriodRange {
    double shortest_s = 0.3;
    double longest_s = 6;
};

/// Rows in which the motion repeats.
struct Stretch {
    Rows rows;
    std::vector<double> period; ///< rows, for each of the rows
    double quality = 0;         ///< median match one period apart, at most 1
    /// The lag that was not chosen, in rows: that of turns within the period, or a longer one that
    /// the turns share; 0: there is none.
    double other_period = 0;

    /// That of the nearest row.
    double period_at(double row) const;
};

struct PeriodTrack {
    std::vector<Stretch> stretches;
    /// The best match of any lag and that lag in seconds, for messages; 0: the range is too short.
    double best_match = 0;
    double best_lag_s = 0;
};

PeriodTrack track_period(const Signal& signal, Rows range, const PeriodRange& periods);

} // namespace stltsa::motion
