// SPDX-License-Identifier: BSD-3-Clause
// From what a caller gives (a matrix or a clip, and options) to what the rooms below take.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "capi/handles.hpp"
#include "capi/options.hpp"

namespace stltsa::capi {

/// Where a matrix comes from: no clip, rate from option fps.
Source matrix_source(ConstMatrixView frames, const OptionsReader& options);

/// Working samples of clips, one clip after the other, and where they come from.
struct ClipSamples {
    Matrix samples;
    std::vector<std::int64_t> lengths; ///< samples of each clip
    Source source;
    std::int64_t jump = 0; ///< of a single clip: see clip::Prepared
};

/// Throws Status::shape for clips that do not go together: other joints or channels than the first
/// one's, other features, another rate of the samples. The axis that points up is the first one's.
ClipSamples prepare_clips(std::span<const stltsa_clip* const> clips, const OptionsReader& options);

/// The clips that a caller passes. Throws Status::argument for none, and for NULL.
std::span<const stltsa_clip* const> clips_of(const stltsa_clip* const* clips, std::int64_t count);

/// The parameters with every "0: choose" decided from the samples. Fills source.period.
/// `standard_dimension`: what dimension 0 means here.
ltsa::Parameters choose_parameters(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                                   const OptionsReader& options, int standard_dimension,
                                   Source& source);

} // namespace stltsa::capi
