// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stltsa {

enum class Side { neither = -1, left = 0, right = 1 };

/// The side that a name states: left for "left heel strike", "LHS" and "toe_l". None if the name
/// states neither or both, and for parts of other words, as in "upright" and "rock".
Side side_of_name(std::string_view name);

/// A name on the other side of the body.
struct OtherSide {
    std::string name;
    Side side = Side::neither; ///< of the given name, if this is its partner
};

/// What a name may be on the other side of the body: "RightFoot" for "LeftFoot", "R_toe" for
/// "L_toe", "heel.r" for "heel.l". More than one if several letters may be the side's; none if
/// nothing in the name may be a side. `first_letter`: also "rfemur" for "lfemur", and therefore
/// "rock" for "lock".
std::vector<OtherSide> other_sides(std::string_view name, bool first_letter);

} // namespace stltsa
