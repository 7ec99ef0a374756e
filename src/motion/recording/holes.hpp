// SPDX-License-Identifier: BSD-3-Clause
// Stretches of which nothing is known, because most of the body was not recorded. No motion
// continues over them. They are searched as rests, and become borders in the answer: nobody knows
// whether the body kept still.
#pragma once

#include <vector>

#include "motion/recording/drafts.hpp"

namespace stltsa::motion {

/// Joins holes to the rests and pauses, which are ascending.
void add_holes(const std::vector<Rows>& holes, std::vector<Rows>& rests, Pauses& pauses);

/// Replaces a rest that is little more than a hole by a border in its middle, and divides other
/// drafts there.
void divide_at_holes(const std::vector<Rows>& holes, double rate, std::vector<Draft>& drafts);

} // namespace stltsa::motion
