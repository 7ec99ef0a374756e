// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stltsa {

/// What a name may be on the other side of the body: "RightFoot" for "LeftFoot", "R_toe" for
/// "L_toe", "heel.r" for "heel.l". More than one if several letters may be the side's; none if
/// nothing in the name may be a side. `first_letter`: also "rfemur" for "lfemur", and therefore
/// "rock" for "lock".
std::vector<std::string> other_side_names(std::string_view name, bool first_letter);

} // namespace stltsa
