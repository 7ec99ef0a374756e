// SPDX-License-Identifier: BSD-3-Clause
// Left against right over a cycle.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "phase/halves.hpp"
#include "results/phased.hpp"

namespace stltsa::results {

/// A signal of the left side and the corresponding one of the right side.
struct SidePair {
    std::int64_t left = 0, right = 0; ///< columns
    std::string left_name, right_name;
    /// Over 0 to 100 % of the cycle; the right curve is shifted by half a cycle.
    std::vector<double> left_curve, right_curve;
    phase::CurveDifference difference;
};

/// A column of the left side and the corresponding one of the right side.
struct SideColumns {
    std::size_t left = 0, right = 0;
};

/// By names that differ only in the side. Columns with the same name, such as the coordinates of a
/// joint, are distinguished by their order.
std::vector<SideColumns> side_columns(std::span<const std::string> names);

struct ComparedSides {
    std::vector<SidePair> pairs; ///< in the order of the left columns
    std::int64_t samples = 0;
    std::string reason; ///< the reason if there are no pairs
};

/// Compares signals whose names differ only in the side, such as knee_l and knee_r.
ComparedSides compare_sides(const phase::Resampled& cycles, std::span<const std::string> names);

/// Compares the features of a motion of the clip that the phase was found in: the left side with
/// the mirror image of the right side. `prepare`: as for the decomposition. Throws
/// Status::argument for a label without cycles or repetitions.
ComparedSides compare_sides(const clip::Clip& clip, const Phased& phased, std::int32_t label,
                            std::int64_t samples, const clip::PrepareOptions& prepare,
                            const Progress& progress);

} // namespace stltsa::results
