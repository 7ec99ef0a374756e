// SPDX-License-Identifier: BSD-3-Clause
// The path of a loop: how far one loop travels and turns, and the loop without that.
#pragma once

#include "synthesis/synthesis.hpp"
#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// Travel and turn of a loop. `closing`: the step from its first frame to the frame after its last
/// one; the turn is counted along the frames, so that it may exceed half a circle.
Loop travel_of(const Body& body, const Track& made, const Step& closing);

/// Removes travel and turn, evenly over the frames, from the root's channels. What the body sways
/// by within the loop is kept, as are its heights.
void put_in_place(const Body& body, const Track& made, const Step& closing, Matrix& values);

} // namespace stltsa::synthesis
