// SPDX-License-Identifier: BSD-3-Clause
// Which postures stand along the curve, and how large.
#pragma once

#include <cstdint>
#include <vector>

#include "plot/figure.hpp"

namespace tool::plot {

struct PosturePlan {
    std::vector<std::int64_t> frames; ///< one per slot, in order of time
    double scale = 1;                 ///< paper over file unit
};

/// Slots of equal width share `width`; figures stand above and below the curve in turns, so that
/// each has the room of two slots, and are at most `height` tall. In each slot the frame nearest
/// its middle where something happens (a border, a margin, an extremum of the curve) is shown,
/// else the middle.
PosturePlan plan_postures(const Figure& figure, double width, double height);

} // namespace tool::plot
