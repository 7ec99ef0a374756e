// SPDX-License-Identifier: BSD-3-Clause
// Coordinates without noise (paper, section 3.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "motion/period.hpp"

namespace stltsa::motion {

struct DenoiseOptions {
    double gamma = -1;    ///< distance from the curve beyond which a point is noisy; -1: `noise`
    double knot_step = 4; ///< rows between the knots of the curve
    bool robust = true;   ///< spikes do not pull at the curve
};

/// Of one column, over all clips.
struct DenoisedColumn {
    double gamma = 0;              ///< threshold used
    double shift = 0;              ///< d_t: mean distance of the noisy points from the curve
    double noise = 0;              ///< robust standard deviation of the points about the curve
    double degrees_of_freedom = 0; ///< effective degrees of freedom of the curve
    std::int64_t moved = 0;        ///< noisy points
};

/// Matrices as the coordinates are.
struct Denoised {
    Matrix curve;   ///< f_c
    Matrix cleaned; ///< the points after equation (1)
    Matrix moves;   ///< cleaned - points; 0 where a point was not moved
    std::vector<DenoisedColumn> columns;
};

/// Fits a spline to each column of each clip (rows of all clips one after another; lengths sum to
/// rows). Points farther than gamma from it are moved towards it by their mean distance d_t, as in
/// equation (1), but not across it: a point nearer than d_t ends on the curve. Throws for
/// coordinates that are not finite and for clips of fewer than 8 rows.
Denoised denoise(ConstMatrixView coords, std::span<const std::int64_t> lengths,
                 const DenoiseOptions& options, const Progress& progress);

/// Rows between knots that a motion of this period asks for: a tenth of it. Where nothing is known
/// of it 2, which leaves the smoothing to the penalty.
double knot_step_for(const Period& period);

} // namespace stltsa::motion
