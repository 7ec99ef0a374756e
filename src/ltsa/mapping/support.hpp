// SPDX-License-Identifier: BSD-3-Clause
// The reach of a model: the distance from its rows up to which a new row is like them.
#pragma once

#include <cstdint>
#include <span>

#include "linalg/matrix.hpp"
#include "ltsa/mapping/timeline.hpp"
#include "ltsa/parameters.hpp"
#include "ltsa/search/nearest_rows.hpp"

namespace stltsa::ltsa {

/// Follows from the density of the rows and the variability of the motion. The larger of
/// - the 99th percentile of the distance from a row to the next (for spatial neighborhoods, whose
///   rows have no order, to the nearest other row), and
/// - if the motion repeats every `period` rows (0: it does not), the median distance from a row to
///   the nearest one of another repetition.
double support_limit(ConstMatrixView x, std::span<const NearestRows> trees,
                     const Timeline& timeline, Mode mode, double period);

} // namespace stltsa::ltsa
