// SPDX-License-Identifier: BSD-3-Clause
// Which postures tell most about a motion, for pictures.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::results {

/// Rows of `samples` that differ: the first is farthest from the mean, each next one farthest from
/// those before, which also keeps it from lying close to them in time. Any first part of the list
/// is a choice of its own. At most 24.
std::vector<std::int64_t> telling_postures(ConstMatrixView samples);

} // namespace stltsa::results
