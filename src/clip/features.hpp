// SPDX-License-Identifier: BSD-3-Clause
// From poses to the matrix that STLTSA works on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Same values as STLTSA_FEATURES_* (checked in capi).
enum class Features : std::int32_t {
    automatic = 0,   ///< positions where there is a skeleton, else raw
    positions = 1,   ///< joints and end sites, root position and root yaw removed
    rotations6d = 2, ///< two columns of each local rotation matrix, root yaw removed
    euler = 3,       ///< the file's rotation channels below the root, radians, unwrapped
    raw = 4,         ///< the file's numbers as they are
};

enum class Axis : std::int32_t { automatic = 0, x = 1, y = 2, z = 3 };

/// World positions of every joint and end site: frames x (3 * joints), file units.
Matrix positions(const Clip& clip);

/// Local rotation of every joint: frames x (4 * joints), w x y z, continuous sign over time.
Matrix rotations(const Clip& clip);

/// The up axis used: the given one; y for AMC; else that along which the head lies from the feet
/// over the clip (joints by name), or the body is largest where these names are missing.
Axis up_axis(const Clip& clip, Axis requested);

/// The kind used: positions where there is a skeleton, else raw. Status::unsupported where the
/// clip has no such features.
Features feature_kind(const Clip& clip, Features requested);

/// Features of every frame of the file, in source rate, nothing smoothed or dropped.
Matrix features(const Clip& clip, Features kind, Axis up);

struct PrepareOptions {
    Features features = Features::automatic;
    Axis up = Axis::automatic;
    double rate = 30;        ///< keep every round(fps / rate)-th frame; 0: keep all
    double smoothing = 0.05; ///< sigma of the Gaussian on the features in seconds; 0: none
    bool drop_tpose = true;  ///< only where there is a skeleton
};

/// Working samples of a clip: sample i is source frame first + i * step.
struct Prepared {
    Matrix samples;
    double fps = 0;         ///< of the samples
    std::int64_t first = 0; ///< = number of T-pose frames dropped at the start
    std::int64_t step = 1;
    std::int64_t jump = 0; ///< source frame before which the pose jumps; 0: it does not
    Features features = Features::automatic; ///< the kind used
    Axis up = Axis::automatic;               ///< the axis used
};

Prepared prepare(const Clip& clip, const PrepareOptions& options);

/// Features of every frame of the file, smoothed as prepare() does, whose samples are rows first,
/// first + step, ... of these. Frames of a T-pose that it drops stay as they are. `smoothing` as in
/// PrepareOptions.
Matrix smoothed_features(const Clip& clip, Features kind, Axis up, double smoothing,
                         bool drop_tpose);

/// Frames at the start that belong to a T-pose snapping into the motion (0 where there is none).
std::int64_t tpose_frames(ConstMatrixView features);

} // namespace stltsa::clip
