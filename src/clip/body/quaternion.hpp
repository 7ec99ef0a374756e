// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// The rotation b followed by the rotation a.
inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// The inverse of a unit quaternion.
inline Quaternion conjugate(const Quaternion& q) {
    return {q.w, -q.x, -q.y, -q.z};
}

inline double dot(const Quaternion& a, const Quaternion& b) {
    return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Component of the vector part along coordinate axis 0, 1 or 2.
inline double component(const Quaternion& q, int axis) {
    return axis == 0 ? q.x : axis == 1 ? q.y : q.z;
}

/// The rotation about coordinate axis 0, 1 or 2.
inline Quaternion axis_rotation(int axis, double radians) {
    const double c = std::cos(radians / 2);
    const double s = std::sin(radians / 2);
    return {c, axis == 0 ? s : 0, axis == 1 ? s : 0, axis == 2 ? s : 0};
}

inline double dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vec3 operator*(double s, const Vec3& v) {
    return {s * v[0], s * v[1], s * v[2]};
}

inline double norm(const Vec3& v) {
    return std::hypot(v[0], v[1], v[2]);
}

/// v turned by the unit quaternion q.
inline Vec3 rotate(const Quaternion& q, const Vec3& v) {
    const Vec3 u{q.x, q.y, q.z};
    const Vec3 t = 2 * cross(u, v);
    return v + q.w * t + cross(u, t);
}

/// The exponential map: the rotation about a vector by its length in radians.
inline Quaternion rotation_by(const Vec3& vector) {
    const double angle = norm(vector);
    const double s = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
    return {std::cos(angle / 2), s * vector[0], s * vector[1], s * vector[2]};
}

/// Its inverse, the logarithm. The vectors of a rotation differ by whole turns; this is the one
/// nearest to `near`.
inline Vec3 rotation_vector(const Quaternion& q, const Vec3& near = {}) {
    const Vec3 v{q.x, q.y, q.z};
    const double size = norm(v);
    if (size == 0)
        return {};
    constexpr double turn = 2 * std::numbers::pi;
    const Vec3 axis = (1 / size) * v;
    const double angle = 2 * std::atan2(size, q.w);
    return (angle + turn * std::round((dot(axis, near) - angle) / turn)) * axis;
}

} // namespace stltsa::clip
