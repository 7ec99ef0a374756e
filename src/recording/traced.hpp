// SPDX-License-Identifier: BSD-3-Clause
// The curve of a recording: the coordinate of each cyclic segment, and 0 elsewhere.
#pragma once

#include "recording/drafts.hpp"

namespace stltsa::recording {

/// `single`: stays if no segment has cycles; empty for a long recording.
motion::Decomposition shown_of(const Signal& signal, const std::vector<Draft>& drafts,
                               motion::Decomposition single, std::int64_t samples);

} // namespace stltsa::recording
