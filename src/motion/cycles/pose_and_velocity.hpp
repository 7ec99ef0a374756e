// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Rows [begin, end) of a recording.
struct Range {
    std::int64_t begin = 0;
    std::int64_t end = 0;

    std::int64_t rows() const { return end - begin; }
};

/// Change from row to row: central differences, one-sided at the ends. At least two rows.
Matrix differences(ConstMatrixView rows);

/// What phases are found on: the smoothed rows and, beside them, their velocity times two. Velocity
/// is scaled such that of a pure oscillation once per period it is as large as the pose. Velocity
/// forgets slow drift and weighs fast parts of the body: events have half the scatter in phase that
/// poses alone give. `rate`: rows per second; `period`: rows.
Matrix pose_and_velocity(ConstMatrixView rows, double rate, double period);

} // namespace stltsa::motion
