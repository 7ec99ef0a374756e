// SPDX-License-Identifier: BSD-3-Clause
#include "clip/foot_strikes.hpp"

#include <algorithm>
#include <string_view>

namespace stltsa::clip {
namespace {

constexpr std::string_view strike_names[] = {
    "footstrike", "heelstrike", "initialcontact", "footcontact", "heelcontact", "fs", "hs", "ic"};

/// The letters of a text in lower case.
std::string letters_of(std::string_view text) {
    std::string letters;
    for (const char c : text)
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))
            letters += static_cast<char>(c | 0x20);
    return letters;
}

bool is_strike(const std::string& letters) {
    return std::ranges::find(strike_names, letters) != std::end(strike_names);
}

/// The name of the event without its side: the words and letters that may stand for one.
bool names_strike(std::string_view text) {
    const std::string all = letters_of(text);
    if (is_strike(all))
        return true;
    for (const std::string_view side : {"left", "right", "l", "r"}) {
        if (all.starts_with(side) && is_strike(all.substr(side.size())))
            return true;
        if (all.ends_with(side) && is_strike(all.substr(0, all.size() - side.size())))
            return true;
    }
    return false;
}

} // namespace

std::vector<FootStrike> foot_strikes(const Clip& clip) {
    std::vector<FootStrike> strikes;
    for (const Event& event : clip.events) // some programs write names in the place of contexts
        if (names_strike(event.label.empty() ? event.context : event.label))
            strikes.push_back({event.frame, side_of_name(event.context + ' ' + event.label)});
    return strikes;
}

} // namespace stltsa::clip
