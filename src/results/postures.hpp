// SPDX-License-Identifier: BSD-3-Clause
// Chooses distinct postures of a motion, for pictures.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::results {

/// At most 24 rows of `samples`: the first is farthest from the mean, each next one farthest from
/// those before it, in pose and in time. The first n are the choice of n postures.
std::vector<std::int64_t> telling_postures(ConstMatrixView samples);

} // namespace stltsa::results
