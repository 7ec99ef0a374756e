// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip {

/// Fewer points have no shape whose path and heading could be removed.
constexpr std::int64_t least_points = 3;

/// The name of a coordinate, not empty, without its axis: "heel" of "heel_x".
std::string_view point_name(std::string_view coordinate);

/// Whether the column and two beside it are named as the coordinates of one point: a stem and x, y,
/// z, as in "heel_x", "heel.Y", "heel z", "heelX", "heel:x".
bool names_coordinate(const std::vector<std::string>& names, std::size_t column);

/// Whether the columns are the coordinates of at least least_points points and nothing else. Three
/// columns of an angle, a force or a velocity are not a point.
bool names_points(const std::vector<std::string>& names);

} // namespace stltsa::clip
