// SPDX-License-Identifier: BSD-3-Clause
// Columns that rise or fall all the time, such as frame numbers or the path of a walk, hide what
// repeats.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Subtracts the slow part of the columns that only drift, and gives their indices. `fps`: of the
/// samples.
std::vector<std::int64_t> remove_drift(Matrix& samples, double fps);

} // namespace stltsa::clip
