// SPDX-License-Identifier: BSD-3-Clause
// The phase of every frame of a clip.
#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "phase/phases.hpp"
#include "results/decomposed.hpp"

namespace stltsa::results {

/// A motion of the clip that repeats.
struct PhasedMotion {
    std::int32_t label = 0;
    phase::Phases phases; ///< in rows of Phased
};

struct Phased {
    ClipFacts clip;
    SampleFacts samples;               ///< the features; every frame from the first one on is a row
    Matrix rows;                       ///< features, not smoothed
    std::vector<double> side;          ///< see recording::Options
    std::vector<PhasedMotion> motions; ///< by label
    // Of each frame of the file.
    std::vector<double> phase;       ///< in [0, 1); NaN outside cycles
    std::vector<double> residual;    ///< NaN outside cycles
    std::vector<std::int64_t> cycle; ///< -1 outside cycles
    std::vector<std::string> warnings;
};

/// `prepare`: as for the decomposition. Throws Status::argument if the decomposition is not of the
/// clip.
Phased find_phase(const clip::Clip& clip, const Decomposed& decomposed,
                  clip::PrepareOptions prepare, const Progress& progress);

} // namespace stltsa::results
