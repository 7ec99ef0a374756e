// SPDX-License-Identifier: BSD-3-Clause
// Whether a cycle that is repeated turns the body, or only ends at another place of its swing.
#pragma once

#include "synthesis/cuts.hpp"

namespace stltsa::synthesis {

/// Radians about the up axis by which each repetition from cut to cut turns the body without its
/// turning there: less than the heading swings, steady turning aside, within the repetition, while
/// stretches as long, beginning anywhere from one repetition before to one after, turn to either
/// side. Otherwise 0.
double stray_turn(const Body& body, const Track& track, const Cut& cut);

} // namespace stltsa::synthesis
