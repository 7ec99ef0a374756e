// SPDX-License-Identifier: BSD-3-Clause
// Turns a clip into the samples that are fitted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features/features.hpp"

namespace stltsa::clip {

struct PrepareOptions {
    std::optional<Features> features; ///< empty: feature_kind() chooses
    std::optional<Axis> up;           ///< empty: up_axis() chooses
    double rate = 30;                 ///< keep every round(fps / rate)-th frame; 0: keep all
    double smoothing = 0.05;          ///< sigma of the Gaussian on the features in seconds; 0: none
    bool drop_tpose = true;           ///< only if there is a skeleton
    GapRule gaps = GapRule::fill;
    bool keep_rows = false; ///< see Prepared
};

/// Working samples of a clip: sample i is source frame first + i * step.
struct Prepared {
    Matrix samples;
    Matrix rows; ///< if wanted, of every source frame from the first one to the last, not smoothed
    double fps = 0; ///< of the samples
    /// Number of frames dropped at the start: a T-pose, or those before the body comes. Those after
    /// it has left have no samples either; both are among the holes.
    std::int64_t first = 0;
    std::int64_t step = 1;
    std::int64_t jump = 0;             ///< source frame before which the pose jumps; 0: it does not
    Features features = Features::raw; ///< the kind used
    Axis up = Axis::none;              ///< the axis used
    bool turned = false;               ///< of feature_rows()
    std::vector<std::string> notes;    ///< of feature_rows()
    /// Of feature_rows(), and empty ones at breaks of the clip, in source frames, ascending.
    std::vector<Frames> holes;
};

Prepared prepare(const Clip& clip, const PrepareOptions& options);

/// Features of every frame of the file, smoothed as by prepare(), whose samples are the rows first,
/// first + step, ... of the result. Frames that prepare() drops are not smoothed.
/// `smoothing`: as in PrepareOptions.
Matrix smoothed_features(const Clip& clip, Features kind, Axis up, double smoothing,
                         bool drop_tpose);

} // namespace stltsa::clip
