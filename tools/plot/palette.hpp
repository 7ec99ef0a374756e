// SPDX-License-Identifier: BSD-3-Clause
// Colors that remain distinct for color-blind readers and in gray: Okabe and Ito, "Color Universal
// Design", 2008.
#pragma once

#include <cstdint>

namespace tool::plot {

struct UnitColors {
    const char* line; ///< of the curve and the bar
    const char* band; ///< the same, faint
    const char* text; ///< on the bar
};

/// Colors of a STLTSA_UNIT_*; any other value: those of a curve without units.
UnitColors unit_colors(std::int32_t kind);

/// Colors of the segments with a label; -1: of a rest. They begin again after seven labels.
UnitColors label_colors(std::int32_t label);

inline constexpr const char* ink = "#222222";
inline constexpr const char* faint_ink = "#767676";
inline constexpr const char* hairline = "#b8b8b8";

} // namespace tool::plot
