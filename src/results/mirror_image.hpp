// SPDX-License-Identifier: BSD-3-Clause
// Features of the mirror image of a clip whose phase is known.
#pragma once

#include "results/phased.hpp"

namespace stltsa::results {

/// Throws Status::argument if the clip is not that of the phase, as far as the number of frames,
/// the frame rate and the names of the features tell.
void check_same_clip(const clip::Clip& clip, const FrameRows& rows);

/// The features, a row for each frame of the file, NaN for those that were dropped.
Matrix rows_by_frame(const Phased& phased);

/// The same for the mirror image: columns of the left side have what the right side does. Points
/// are turned about the up axis so that the sides differ least over the cycles of the label.
/// `clip`: that of the phase. `prepare`: as for the decomposition. Throws Status::argument if the
/// label has no cycles, and Status::unsupported for a clip that has no mirror image.
Matrix mirror_image(const clip::Clip& clip, const Phased& phased, std::int64_t label,
                    std::int64_t samples, const clip::PrepareOptions& prepare);

} // namespace stltsa::results
