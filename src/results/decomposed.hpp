// SPDX-License-Identifier: BSD-3-Clause
// A decomposition in frames and seconds of the source file.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "clip/features/frame_features.hpp"
#include "motion/recording/analyze.hpp"
#include "results/samples.hpp"
#include "results/summary.hpp"
#include "results/texts.hpp"
#include "stltsa.h"

namespace stltsa::results {

struct Phased;

/// What the phase of every frame is found from.
struct FrameRows {
    Matrix rows;         ///< features of every frame from the first one on, not smoothed
    ClipFacts clip;      ///< every frame is a row
    SampleFacts samples; ///< kind of the features
    clip::Body body;     ///< what features of single frames need; it has learned nothing
    std::vector<std::int64_t> drifting; ///< columns whose slow part was subtracted
    std::vector<double> side;           ///< see phase::find_phases()
    std::vector<std::string> owners;    ///< of each column, its joint or point
    std::vector<clip::Frames> holes;    ///< rows that no motion goes across
};

/// The phase, once it is found: see phase_of().
struct PhaseOnce {
    std::mutex mutex;
    std::shared_ptr<const Phased> found;
};

struct Decomposed {
    motion::Curve curve;                         ///< in samples
    std::int64_t representative = -1, best = -1; ///< see Recording
    std::string reason;
    Warnings warnings;
    Source source;
    // In frames of the source file.
    std::vector<stltsa_segment> segments; ///< cover the file, as the units do
    std::vector<stltsa_unit> units;
    std::vector<stltsa_part> cycles, steps, repetitions;
    std::vector<stltsa_summary> summaries; ///< by label, of labels that repeat
    Texts texts;                           ///< that these point to
    Matrix label_likeness;                 ///< see motion::Recording
    Side side_one = Side::neither;         ///< the side that is 1 in cycles and steps
    std::vector<std::int64_t> postures;    ///< frames for pictures: see telling_postures()
    std::shared_ptr<const FrameRows> rows;
    std::shared_ptr<PhaseOnce> phase = std::make_shared<PhaseOnce>();

    /// Whether side 0 or 1 of cycles and steps is left or right.
    Side named_side(std::int64_t side) const;
    /// Of STLTSA_INFO_CYCLE, _STEP or _REPETITION; none of another.
    std::span<const stltsa_part> parts(std::int32_t kind) const;
};

/// Throws Status::argument if the clip's frame rate is unknown. Sets the fields of `options` that
/// are for messages only.
Decomposed decompose(const clip::Clip& clip, const clip::PrepareOptions& prepare,
                     motion::Options options);

} // namespace stltsa::results
