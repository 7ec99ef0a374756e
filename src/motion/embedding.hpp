// SPDX-License-Identifier: BSD-3-Clause
// The fits among which a decomposition chooses.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ltsa/dimension.hpp"
#include "ltsa/model.hpp"
#include "motion/activity.hpp"
#include "motion/decomposition.hpp"
#include "motion/period.hpp"

namespace stltsa::motion {

struct Embedding {
    Span span;                       ///< the samples that were embedded
    ltsa::Parameters parameters;     ///< of the fit of the highest dimension
    std::vector<ltsa::Model> models; ///< by dimension, ascending; empty: see problem
    std::string problem;             ///< why the samples cannot be embedded; empty if they can
    std::optional<ltsa::Dimension> intrinsic; ///< if options.estimate
};

/// Embeds the samples of `span` (paper, Table 1) from one graph: with a period in 1 to 3
/// dimensions, without one in 2. If options.dimension is set, in that many, and in 2 for the loop.
Embedding embed(ConstMatrixView samples, double fps, Span span, const Period& period,
                const DecomposeOptions& options, const Progress& progress);

/// Coordinates of all samples: those outside the span repeat the nearest end of it.
Matrix extended(const Matrix& coords, Span span, std::int64_t samples);

} // namespace stltsa::motion
