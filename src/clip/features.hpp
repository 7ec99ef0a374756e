// SPDX-License-Identifier: BSD-3-Clause
// From poses to the matrix that STLTSA works on.
#pragma once

#include <cstdint>

#include "clip/clip.hpp"
#include "clip/up_axis.hpp"

namespace stltsa::clip {

/// Same values as STLTSA_FEATURES_* (checked in capi).
enum class Features : std::int32_t {
    automatic = 0,   ///< positions where there is a skeleton, else raw
    positions = 1,   ///< joints and end sites, root position and root yaw removed
    rotations6d = 2, ///< two columns of each local rotation matrix, root yaw removed
    euler = 3,       ///< the file's rotation channels below the root, radians, unwrapped
    raw = 4,         ///< the file's numbers as they are
};

/// World positions of every joint and end site: frames x (3 * joints), file units.
Matrix positions(const Clip& clip);

/// Local rotation of every joint: frames x (4 * joints), w x y z, continuous sign over time.
Matrix rotations(const Clip& clip);

/// The kind used: positions where there is a skeleton, else raw. Status::unsupported where the
/// clip has no such features.
Features feature_kind(const Clip& clip, Features requested);

/// Columns of these features; Status::unsupported where there are none.
std::int64_t feature_count(const Clip& clip, Features requested);

/// Features of every frame of the file, in source rate, nothing smoothed or dropped.
Matrix features(const Clip& clip, Features kind, Axis up);

} // namespace stltsa::clip
