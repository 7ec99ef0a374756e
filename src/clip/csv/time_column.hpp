// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Removes columns of times and frame numbers, which are not channels, by their names:
/// - "time", "t", "time (ms)" and the like, if increasing: gives fps. Rows at uneven
///   steps are resampled unless option fps is set. A column that gives an implausible rate is not
///   time.
/// - "frame", "index" and the like, or a first column without a name, if it counts by one.
/// Notes say which columns are removed, and which are kept despite their names.
void extract_time(Clip& clip, const std::string& name, const ReadOptions& options);

} // namespace stltsa::clip
