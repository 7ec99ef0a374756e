// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip {

/// Fewer points have no shape whose path and heading could be removed.
constexpr std::int64_t least_points = 3;

/// Whether the text is x, y or z.
bool is_axis(std::string_view text);

/// The name of a coordinate, not empty, without its axis: "heel" of "heel_x".
std::string_view point_name(std::string_view coordinate);

/// The unit after a name: "mm" of "heel_x [mm]", "heel_x (mm)" and "heel_x_mm"; empty: none.
std::string_view unit_of(std::string_view name);

/// The name without the unit.
std::string_view without_unit(std::string_view name);

/// Whether a unit is one of length, such as "mm".
bool is_length_unit(std::string_view unit);

/// Whether a unit is that of an angle, a force or another quantity that is not a length.
bool is_other_unit(std::string_view unit);

/// Where the names have the axis: after the point, as "heel_x", "heel.Y", "heel z", "heelX",
/// "heel:x", "heel[0]", "heel (x)", as a number from 1, as "heel[1]", or before it, as "x_heel",
/// "X.heel", "xHeel", "x1", "pos_x_heel". In the other places, what looks like an axis may be none:
/// a number from 0 or from 1, as "heel_0", of joints of a finger; or between two words, as
/// "v_x_heel".
enum class AxisPlace { last, counted, first, numbered, numbered_from_1, between };

/// A column that is named as the coordinate of a point.
struct Coordinate {
    std::string point;         ///< without axis and unit, as written; empty: it is not named so
    std::string name;          ///< with its axis last: "heel_x" of "x_heel" and "heel[0]"
    std::size_t axis = 0;      ///< 0, 1, 2 for x, y, z
    bool is_set_apart = false; ///< the axis, by a separator or as a capital: not as in "max"
};

Coordinate coordinate_of(std::string_view column, AxisPlace place);

/// The point that a column of likelihood, confidence or score belongs to, "nose" of "nose_score".
/// Empty: it is not named so.
std::string_view point_of_confidence(std::string_view column);

/// Whether a word in lower case is one for angles, such as "rot" and "angles".
bool is_angle(std::string_view word);

/// Whether the name is that of a sensor or a result of a model, such as "hip angle", and not of a
/// point.
bool is_other_quantity(std::string_view point);

/// Whether the column and two beside it are named as the coordinates of one point, with their axes
/// last, in any order.
bool names_coordinate(const std::vector<std::string>& names, std::size_t column);

} // namespace stltsa::clip
