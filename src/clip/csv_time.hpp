// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Columns that count time or frames are no channels. By the header's names:
/// - "time", "t", "time (ms)" and the like, increasing: gives fps and goes. Uneven steps are an
///   error unless option fps says what to take. One whose rate nobody captures at is no time.
/// - "frame", "index" and the like, or a first column without a name, counting by one: goes.
/// Both leave a note; so does a column of such a name that is kept because its numbers are not so.
void extract_time(Clip& clip, const std::string& name, const ReadOptions& options);

} // namespace stltsa::clip
