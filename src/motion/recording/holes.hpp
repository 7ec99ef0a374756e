// SPDX-License-Identifier: BSD-3-Clause
// Stretches of which nothing is known, because most of the body was not recorded. No motion
// continues over them. They are searched as rests, and say in the answer that nothing was recorded:
// nobody knows whether the body kept still.
#pragma once

#include <vector>

#include "motion/recording/drafts.hpp"

namespace stltsa::motion {

/// Joins holes to the rests and pauses, which are ascending.
void add_holes(const std::vector<Rows>& holes, std::vector<Rows>& rests, Pauses& pauses);

/// Makes holes, in rows and ascending, drafts of their own, and divides the drafts where a hole is
/// empty. A rest that is little more than a hole goes to its neighbors.
void divide_at_holes(const std::vector<Hole>& holes, double rate, std::vector<Draft>& drafts);

} // namespace stltsa::motion
