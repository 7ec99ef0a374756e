// SPDX-License-Identifier: BSD-3-Clause
// From what a caller gives (a matrix or a clip, and options) to what the rooms below take.
#pragma once

#include <cstdint>
#include <span>

#include "capi/handles.hpp"
#include "capi/options.hpp"

namespace stltsa::capi {

/// Where a matrix comes from: no clip, rate from option fps.
Source matrix_source(ConstMatrixView frames, const OptionsReader& options);

/// A clip's working samples and where they come from.
struct ClipSamples {
    Matrix samples;
    Source source;
    std::int64_t jump = 0; ///< see clip::Prepared
};
ClipSamples prepare_clip(const stltsa_clip& clip, const OptionsReader& options);

/// The parameters with every "0: choose" decided from the samples. Fills source.period.
/// `standard_dimension`: what dimension 0 means here.
ltsa::Parameters choose_parameters(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                                   const OptionsReader& options, int standard_dimension,
                                   Source& source);

} // namespace stltsa::capi
