// SPDX-License-Identifier: BSD-3-Clause
// A recording divided where its behavior changes, with the cycles of each part. Borders within one
// behavior are removed again.
#pragma once

#include <span>
#include <vector>

#include "base/progress.hpp"
#include "recording/behaviors.hpp"
#include "recording/stretch_cycles.hpp"

namespace stltsa::recording {

/// Rows of one behavior.
struct Part {
    Rows rows;
    std::vector<CyclicStretch> stretches; ///< claimed or not
    double best_match = 0;                ///< see PeriodTrack
    double best_lag_s = 0;
    double gain = 0; ///< of its first border, in prices of a border; 0 at a hole or the start
    bool is_hole = false;

    std::vector<Interval> cycles() const; ///< of the claimed stretches
};

/// The borders that divide a recording.
struct Borders {
    const KernelFeatures* features = nullptr; ///< null: not divided by behavior
    /// Price of a border; if it is below border_price, borders within one behavior are kept.
    double price = 0;
    /// In ascending order, disjoint. Each is a separate part without cycles, so that the rows on
    /// one side of a hole get the result that they would get alone.
    std::span<const Rows> holes;
};

std::vector<Part> divide(const Signal& signal, const Borders& borders, const StillRows& still,
                         const PeriodRange& periods, const Progress& progress);

enum class Verdict { same, different, undecided };

/// The mean of cycles at equal phases, less its mean pose.
struct TypicalCycle {
    double length = 0; ///< median, rows; 0: there are fewer than two cycles
    Matrix poses;
    double deviation = 0; ///< mean squared deviation of a cycle
    double swing = 0;     ///< squared extent
};
TypicalCycle typical_cycle(const Signal& signal, const std::vector<Interval>& cycles);

/// Whether the cycles are of one motion, whatever the phase at which they begin.
Verdict compare_cycles(const TypicalCycle& a, const TypicalCycle& b);
Verdict compare_cycles(const Signal& signal, const std::vector<Interval>& a,
                       const std::vector<Interval>& b);

} // namespace stltsa::recording
