// SPDX-License-Identifier: BSD-3-Clause
// The phase of every frame of a clip.
#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "clip/features/frame_features.hpp"
#include "phase/phases.hpp"
#include "phase/resample.hpp"
#include "results/decomposed.hpp"

namespace stltsa::results {

/// A motion of the clip that repeats: in cycles, or with pauses.
struct PhasedMotion {
    std::int32_t label = 0;
    phase::Phases phases; ///< in rows of Phased
    /// The runs, continued by a quarter of a cycle on each side as far as there are rows: the first
    /// and last turn end there.
    std::vector<phase::Run> reach;
    std::vector<std::int64_t> cycles; ///< of each run, the number of its cycles; 1: a repetition
    bool like_halves = false;         ///< whether the halves of all cycles are the same motion
};

struct Phased {
    ClipFacts clip;
    clip::Body body;     ///< what features of single frames need; it has learned nothing
    SampleFacts samples; ///< the features; every frame from the first one on is a row
    Matrix rows;         ///< features, not smoothed
    std::vector<std::int64_t> drifting; ///< columns whose slow part was subtracted
    std::vector<double> side;           ///< see phase::find_phases()
    std::vector<PhasedMotion> motions;  ///< in cycles, by label; then those with pauses
    std::vector<phase::Range> moving;   ///< rows between rests and holes
    std::vector<std::string> owners;    ///< of each column, its joint or point
    std::vector<phase::Range> holes;    ///< rows that no motion goes across
    // Of each frame of the file.
    std::vector<double> phase;       ///< in [0, 1); NaN outside cycles
    std::vector<double> residual;    ///< NaN outside cycles
    std::vector<std::int64_t> cycle; ///< -1 outside cycles
    std::vector<std::string> warnings;
};

/// Rows around a run that no hole interrupts.
phase::Range unbroken(const Phased& phased, const phase::Run& run);

/// The motion of a label: the cyclic one if there is one. Throws Status::argument for a label that
/// has neither cycles nor repetitions.
const PhasedMotion& motion_of(const Phased& phased, std::int32_t label);

/// Why left and right of the motion cannot be compared; empty if they can: its halves are alike.
std::string no_halves(const PhasedMotion& motion);

/// For each cycle, the rows at which the phase passes `samples` evenly spaced values, from the
/// `zero` that is nearest to its begin to the next one. NaN beyond the reach of its run; but a
/// single cycle (not a repetition) that would begin or end with NaN is closed.
phase::Turns turns_of(const PhasedMotion& motion, std::int64_t samples, double zero = 0);

/// "A" for 0.
std::string label_text(std::int32_t label);

/// Signals on 0 to 100 % of the cycles or repetitions of a motion, a row for each frame of the
/// file. What the clip does not reach is NaN. `poll`: called periodically, may throw. Throws
/// Status::argument for a label without them.
phase::Resampled resample(const Phased& phased, std::int32_t label, ConstMatrixView signals,
                          std::int64_t samples, const std::function<void()>& poll = {});

/// `prepare`: as for the decomposition. Throws Status::argument if the decomposition is not of the
/// clip.
Phased find_phase(const clip::Clip& clip, const Decomposed& decomposed,
                  clip::PrepareOptions prepare, const Progress& progress);

} // namespace stltsa::results
