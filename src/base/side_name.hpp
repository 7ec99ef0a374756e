// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa {

enum class Side { neither = -1, left = 0, right = 1 };

/// The side that a name states: left for "left heel strike", "LHS" and "toe_l". None if the name
/// states neither or both, and for parts of other words, as in "upright" and "rock".
Side side_of_name(std::string_view name);

/// A contact of a foot with the ground.
struct FootEvent {
    bool is_strike = false; ///< else the foot leaves the ground
    Side side = Side::neither;
};

/// What a name such as "Foot Strike", "right heel contact", "LHS", "rto" or "eRTO" says. None if it
/// is no such name.
std::optional<FootEvent> foot_event(std::string_view name);

/// A name on the other side of the body.
struct OtherSide {
    std::string name;
    Side side = Side::neither; ///< of the given name, if this is its partner
};

/// What a name may be on the other side of the body: "RightFoot" for "LeftFoot", "R_toe" for
/// "L_toe", "heel.r" for "heel.l". More than one if several letters may be the side's; none if
/// nothing in the name may be a side. `within_words`: also the first or last letter of a word, as
/// in "rfemur" for "lfemur", "HeelR" for "HeelL", and therefore "rock" for "lock".
std::vector<OtherSide> other_sides(std::string_view name, bool within_words);

/// What a name of a joint, point or column is among the others of its body.
struct Sided {
    Side side = Side::neither;
    std::size_t partner = 0; ///< index of the name on the other side; its own without one
};

/// The one rule for left and right: names that differ only in the side are partners, in their order
/// if there are several of one name; a name without a partner has the side that it states.
std::vector<Sided> sides_of(std::span<const std::string> names);

} // namespace stltsa
