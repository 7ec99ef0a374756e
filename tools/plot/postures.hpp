// SPDX-License-Identifier: BSD-3-Clause
// Choice and size of the postures along the curve.
#pragma once

#include <cstdint>
#include <vector>

#include "plot/figure.hpp"

namespace tool::plot {

struct PosturePlan {
    std::vector<std::int64_t> frames; ///< one per slot, in order of time
    double scale = 1;                 ///< figure units per file unit
};

/// Divides `width` into equal slots. Postures alternate above and below the curve, so each has room
/// for two slots; they are at most `height` tall. Each slot shows the event nearest to its middle
/// (a border, a margin, an extremum of the curve), or else its middle frame.
PosturePlan plan_postures(const Figure& figure, double width, double height);

} // namespace tool::plot
