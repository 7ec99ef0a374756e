// SPDX-License-Identifier: BSD-3-Clause
// What stands behind the opaque handles of stltsa.h.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "capi/info.hpp"
#include "capi/json.hpp"
#include "capi/json_synthesis.hpp"
#include "clip/clip.hpp"
#include "clip/pose_code.hpp"
#include "ltsa/dimension.hpp"
#include "ltsa/mapping.hpp"
#include "ltsa/model.hpp"
#include "motion/decompose.hpp"
#include "stltsa.h"

namespace stltsa::capi {

/// How a result's rows lie in the source, and what its neighbors rest on.
struct Source {
    std::vector<ClipFacts> clips; ///< none: a matrix
    SampleFacts samples;
    PeriodFacts period;

    const ClipFacts* clip_or_null() const { return clips.size() == 1 ? clips.data() : nullptr; }
};

/// What a model keeps of its source so that it can map.
struct Kept {
    Matrix frames;          ///< as they were fitted, a row of the model each; empty: cannot map
    bool drop_tpose = true; ///< of clips that are mapped, as it was of the one that was fitted
    bool has_poses = false; ///< fitted to a clip with a skeleton: the next two are there
    clip::PoseCode code;
    Matrix poses; ///< pose vectors, a row of the model each
};

/// A copy of a text that the caller frees with stltsa_free.
char* caller_string(const std::string& text);

} // namespace stltsa::capi

struct stltsa_clip : stltsa_info {
    explicit stltsa_clip(stltsa::clip::Clip of = {})
        : stltsa_info{&stltsa::capi::clip_table}, clip(std::move(of)) {}

    stltsa::clip::Clip clip;
};

struct stltsa_model : stltsa_info {
    stltsa_model() : stltsa_info{&stltsa::capi::model_table} {}

    stltsa::ltsa::Model model;
    stltsa::capi::Source source;
    stltsa::capi::Kept kept;
    /// Follows from the rest and looks into it: capi::mapping_of() makes it, as many models are
    /// never asked to map.
    mutable std::once_flag mapping_asked;
    mutable std::optional<stltsa::ltsa::Mapping> mapping;
};

struct stltsa_dimension : stltsa_info {
    stltsa_dimension() : stltsa_info{&stltsa::capi::dimension_table} {}

    stltsa::ltsa::Dimension dimension;
    stltsa::capi::Source source;
};

struct stltsa_decomposition : stltsa_info {
    stltsa_decomposition() : stltsa_info{&stltsa::capi::decomposition_table} {}

    stltsa::motion::Decomposition result;
    stltsa::capi::Source source;
    std::vector<stltsa_interval> units;
    std::vector<stltsa_interval> cycles;
};

struct stltsa_denoising : stltsa_info {
    stltsa_denoising() : stltsa_info{&stltsa::capi::denoising_table} {}

    stltsa::motion::Denoised result;
    stltsa::motion::DenoiseOptions options; ///< as used
    std::vector<std::int64_t> lengths;      ///< rows that each spline goes through
    stltsa::capi::Source source;
    stltsa::capi::PeriodFacts period;            ///< that the knots rest on
    std::optional<stltsa::ltsa::Parameters> fit; ///< none: the coordinates were given
    stltsa::Warnings warnings;                   ///< of that fit
};

struct stltsa_synthesis : stltsa_info {
    stltsa_synthesis() : stltsa_info{&stltsa::capi::synthesis_table} {}

    stltsa::synthesis::Synthesis result; ///< without its clip, which is the next member
    stltsa_clip clip;
    stltsa::synthesis::Options options;
    std::vector<stltsa::capi::PieceFacts> pieces;
};
