// SPDX-License-Identifier: BSD-3-Clause
// Poses as vectors that may be averaged and regressed, and back.
#pragma once

#include <cstdint>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// What the poses of one clip have in common. A pose vector holds, for every joint that turns, the
/// logarithm (axis times angle, radians) of its rotation relative to its mean over the clip, the
/// body root's with the yaw taken away, and the body root's height: small numbers, continuous over
/// time, in which lines are poses.
struct PoseCode {
    Format format = Format::bvh;
    Skeleton skeleton;
    std::vector<std::string> channel_names;
    Axis up = Axis::y;
    double frame_time = 0;         ///< of the source clip; 0: 1 / fps
    std::vector<double> rest;      ///< a row of the clip: what poses do not say stays as it is here
    std::vector<Quaternion> means; ///< per joint that turns, body root included

    std::int64_t size() const; ///< of a pose vector
};

/// The code of a clip, which has a skeleton, and the pose vectors of all its frames.
struct CodedPoses {
    PoseCode code;
    Matrix vectors; ///< frames x code.size()
};
CodedPoses encode_poses(const Clip& clip, Axis up);

/// A clip of these poses: the body root over the origin, at its height, yaw taken away.
Clip decode_poses(const PoseCode& code, ConstMatrixView vectors, double fps);

} // namespace stltsa::clip
