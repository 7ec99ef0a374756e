// SPDX-License-Identifier: BSD-3-Clause
#include "plot/palette.hpp"

#include <iterator>

#include <stltsa.hpp>

namespace tool::plot {

UnitColors unit_colors(std::int32_t kind) {
    // In order of the kinds; further kinds begin again.
    static constexpr UnitColors colors[] = {
        {"#56b4e9", "#e9f5fc", ink},       {"#e69f00", "#fcf1dc", ink},
        {"#0072b2", "#e0eef6", "#ffffff"}, {"#d55e00", "#fae9de", "#ffffff"},
        {"#cc79a7", "#f9eef4", ink},       {"#009e73", "#def2ec", "#ffffff"},
        {"#0072b2", "#ffffff", "#ffffff"}, {"#f0e442", "#fdfbe0", ink},
    };
    return colors[static_cast<std::size_t>(kind - 1) % std::size(colors)];
}

UnitColors label_colors(std::int32_t label) {
    if (label < 0)
        return {"#dddddd", "#f4f4f4", ink};
    static constexpr std::int32_t kinds[] = {
        STLTSA_UNIT_CYCLIC,    STLTSA_UNIT_INITIAL, STLTSA_UNIT_ACTION, STLTSA_UNIT_WIND_UP,
        STLTSA_UNIT_PREPARING, STLTSA_UNIT_FINAL,   STLTSA_UNIT_HOLD};
    return unit_colors(kinds[static_cast<std::size_t>(label) % std::size(kinds)]);
}

} // namespace tool::plot
