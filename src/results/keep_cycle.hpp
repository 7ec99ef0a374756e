// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/fitted.hpp"
#include "results/phased.hpp"

namespace stltsa::results {

/// Keeps the mean cycle of the motion with the most frames, for streams, and forgets earlier marks.
/// Throws Status::argument if the clip has no cycles, and Status::shape if its features are not
/// those of the model.
void keep_cycle(Fitted& model, const Phased& phased);

/// Names the phase of a frame in the cycles of that motion. Throws Status::argument if there is no
/// such frame, no name, or no room for another mark.
void keep_mark(Fitted& model, const Phased& phased, double frame, const std::string& name);

} // namespace stltsa::results
