// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "stltsa.h"

namespace stltsa::results {

/// How often and how fast, for each label of which there are cycles or repetitions. Parts are in
/// temporal order, those of each segment one after another.
std::vector<stltsa_summary> summaries_of(std::span<const stltsa_segment> segments,
                                         std::span<const stltsa_part> cycles,
                                         std::span<const stltsa_part> repetitions);

} // namespace stltsa::results
