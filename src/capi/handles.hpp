// SPDX-License-Identifier: BSD-3-Clause
// The opaque handles of stltsa.h.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/names.hpp"
#include "capi/info/info.hpp"
#include "ltsa/mapping/mapping.hpp"
#include "results/compared.hpp"
#include "results/decomposed.hpp"
#include "results/denoised.hpp"
#include "results/events.hpp"
#include "results/fitted.hpp"
#include "results/phased.hpp"
#include "results/synthesized.hpp"
#include "stltsa.h"

namespace stltsa::capi {

using namespace results;

class OptionsReader;

/// The mapping of the model; null if it kept no frames. Made by the first call, because many models
/// never map.
const ltsa::Mapping* mapping_of(const stltsa_model& model);

/// The clips that a caller passes. Throws Status::argument for none, and for NULL.
std::vector<const clip::Clip*> clips_of(const stltsa_clip* const* clips, std::int64_t count);

/// The clip at a path, or the stretch of it that follows the path.
std::unique_ptr<stltsa_clip> read_path(const std::string& text, const OptionsReader& reader,
                                       clip::Clip (*read)(const std::string& path,
                                                          const clip::ReadOptions&) = clip::read);

/// Throws Status::argument for a rate that no clip may have.
void check_rate(double fps);

/// "tx ty tz rz rx ry" for each joint; none if the skeleton is of an ASF file.
std::vector<std::string> channel_texts(const clip::Clip& clip);

} // namespace stltsa::capi

struct stltsa_clip : stltsa_info {
    explicit stltsa_clip(stltsa::clip::Clip of = {})
        : stltsa_info{&stltsa::capi::clip_table}, clip(std::move(of)),
          channels(stltsa::capi::channel_texts(clip)) {}

    stltsa::clip::Clip clip;
    std::string stretch = {}; ///< of the file at the path, as typed; empty: all, or unknown
    std::vector<stltsa::clip::Frames> pieces = {}; ///< its frames there; empty: all
    std::vector<std::string> channels;             ///< of stltsa_joint, for each joint
};

struct stltsa_model : stltsa_info, stltsa::results::Fitted {
    explicit stltsa_model(Fitted of)
        : stltsa_info{&stltsa::capi::model_table}, Fitted(std::move(of)) {}

    mutable std::mutex mapping_mutex; ///< guards `mapping`
    // Refers to the other members: see capi::mapping_of().
    mutable std::optional<stltsa::ltsa::Mapping> mapping;
};

struct stltsa_decomposition : stltsa_info, stltsa::results::Decomposed {
    explicit stltsa_decomposition(Decomposed of)
        : stltsa_info{&stltsa::capi::decomposition_table}, Decomposed(std::move(of)) {}
};

/// Shares the phase with its decomposition.
struct stltsa_phase : stltsa_info {
    explicit stltsa_phase(std::shared_ptr<const stltsa::results::Phased> of)
        : stltsa_info{&stltsa::capi::phase_table}, found(std::move(of)) {}

    std::shared_ptr<const stltsa::results::Phased> found;

    operator const stltsa::results::Phased&() const { return *found; }
};

struct stltsa_cycles : stltsa_info, stltsa::phase::Resampled {
    explicit stltsa_cycles(Resampled of)
        : stltsa_info{&stltsa::capi::cycles_table}, Resampled(std::move(of)) {}
};

struct stltsa_comparison : stltsa_info, stltsa::results::Comparison {
    explicit stltsa_comparison(Comparison of)
        : stltsa_info{&stltsa::capi::comparison_table},
          Comparison(std::move(of)), left_out{texts.keep(columns.left_out),
                                              texts.keep(columns.other_left_out)},
          letters{stltsa::letters_of(motions[0].label), stltsa::letters_of(motions[1].label)} {}

    stltsa::results::Texts texts;   ///< that the next ones are
    const char* const* left_out[2]; ///< names that the other motion lacks
    std::string letters[2];
};

struct stltsa_events : stltsa_info, stltsa::results::FoundEvents {
    explicit stltsa_events(FoundEvents of)
        : stltsa_info{&stltsa::capi::events_table}, FoundEvents(std::move(of)) {}
};

struct stltsa_live : stltsa_info {
    std::vector<std::string> names; ///< of the marks
    stltsa::clip::FrameFeatures features;
    stltsa::phase::LivePhase phase;
    // Room for one frame.
    std::vector<double> row;    ///< features
    std::vector<double> values; ///< as they come
    std::vector<double> unsure; ///< confidence of each point
    std::vector<stltsa::clip::Quaternion> local;

    stltsa_live(std::vector<std::string> of, stltsa::clip::FrameFeatures frames,
                stltsa::phase::LivePhase follows)
        : stltsa_info{&stltsa::capi::live_table}, names(std::move(of)), features(std::move(frames)),
          phase(std::move(follows)), row(static_cast<std::size_t>(features.features())) {
        std::size_t joints = 0;
        if (features.has_skeleton())
            joints = features.skeleton().joints.size();
        // A frame comes as values of the file, or as quaternions or matrices.
        values.resize(std::max(static_cast<std::size_t>(features.values()), 9 * joints));
        local.resize(joints);
        if (features.space() > 0)
            unsure.resize(values.size() / static_cast<std::size_t>(features.space()));
    }
};

struct stltsa_denoising : stltsa_info, stltsa::results::Denoised {
    explicit stltsa_denoising(Denoised of)
        : stltsa_info{&stltsa::capi::denoising_table}, Denoised(std::move(of)) {}
};

struct stltsa_synthesis : stltsa_info, stltsa::results::Synthesized {
    explicit stltsa_synthesis(Synthesized of)
        : stltsa_info{&stltsa::capi::synthesis_table}, Synthesized(std::move(of)),
          clip(std::move(result.clip)) {}

    stltsa_clip clip; ///< moved out of the result
};
