// SPDX-License-Identifier: BSD-3-Clause
// The fits that a decomposition chooses from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ltsa/dimension.hpp"
#include "ltsa/model.hpp"
#include "motion/activity.hpp"
#include "motion/decompose.hpp"
#include "motion/period.hpp"

namespace stltsa::motion {

struct Embedding {
    Span span;                                ///< the samples that were embedded
    ltsa::Parameters parameters;              ///< of the fit of the highest dimension
    std::vector<ltsa::Model> models;          ///< by dimension, ascending; empty: see problem
    std::string problem;                      ///< why the samples cannot be embedded, in words
    std::optional<ltsa::Dimension> intrinsic; ///< if options.estimate
};

/// Embeds the samples of `span`, all from one graph. With a period in 1 to 3 dimensions, of which
/// the one whose coordinate swings best is chosen; without one in 2. Or, by options.dimension, in
/// that many, and in those that a loop needs.
Embedding embed(ConstMatrixView samples, double fps, Span span, const Period& period,
                const DecomposeOptions& options, const Progress& progress);

/// Coordinates of all samples: those outside the span stand where its end does.
Matrix extended(const Matrix& coords, Span span, std::int64_t samples);

} // namespace stltsa::motion
