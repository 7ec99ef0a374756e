// SPDX-License-Identifier: BSD-3-Clause
// The phase of every frame of a clip.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/names.hpp"
#include "base/warning.hpp"
#include "clip/features/frame_features.hpp"
#include "phase/phases.hpp"
#include "phase/resample.hpp"
#include "results/decomposed.hpp"

namespace stltsa::results {

/// A motion of the clip that repeats: in cycles, or with pauses.
struct PhasedMotion {
    std::int64_t label = 0;
    phase::Phases phases;                ///< in rows of Phased
    std::vector<phase::Borders> borders; ///< of each run, as the decomposition has them
    bool like_halves = false;            ///< whether the halves of all cycles are the same motion
};

struct Phased {
    explicit Phased(std::shared_ptr<const FrameRows> from) : of(std::move(from)) {}

    std::shared_ptr<const FrameRows> of;
    const Matrix& rows = of->rows;
    const ClipFacts& clip = of->clip;
    const SampleFacts& samples = of->samples;
    const std::vector<std::string>& owners = of->owners;
    std::vector<PhasedMotion> motions; ///< in cycles, by label; then those with pauses
    std::vector<motion::Range> moving; ///< rows between rests and holes
    // Of each frame of the file.
    std::vector<double> phase;       ///< in [0, 1); NaN outside cycles
    std::vector<double> residual;    ///< NaN outside cycles
    std::vector<std::int64_t> cycle; ///< -1 outside cycles
    Warnings warnings;
};

/// Rows around a run that no hole interrupts.
motion::Range unbroken(const Phased& phased, const motion::Run& run);

/// The motion of a label: the cyclic one if there is one. Throws Status::argument for a label that
/// has neither cycles nor repetitions.
const PhasedMotion& motion_of(const Phased& phased, std::int64_t label);

/// The cyclic motion with the most frames, of all or of a label; null: there is none.
const PhasedMotion* longest_in_cycles(const Phased& phased,
                                      std::optional<std::int64_t> label = std::nullopt);

/// Why left and right of the motion cannot be compared; empty if they can: its halves are alike.
std::string no_halves(const PhasedMotion& motion);

/// For each cycle, the rows at which the phase passes `samples` evenly spaced values from border to
/// border. `shift`: see phase::times_of(). A cycle that ends after the last row goes on at its
/// beginning; a repetition does not.
phase::Turns turns_of(const Phased& phased, const PhasedMotion& motion, std::int64_t samples,
                      double shift = 0);

/// Signals on 0 to 100 % of the cycles or repetitions of a motion, a row for each frame of the
/// file. Throws
/// Status::argument for a label without them.
phase::Resampled resample(const Phased& phased, std::int64_t label, ConstMatrixView signals,
                          std::int64_t samples);

/// Found by the first call; any number of threads may call.
std::shared_ptr<const Phased> phase_of(const Decomposed& decomposed);

} // namespace stltsa::results
