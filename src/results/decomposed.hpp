// SPDX-License-Identifier: BSD-3-Clause
// A decomposition in frames and seconds of the source file.
#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "recording/analyze.hpp"
#include "results/samples.hpp"
#include "results/summary.hpp"
#include "stltsa.h"

namespace stltsa::results {

struct Decomposed {
    recording::Curve curve; ///< in samples
    std::int64_t representative = -1, best = -1; ///< see Recording
    std::string reason;
    Warnings warnings;
    Source source;
    // In frames of the source file.
    std::vector<stltsa_segment> segments;           ///< cover the file, as the units do
    std::vector<std::vector<std::string>> carriers; ///< of each segment, what moves most first
    std::vector<std::string> reasons;               ///< of each segment; empty: it repeats
    std::vector<stltsa_interval> units;
    std::vector<std::int64_t> postures; ///< frames for pictures: see telling_postures()
    std::vector<stltsa_interval> cycles;
    std::vector<stltsa_part> cycle_parts;
    std::vector<stltsa_part> steps;
    std::vector<stltsa_part> repetitions;
    std::vector<stltsa_travel> cycle_travels, step_travels, repetition_travels;
    std::vector<stltsa_summary> summaries; ///< by label, of labels that repeat

    Parts parts(std::int32_t kind) const; ///< STLTSA_PART_*; none of an unknown kind
};

/// Throws Status::argument if the clip's frame rate is unknown. Sets the fields of `options` that
/// are for messages only.
Decomposed decompose(const clip::Clip& clip, const clip::PrepareOptions& prepare,
                     recording::Options options, const Progress& progress);

} // namespace stltsa::results
