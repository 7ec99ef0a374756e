// SPDX-License-Identifier: BSD-3-Clause
// The cycles of two motions, aligned by phase.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "phase/compare.hpp"
#include "results/compared_columns.hpp"

namespace stltsa::results {

/// One of the two motions.
struct ComparedMotion {
    ClipFacts clip;
    std::int64_t label = 0;
    std::int64_t cycles = 0; ///< compared: those that the clip has completely
    Matrix mean, deviation;  ///< samples x columns
};

/// Where the parts are, for pictures.
struct Placement {
    bool in_space = false; ///< whether columns are coordinates in space
    bool skeleton = false; ///< whose root is at the origin
    clip::Axis up = clip::Axis::none;
    std::vector<std::int64_t> parents; ///< of each part the next of its ancestors; -1: none
};

/// Unknown numbers are NaN.
struct Comparison {
    std::array<ComparedMotion, 2> motions;
    clip::Features features = clip::Features::raw;
    std::int64_t samples = 0;
    bool sides = false; ///< of one clip: the second motion is its mirror image, half a cycle later
    CommonColumns columns;
    Placement placement;   ///< of the first
    phase::Estimate shift; ///< phase of the second at phase 0 of the first; only difference, error
                           ///< and interval
    double likeness = 0;   ///< correlation of the mean cycles once aligned
    double runner_up = 0;  ///< the same at the next best shift; NaN: there is none
    double turn = 0;       ///< degrees by which the second was turned about the up axis
    double size_ratio = 0; ///< size of the second body divided by that of the first
    phase::Estimate cycle_time; ///< seconds
    phase::Differences differences;
    std::int64_t judged = 0, significant = 0; ///< lags and amplitudes of parts with an interval
    Warnings warnings;
};

/// The mean of both cycle times, in seconds.
double mean_cycle_time(const Comparison& of);

/// How many differences would be significant by chance if there were none.
double expected_by_chance(const Comparison& of);

/// `label`: of a cyclic motion. Empty: in the first clip the one with the most frames, in the
/// second the one most like it. Throws Status::no_such_part for a clip without cycles,
/// Status::argument for a label without cycles, and Status::shape if the clips have nothing in
/// common.
Comparison compare(const Phased& first, std::optional<std::int64_t> label, const Phased& second,
                   std::optional<std::int64_t> other_label, std::int64_t samples);

/// The left side against the right one, mirrored and half a cycle later: the second half of each
/// cycle, then its first, so that both sides have all cycles. Throws Status::unsupported if the
/// sides cannot be compared.
Comparison compare_left_right(const clip::Clip& clip, const Phased& phased,
                              std::optional<std::int64_t> label, std::int64_t samples,
                              const clip::PrepareOptions& prepare);

/// The same of signals whose names differ only in the side, such as knee_l and knee_r. `names`: one
/// for each column. `fps`: 0 if it is unknown.
Comparison compare_left_right(const phase::Resampled& cycles, std::span<const std::string> names,
                              double fps);

} // namespace stltsa::results
