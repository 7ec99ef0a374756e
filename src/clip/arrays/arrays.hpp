// SPDX-License-Identifier: BSD-3-Clause
// Clips from a caller's arrays: a skeleton with rotations, or points in space.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Same values as STLTSA_ROTATIONS_* (checked in capi).
enum class RotationForm : std::int32_t {
    quaternions = 1, ///< 4 columns a joint: w x y z, child axes to parent axes
    matrices = 2,    ///< 9 columns a joint: rows of the rotation matrix
    channels = 3,    ///< a column for each channel: file units, degrees
};

struct SkeletonArrays {
    Skeleton skeleton;
    RotationForm form = RotationForm::quaternions;
    ConstMatrixView rotations;
    ConstMatrixView root; ///< frames x 3, positions of joint 0; no rows: it stays at its offset
    double fps = 0;
};

/// Throws Status::shape, argument, not_finite.
Clip clip_from_skeleton(const SkeletonArrays& arrays);

/// Sets the local rotations of a frame of quaternions or matrices; joints without channels have
/// none. Gives the first joint whose numbers are no rotation, or the number of joints.
std::size_t read_rotations(const Skeleton& skeleton, RotationForm form, const double* numbers,
                           std::span<Quaternion> local);
/// The text of the error that says so.
std::string no_rotation(const Skeleton& skeleton, RotationForm form, std::size_t joint);

struct PointArrays {
    ConstMatrixView positions; ///< frames x (space * points); NaN: missing
    int space = 3;             ///< coordinates of a point, 2 or 3
    std::vector<std::string> names;
    ConstMatrixView confidence; ///< frames x points; no rows: all points are seen
    double min_confidence = 0;  ///< a point with less, or with 0, is missing
    ConstMatrixView times;      ///< frames x 1, seconds; no rows: frames are 1 / fps apart
    double fps = 0;             ///< 0: given by the times, which it must agree with
};

/// Throws Status::shape, argument, not_finite.
Clip clip_from_points(const PointArrays& arrays);

/// Sets the points that are seen with less confidence than this, or with none, to NaN, and returns
/// their number. `confidence`: frames x points.
std::int64_t drop_unsure(Matrix& positions, int space, ConstMatrixView confidence,
                         double min_confidence);

/// "heel_x", "heel_y", ... for each name.
std::vector<std::string> coordinate_names(const std::vector<std::string>& points, int space);

} // namespace stltsa::clip
