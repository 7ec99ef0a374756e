// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features/gaps.hpp"

namespace stltsa::clip {

/// Says what was done about gaps. Throws Status::not_finite if they are refused, or if nothing is
/// left. `width`: columns of a group, as in fill_gaps().
void note_gaps(const Clip& clip, int width, GapRule rule, const Gaps& gaps,
               std::vector<std::string>& notes);

/// Says which points were made missing in how many frames by drop_strays().
void note_strays(const Clip& clip, int width, const std::vector<std::int64_t>& frames,
                 std::vector<std::string>& notes);

} // namespace stltsa::clip
