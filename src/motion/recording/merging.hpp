// SPDX-License-Identifier: BSD-3-Clause
// Fewer segments than the changes of behavior: neighbors that differ least become one.
#pragma once

#include "motion/recording/drafts.hpp"

namespace stltsa::motion {

/// If shapes are described, merges the motions of one part that are less than a usual period
/// apart, unless most of the part repeats: they are pieces of one shape.
void merge_shapes(const KernelFeatures& features, const std::vector<Part>& parts,
                  std::vector<Draft>& drafts);

/// Number of drafts that are not rests.
std::int64_t moving(const std::vector<Draft>& drafts);

/// Merges neighbors, and the rests between them, until at most `count` drafts move.
void merge_to(const KernelFeatures& features, std::int64_t count, std::vector<Draft>& drafts);

} // namespace stltsa::motion
