// SPDX-License-Identifier: BSD-3-Clause
// A fit, its source, and the data that mapping needs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "clip/features/pose_code.hpp"
#include "ltsa/dimension.hpp"
#include "ltsa/model.hpp"
#include "results/live.hpp"
#include "results/parameters.hpp"
#include "results/samples.hpp"

namespace stltsa::results {

/// The data that mapping needs.
struct Kept {
    Matrix frames;          ///< as they were fitted, a row of the model each; empty: cannot map
    bool drop_tpose = true; ///< whether the T-pose was dropped, as it will be of mapped clips
    bool has_poses = false; ///< fitted to a clip with a skeleton: the next two are there
    clip::PoseCode code;
    Matrix poses; ///< pose vectors, a row of the model each
};

struct Fitted {
    ltsa::Model model; ///< its lengths are those of the runs
    Source source;
    Kept kept;
    std::vector<std::int64_t> lengths; ///< rows of each clip
    Live live;
    std::optional<ltsa::Dimension> dimension = {}; ///< if it was asked for; no file keeps it
};

/// Fits 2 coordinates unless the options say otherwise; `intrinsic`: and estimates the intrinsic
/// dimension. Throws as ltsa::fit().
Fitted fit(ConstMatrixView samples, const Lengths& lengths, const FitOptions& options,
           const std::optional<ltsa::DimensionOptions>& intrinsic, Source source);

/// Keeps the samples that were fitted and, if the clips have a skeleton, their poses.
void keep_clips(Fitted& fitted, Clips clips, Matrix samples);

/// The features of one pose vector, as one row; of the kind that was fitted.
Matrix features_of_pose(const Fitted& fitted, ConstMatrixView vector);

/// Numbers of consecutive rows of one run and one component; the curve is interrupted between
/// them.
std::vector<std::int64_t> unbroken_lengths(const ltsa::Model& model);

} // namespace stltsa::results
