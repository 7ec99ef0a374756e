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
    };
    if (kind == STLTSA_UNIT_CYCLE)
        return {"#0072b2", "#ffffff", "#ffffff"};
    return colors[static_cast<std::size_t>(kind - 1) % std::size(colors)];
}

} // namespace tool::plot
