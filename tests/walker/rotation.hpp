// SPDX-License-Identifier: BSD-3-Clause
// Vectors and rotation matrices of the walker. Axes as in BVH files: x to the walker's left,
// y up, z forward; a rotation acts on column vectors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace walker {

constexpr double radian = std::numbers::pi / 180;

struct Vector {
    double x = 0;
    double y = 0;
    double z = 0;
};

inline Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(double s, Vector a) {
    return {s * a.x, s * a.y, s * a.z};
}

using Rotation = std::array<std::array<double, 3>, 3>;

inline Rotation identity() {
    return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

/// Rotation about one axis (0: x, 1: y, 2: z), by the right-hand rule.
inline Rotation about(std::size_t axis, double degrees) {
    const double c = std::cos(degrees * radian);
    const double s = std::sin(degrees * radian);
    const std::size_t next = (axis + 1) % 3;
    const std::size_t last = (axis + 2) % 3;
    Rotation r{};
    r[axis][axis] = 1;
    r[next][next] = r[last][last] = c;
    r[last][next] = s;
    r[next][last] = -s;
    return r;
}
inline Rotation about_x(double degrees) {
    return about(0, degrees);
}
inline Rotation about_y(double degrees) {
    return about(1, degrees);
}
inline Rotation about_z(double degrees) {
    return about(2, degrees);
}

inline Rotation operator*(const Rotation& a, const Rotation& b) {
    Rotation r{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            r[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    return r;
}

inline Vector operator*(const Rotation& r, Vector v) {
    return {r[0][0] * v.x + r[0][1] * v.y + r[0][2] * v.z,
            r[1][0] * v.x + r[1][1] * v.y + r[1][2] * v.z,
            r[2][0] * v.x + r[2][1] * v.y + r[2][2] * v.z};
}

inline Rotation inverse(const Rotation& r) {
    return {
        {{r[0][0], r[1][0], r[2][0]}, {r[0][1], r[1][1], r[2][1]}, {r[0][2], r[1][2], r[2][2]}}};
}

/// Angles a, b, c in degrees with r = R(order[0], a) R(order[1], b) R(order[2], c), b within +-90;
/// `order` is a permutation of "XYZ", like the channels of a BVH joint.
inline std::array<double, 3> euler(const Rotation& r, std::string_view order) {
    const auto axis = [&](std::size_t n) { return static_cast<std::size_t>(order[n] - 'X'); };
    const std::size_t i = axis(0);
    const std::size_t j = axis(1);
    const std::size_t k = axis(2);
    const double sign = (i + 1) % 3 == j ? 1 : -1;
    const double a = std::atan2(-sign * r[j][k], r[k][k]);
    const double b = std::asin(std::clamp(sign * r[i][k], -1.0, 1.0));
    const double c = std::atan2(-sign * r[i][j], r[i][i]);
    return {a / radian, b / radian, c / radian};
}

} // namespace walker
