// SPDX-License-Identifier: BSD-3-Clause
// The fits that a decomposition chooses from.
#pragma once

#include <string>
#include <vector>

#include "ltsa/model.hpp"
#include "motion/activity.hpp"
#include "motion/decompose.hpp"

namespace stltsa::motion {

struct Embedding {
    Span span;                       ///< the samples that were embedded
    ltsa::Parameters parameters;     ///< of the fit of the highest dimension
    std::vector<ltsa::Model> models; ///< element d - 1 has d dimensions; empty: see problem
    std::string problem;             ///< why the samples cannot be embedded, in words
};

/// Embeds the samples of `span` with options.neighbors, else with `neighbors`, as far as there are
/// distinct samples, in 1 to 3 dimensions or up to options.dimension.
Embedding embed(ConstMatrixView samples, Span span, std::int64_t neighbors,
                const DecomposeOptions& options, const Progress& progress);

/// Coordinates of all samples: those outside the span stand where its end does.
Matrix extended(const Matrix& coords, Span span, std::int64_t samples);

} // namespace stltsa::motion
