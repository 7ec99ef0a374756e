// SPDX-License-Identifier: BSD-3-Clause
// A fit from frames X to coordinates Y: all steps of Table 1.
#pragma once

#include <cstdint>
#include <span>

#include "linalg/matrix.hpp"
#include "ltsa/model.hpp"

namespace stltsa::ltsa {

/// Fits STLTSA to `frames` (the rows of all clips in succession; lengths sum to rows), which have
/// passed check_frames(). Throws if frames are too few or degenerate, parameters are out of range,
/// memory runs out, or the call is cancelled.
Model fit(ConstMatrixView frames, std::span<const std::int64_t> lengths,
          const Parameters& parameters);

/// Throws, before any work, if there are more coordinates than features.
void check_dimension(std::int64_t features, int dimension);

} // namespace stltsa::ltsa
