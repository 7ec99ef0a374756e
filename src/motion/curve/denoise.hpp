// SPDX-License-Identifier: BSD-3-Clause
// Removes noise from coordinates (paper, section 3.2).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

struct DenoiseOptions {
    std::optional<double> gamma; ///< distance beyond which a point is noisy; empty: `noise`
    double knot_step = 4;        ///< rows between the knots of the curve
    bool robust = true;          ///< spikes do not distort the curve
};

/// Statistics of one column, over all clips.
struct DenoisedColumn {
    double gamma = 0;              ///< threshold used
    double shift = 0;              ///< d_t: mean distance of the noisy points from the curve
    double noise = 0;              ///< robust standard deviation of the points about the curve
    double noise_share = 0;        ///< the same as a share of the curve's range; 0 without a range
    double degrees_of_freedom = 0; ///< effective degrees of freedom of the curve
    std::int64_t moved = 0;        ///< noisy points
};

/// The matrices have the shape of the coordinates.
struct Denoised {
    Matrix curve;   ///< f_c
    Matrix cleaned; ///< the points after equation (1)
    Matrix moves;   ///< cleaned - points; 0 where a point was not moved
    std::vector<DenoisedColumn> columns;
};

/// Fits a spline to each column of each clip (the clips' rows are consecutive; `lengths` sum to the
/// rows). Points farther than gamma from it are moved towards it by their mean distance d_t, as in
/// equation (1), but not across it: a point nearer than d_t ends on the curve. Throws if
/// coordinates are not finite or a clip has fewer than 8 rows.
Denoised denoise(ConstMatrixView coords, std::span<const std::int64_t> lengths,
                 const DenoiseOptions& options);

/// Whether the noise of all columns is so small a share that it cannot be seen in a figure.
bool nothing_to_clean(const std::vector<DenoisedColumn>& columns);

/// Rows between knots: a tenth of the period; 2 without one, where only the penalty smooths.
double knot_step_for(double period);

} // namespace stltsa::motion
