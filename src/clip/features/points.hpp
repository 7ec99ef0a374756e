// SPDX-License-Identifier: BSD-3-Clause
// Features of a bare matrix whose columns are the coordinates of points in space, such as markers.
#pragma once

#include <optional>

#include "clip/features/features.hpp"

namespace stltsa::clip {

/// The points relative to the body: gaps filled; their mean removed in the horizontal plane, the
/// slow part of its height removed; one heading; columns as in the clip. `up` empty: guessed. Fewer
/// than three points, or a clip without a frame rate, keep what these need.
FeatureRows points(const Clip& clip, std::optional<Axis> up);

/// The up axis that points() guesses; none for fewer than three points.
Axis points_up(const Clip& clip);

} // namespace stltsa::clip
