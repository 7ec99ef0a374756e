// SPDX-License-Identifier: BSD-3-Clause
// The JSON text of results, one line each, as docs/schema describes it. What does not change the
// result (the number of threads) is left out, so that equal results are equal texts.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features.hpp"
#include "ltsa/dimension.hpp"
#include "ltsa/model.hpp"
#include "motion/decompose.hpp"
#include "motion/denoise.hpp"
#include "stltsa.h"

namespace stltsa::capi {

/// What every result repeats of the clip that it came from.
struct ClipFacts {
    std::string path; ///< empty: from memory
    clip::Format format = clip::Format::matrix;
    std::int64_t frames = 0;
    double fps = 0; ///< 0: unknown
    std::vector<std::string> notes;
    std::int64_t first = 0; ///< row i that comes from it is its frame first + i * step
    std::int64_t step = 1;
};
ClipFacts clip_facts(const clip::Clip& clip);

/// How a clip is read without options: features, the axis that points up (automatic: bare
/// numbers), and the first frame after a T-pose.
clip::Features default_features(const clip::Clip& clip);
clip::Axis default_up(const clip::Clip& clip);
std::int64_t default_first_frame(const clip::Clip& clip);

/// How the frames of a clip became the working samples: sample i is frame first + i * step. Of
/// several clips first and step are the first one's.
struct SampleFacts {
    std::int64_t count = 0;
    std::int64_t first = 0;
    std::int64_t step = 1;
    double fps = 0; ///< of the samples; 0: unknown
    clip::Features features = clip::Features::raw;
    std::int64_t feature_count = 0;
    clip::Axis up = clip::Axis::automatic; ///< automatic: none was needed
    double smoothing = 0;                  ///< seconds
};

/// What the choice of the neighbors rests on.
struct PeriodFacts {
    double period = 0;      ///< seconds; 0: none found
    double lag_quality = 0; ///< 1 - D(period); 0 without a period
    double shortest = 0;    ///< seconds, of the search; 0: no search was made
    double longest = 0;
};

struct ModelFacts {
    const ClipFacts* clip = nullptr; ///< nullptr: fitted to a matrix, or to several clips
    SampleFacts samples;
    PeriodFacts period;
    const ltsa::Model* model = nullptr;
};

struct DimensionFacts {
    const ClipFacts* clip = nullptr; ///< nullptr: of a matrix, or of several clips
    SampleFacts samples;
    PeriodFacts period;
    const ltsa::Dimension* dimension = nullptr;
};

struct DecompositionFacts {
    const ClipFacts* clip = nullptr;
    SampleFacts samples;
    PeriodFacts period; ///< what was found and the range that was searched
    const motion::Decomposition* decomposition = nullptr;
    std::span<const stltsa_interval> units;  ///< in frames of the source file
    std::span<const stltsa_interval> cycles; ///< the same
};

struct DenoisingFacts {
    const ClipFacts* clip = nullptr; ///< nullptr: coordinates without a clip
    SampleFacts samples;
    PeriodFacts period;                    ///< that the knots rest on
    const ltsa::Parameters* fit = nullptr; ///< nullptr: the coordinates were given
    PeriodFacts fit_period;                ///< that its neighbors rest on
    motion::DenoiseOptions options;        ///< as used
    std::span<const std::int64_t> lengths; ///< rows that each spline goes through
    const motion::Denoised* denoised = nullptr;
    std::span<const Warning> warnings; ///< of the fit
};

std::string clip_json(const clip::Clip& clip);
std::string model_json(const ModelFacts& facts);
std::string dimension_json(const DimensionFacts& facts);
std::string decomposition_json(const DecompositionFacts& facts);
std::string denoising_json(const DenoisingFacts& facts);

} // namespace stltsa::capi
