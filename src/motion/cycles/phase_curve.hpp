// SPDX-License-Identifier: BSD-3-Clause
// One continuous coordinate of a stretch that repeats: STLTSA in chunks of some periods, at evenly
// spaced phases, so that every period has as many samples. Over hundreds of periods a single
// embedding shows only the passage of time. Each chunk's most cyclic coordinates are turned so that
// they continue those before.
#pragma once

#include <vector>

#include "ltsa/model.hpp"
#include "motion/cycles/growth.hpp"
#include "motion/period/signal.hpp"

namespace stltsa::motion {

constexpr std::int64_t samples_per_period = 24;

struct PhaseCurve {
    double first_phase = 0;     ///< of the first sample
    std::vector<double> places; ///< row of each sample, increasing
    std::vector<double> curve;  ///< the coordinate at each of them
    /// A second coordinate, a quarter of a period behind; the two form a loop.
    std::vector<double> partner;
    std::vector<double> cyclicity; ///< of each chunk, at most 1
    ltsa::Model fit;               ///< of the first chunk, without its coordinates
    int coordinate = 0;            ///< of the fit, 1-based: the most cyclic one

    double typical_cyclicity() const; ///< 0 for a curve that is too short
};

/// No samples if the turns are too few.
PhaseCurve trace_phase(const Signal& signal, const Growth& growth);

} // namespace stltsa::motion
