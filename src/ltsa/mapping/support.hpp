// SPDX-License-Identifier: BSD-3-Clause
// How far from the rows of a model a new one may be and still count as one of their kind.
#pragma once

#include <cstdint>
#include <span>

#include "linalg/matrix.hpp"
#include "ltsa/mapping/timeline.hpp"
#include "ltsa/parameters.hpp"
#include "ltsa/search/nearest_rows.hpp"

namespace stltsa::ltsa {

/// A distance learned from the rows themselves, so that it follows from how densely they lie and
/// how much a motion differs from its own repetitions. The larger of
/// - what 99 % of the rows are at most from the one that follows (from the nearest other one where
///   their order means nothing: spatial neighborhoods), and,
/// - where a motion repeats itself every `period` rows (0: it does not), the median distance of a
///   row from the nearest one of another repetition.
double support_limit(ConstMatrixView x, std::span<const NearestRows> parts,
                     const Timeline& timeline, Mode mode, double period);

} // namespace stltsa::ltsa
