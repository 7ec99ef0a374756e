// SPDX-License-Identifier: BSD-3-Clause
// A recording divided where its behavior changes, with the cycles of each part.
#pragma once

#include <vector>

#include "motion/behaviors/behaviors.hpp"
#include "motion/cycles/stretch_cycles.hpp"

namespace stltsa::motion {

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
    std::int64_t more = 0;                    ///< borders to add to those that are found
};

/// Each hole is a part without cycles, so that the rows on one side of it get the result that they
/// would get alone.
std::vector<Part> divide(const Signal& signal, const Borders& borders, const StillRows& still,
                         const PeriodRange& periods);

} // namespace stltsa::motion
