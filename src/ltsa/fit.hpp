// SPDX-License-Identifier: BSD-3-Clause
// A fit from frames to coordinates (paper, Table 1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/model.hpp"

namespace stltsa::ltsa {

/// Fits STLTSA to `frames` (rows = frames of all clips one after another; lengths sum to rows).
/// They passed check_frames(). Throws Error for frames that are too few, parameters out of range,
/// no memory, cancelled.
Model fit(ConstMatrixView frames, std::span<const std::int64_t> lengths,
          const Parameters& parameters, const Progress& progress);

/// The same for tangent dimensions 1 .. parameters.dimension, sharing neighbors and tangents;
/// element d-1 of the result has dimension d.
std::vector<Model> fit_dimensions(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                                  const Parameters& parameters, const Progress& progress);

} // namespace stltsa::ltsa
