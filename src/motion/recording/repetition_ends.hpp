// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "motion/recording/drafts.hpp"

namespace stltsa::motion {

/// Finds the first or last repetition of an action where no pause separates it from the motion
/// before or after, and takes it from there: the piece beside a pause that is like the others.
void find_end_repetitions(const Signal& signal, std::vector<Draft>& drafts);

} // namespace stltsa::motion
