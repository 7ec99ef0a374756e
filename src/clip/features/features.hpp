// SPDX-License-Identifier: BSD-3-Clause
// Features: the input matrix X of STLTSA (paper, Table 1), computed from poses.
#pragma once

#include <cstdint>
#include <optional>

#include "clip/body/heading.hpp"
#include "clip/body/up_axis.hpp"
#include "clip/clip.hpp"
#include "clip/features/gaps.hpp"

namespace stltsa::clip {

/// Same values as STLTSA_FEATURES_* (checked in capi).
enum class Features : std::int32_t {
    positions = 1,   ///< joints and end sites, root position and root yaw removed
    rotations6d = 2, ///< two columns of each local rotation matrix, root yaw removed
    euler = 3,       ///< the file's rotation channels below the root, radians, unwrapped
    raw = 4,         ///< the values of the file, unchanged
    points = 5,      ///< points of a bare matrix, relative to the body (points.hpp)
};

/// World positions of every joint and end site: frames x (3 * joints), file units.
Matrix positions(const Clip& clip);

/// Local rotation of every joint: frames x (4 * joints), w x y z, continuous sign over time.
Matrix rotations(const Clip& clip);

/// The kind used: the requested one, else positions if there is a skeleton, else points if the
/// columns are points, else raw. Status::unsupported if the clip lacks a skeleton or points.
Features feature_kind(const Clip& clip, std::optional<Features> requested);

/// Number of columns of these features; Status::unsupported if there are none.
std::int64_t feature_count(const Clip& clip, std::optional<Features> requested);

/// Features of every frame of the file, without smoothing or decimation.
struct FeatureRows {
    Matrix rows;
    Axis up = Axis::none;           ///< the axis used
    bool turned = false;            ///< the heading of points was removed
    std::vector<std::string> notes; ///< what was filled, assumed and removed
    std::vector<Frames> holes;      ///< of which nothing is known
};
FeatureRows feature_rows(const Clip& clip, std::optional<Features> requested,
                         std::optional<Axis> up, GapRule rule = GapRule::fill);
Matrix features(const Clip& clip, std::optional<Features> requested, std::optional<Axis> up);

/// Features of a clip whose body root and heading are known.
Matrix body_features(const Clip& clip, Features kind, Heading heading);

} // namespace stltsa::clip
