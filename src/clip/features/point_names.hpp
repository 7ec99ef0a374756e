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

/// The name without a unit after it: "heel_x" of "heel_x [mm]" and "heel_x (mm)".
std::string without_unit(std::string_view name);

/// The same coordinate with its axis last: "heel_x" of "x_heel", "1_x" of "x1"; other names are
/// unchanged.
std::string axis_last(std::string_view name);

/// Whether the column and two beside it are named as the coordinates of one point: a stem and x, y,
/// z, as in "heel_x", "heel.Y", "heel z", "heelX", "heel:x".
bool names_coordinate(const std::vector<std::string>& names, std::size_t column);

/// Columns that belong to one point.
struct PointColumns {
    int space = 0; ///< 2 or 3 columns of coordinates; 0: no point begins here
    bool has_confidence = false;
    bool other_quantity = false; ///< an angle, a force or a velocity
    bool is_set_apart = false;   ///< the axis, by a separator or as a capital: not as in "max"
    std::string stem;            ///< in lower case
};

/// The columns from `first` on: named x and y, or x, y and z, then perhaps likelihood, confidence
/// or score.
PointColumns point_at(const std::vector<std::string>& names, std::size_t first);

} // namespace stltsa::clip
