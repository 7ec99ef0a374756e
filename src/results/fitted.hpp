// SPDX-License-Identifier: BSD-3-Clause
// A fit with what it came from, and what it keeps so that it can map.
#pragma once

#include <cstdint>
#include <vector>

#include "clip/features/pose_code.hpp"
#include "ltsa/dimension.hpp"
#include "ltsa/model.hpp"
#include "results/parameters.hpp"
#include "results/samples.hpp"

namespace stltsa::results {

/// What a model keeps of its source so that it can map.
struct Kept {
    Matrix frames;          ///< as they were fitted, a row of the model each; empty: cannot map
    bool drop_tpose = true; ///< of clips that are mapped, as it was of the one that was fitted
    bool has_poses = false; ///< fitted to a clip with a skeleton: the next two are there
    clip::PoseCode code;
    Matrix poses; ///< pose vectors, a row of the model each
};

struct Fitted {
    ltsa::Model model;
    Source source;
    Kept kept;
};

/// Fits 2 coordinates unless the options say otherwise. Throws as ltsa::fit().
Fitted fit(ConstMatrixView samples, const std::vector<std::int64_t>& lengths,
           const FitOptions& options, Source source, const Progress& progress);

/// Keeps the samples that were fitted and, if the clips have a skeleton, their poses.
void keep_clips(Fitted& fitted, Clips clips, Matrix samples);

/// A row of features: those of one pose vector, of the kind that was fitted.
Matrix features_of_pose(const Fitted& fitted, ConstMatrixView vector);

/// Rows of one clip and one component that follow each other: between others the curve breaks off.
std::vector<std::int64_t> unbroken_lengths(const ltsa::Model& model);

struct EstimatedDimension {
    ltsa::Dimension dimension;
    Source source;
};

/// Throws as ltsa::intrinsic_dimension().
EstimatedDimension estimate_dimension(ConstMatrixView samples,
                                      const std::vector<std::int64_t>& lengths,
                                      const FitOptions& options,
                                      const ltsa::DimensionOptions& limits, Source source,
                                      const Progress& progress);

} // namespace stltsa::results
