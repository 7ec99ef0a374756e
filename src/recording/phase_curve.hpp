// SPDX-License-Identifier: BSD-3-Clause
// One continuous coordinate of a stretch that repeats: STLTSA in chunks of some periods, after time
// has been warped so that every period has as many samples. Over hundreds of periods a single
// embedding shows only the passage of time. Each chunk's most cyclic coordinates are turned so that
// they continue those before.
#pragma once

#include <optional>
#include <vector>

#include "recording/period_track.hpp"
#include "recording/row_progress.hpp"

namespace stltsa::recording {

/// Samples per period in warped time.
constexpr std::int64_t samples_per_period = 24;

/// A linear map from poses to the coordinate: keeps phase and sign the same from chunk to chunk.
struct Anchor {
    std::vector<double> mean;
    std::vector<double> weights;
    bool high_pass = false; ///< the map is for poses less their slow part
};

struct PhaseCurve {
    std::vector<double> places; ///< row of each warped sample, increasing
    std::vector<double> curve;  ///< the coordinate at each of them
    /// A second coordinate, a quarter of a period behind; the two form a loop.
    std::vector<double> partner;
    std::vector<double> cyclicity; ///< of each chunk, at most 1
    Anchor anchor;                 ///< learned on this stretch

    double typical_cyclicity() const; ///< 0 for a curve that is too short
};

/// The curve a quarter of a period earlier; in the first quarter, the negated curve half a period
/// later.
std::vector<double> earlier_curve(const std::vector<double>& curve, std::size_t quarter);

/// `like`: the anchor of an earlier stretch of the same motion; the curve begins with its phase and
/// sign if it can.
PhaseCurve trace_phase(const Signal& signal, const Stretch& stretch, const Anchor* like,
                       RowProgress& progress);

} // namespace stltsa::recording
