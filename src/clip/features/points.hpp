// SPDX-License-Identifier: BSD-3-Clause
// Features of a bare matrix whose columns are the coordinates of points in space, such as markers.
#pragma once

#include <optional>

#include "clip/features/features.hpp"

namespace stltsa::clip {

/// The points relative to the body: gaps filled; their mean removed in the horizontal plane, the
/// slow part of its height removed; one heading; columns as in the clip. Of points in a plane, the
/// mean is removed, and the heading if it turns. `up` empty: as the file states it, or else
/// guessed. Fewer than three points, or a clip without a frame rate, keep what these need.
FeatureRows points(const Clip& clip, std::optional<Axis> up, GapRule rule);

/// The up axis that points() takes by itself; if it is guessed, none for fewer than three points; z
/// for points in a plane.
Axis points_up(const Clip& clip);

/// Columns of each point: those that the clip says, else three.
int point_columns(const Clip& clip);

} // namespace stltsa::clip
