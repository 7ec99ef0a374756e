// SPDX-License-Identifier: BSD-3-Clause
#include "clip/foot_strikes.hpp"

namespace stltsa::clip {
namespace {

/// Of the name and of what the event happens to: neither if they contradict each other.
Side agreed_side(Side of_name, Side of_context) {
    if (of_name == Side::neither || of_context == Side::neither)
        return of_name == Side::neither ? of_context : of_name;
    return of_name == of_context ? of_name : Side::neither;
}

} // namespace

std::vector<FootStrike> foot_strikes(const Clip& clip) {
    std::vector<FootStrike> strikes;
    for (const Event& event : clip.events) { // some programs write names in the place of contexts
        const auto named = foot_event(event.label.empty() ? event.context : event.label);
        if (named && named->is_strike)
            strikes.push_back({event.frame, agreed_side(named->side, side_of_name(event.context))});
    }
    return strikes;
}

} // namespace stltsa::clip
