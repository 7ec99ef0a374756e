// SPDX-License-Identifier: BSD-3-Clause
// From clips to the working samples that are fitted or decomposed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "clip/features/prepare.hpp"
#include "results/facts.hpp"

namespace stltsa::results {

using Clips = std::span<const clip::Clip* const>;

/// Working samples of clips, one clip after the other, and where they come from.
struct ClipSamples {
    Matrix samples;
    std::vector<std::int64_t> lengths; ///< samples of each clip
    Source source;
    std::int64_t jump = 0; ///< of a single clip: see clip::Prepared
};

/// Of at least one clip. Throws Status::shape for clips that do not go together: other joints or
/// channels than the first one's, other features, another rate of the samples. The axis that points
/// up is the first one's.
ClipSamples prepare_clips(Clips clips, clip::PrepareOptions options, const Progress& progress);

/// The source of a matrix: no clip. fps 0: unknown.
Source matrix_source(ConstMatrixView frames, double fps);

} // namespace stltsa::results
