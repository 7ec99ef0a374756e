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
inline constexpr const char* far_limb = "#a0a0a0";

// Widths of lines, and the radius of marks (docs/figures.md).
inline constexpr double curve_line = 1.8; ///< the curve, bones
inline constexpr double many_line = 0.7;  ///< each of many cycles
inline constexpr double thin_line = 0.8;  ///< frames, ticks, margins
inline constexpr double wide_line = 4;    ///< behind the representative cycle
inline constexpr double mark_radius = 2.2;
inline constexpr const char* dashes = "3 2.5"; ///< of margins

} // namespace tool::plot
