// SPDX-License-Identifier: BSD-3-Clause
// A fit from frames to coordinates (paper, Table 1).
#pragma once

#include <cstdint>
#include <span>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/model.hpp"

namespace stltsa::ltsa {

/// Fits STLTSA to `frames` (rows = frames of all clips one after another; lengths sum to rows).
/// They passed check_frames(). Throws Error for frames that are too few, parameters out of range,
/// no memory, cancelled.
Model fit(ConstMatrixView frames, std::span<const std::int64_t> lengths,
          const Parameters& parameters, const Progress& progress);

/// Throws for more coordinates than features, before the work: windows have fewer directions
/// everywhere.
void check_dimension(std::int64_t features, int dimension);

} // namespace stltsa::ltsa
