// SPDX-License-Identifier: BSD-3-Clause
// Choice, place and size of the postures along the curve.
#pragma once

#include <cstdint>
#include <vector>

#include "plot/figure.hpp"

namespace tool::plot {

struct Posture {
    std::int64_t frame = 0;
    double x = 0; ///< of its middle
    bool above = true;
};

struct PosturePlan {
    std::vector<Posture> postures; ///< in order of time
    double scale = 1;              ///< figure units per file unit
};

/// Places as many of the figure's postures as fit, alternately above and below the curve, each as
/// near to its time as its neighbors allow and at most `height` tall.
PosturePlan plan_postures(const Figure& figure, const Rect& frame, double height);

} // namespace tool::plot
