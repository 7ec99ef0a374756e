// SPDX-License-Identifier: BSD-3-Clause
// For the walker's own tests: reads its output as another program would.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body.hpp"
#include "walker.hpp"

namespace walker {

inline const double* row(const Walk& walk, std::int64_t frame) {
    return &walk.channels[static_cast<std::size_t>(frame) * channel_count];
}

inline bool same_row(const Walk& a, std::int64_t i, const Walk& b, std::int64_t j) {
    return std::equal(row(a, i), row(a, i) + channel_count, row(b, j));
}

inline const Interval& unit(const Walk& walk, const char* kind) {
    for (const Interval& u : walk.units)
        if (u.kind == kind)
            return u;
    throw std::out_of_range(kind);
}

struct Joints {
    std::array<Vector, joint_count> at;
    std::array<Rotation, joint_count> turned;
};

/// Forward kinematics from the channels alone, as a reader of the file computes it.
inline Joints joints(const Walk& walk, std::int64_t frame) {
    const Body body = make_body(walk.settings.height);
    const double* channel = row(walk, frame);
    Joints j;
    for (std::size_t n = 0; n < joint_count; ++n) {
        Rotation local = identity();
        for (std::size_t c = 0; c < 3; ++c)
            local = local * about(static_cast<std::size_t>(walk.settings.order[c] - 'X'),
                                  channel[3 + 3 * n + c]);
        const auto parent = static_cast<std::size_t>(body[n].parent);
        const bool root = body[n].parent < 0;
        j.turned[n] = root ? local : j.turned[parent] * local;
        j.at[n] = root ? Vector{channel[0], channel[1], channel[2]}
                       : j.at[parent] + j.turned[parent] * body[n].offset;
    }
    return j;
}

inline Vector ankle(const Joints& j, Side side) {
    return j.at[thigh(side) + 2];
}
inline Vector ball(const Joints& j, Side side) {
    return j.at[thigh(side) + 3];
}
inline Vector heel(const Joints& j, Side side, double height) {
    return ankle(j, side) + j.turned[thigh(side) + 2] * make_sole(height).heel;
}
inline double distance(Vector a, Vector b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// Distance of the left ankle ahead of the right one, along the heading.
inline double ahead(const Joints& j) {
    const Vector apart = ankle(j, left) - ankle(j, right);
    const Vector wide = j.at[left_thigh] - j.at[right_thigh]; // turns cancel over a cycle
    return (apart.z * wide.x - apart.x * wide.z) / std::hypot(wide.x, wide.z);
}

} // namespace walker
