// SPDX-License-Identifier: BSD-3-Clause
// Poses as vectors that may be averaged and regressed, and back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// What the poses of one clip have in common. A pose vector holds
/// - the height of the body root;
/// - for every joint that turns, from the body root on, the logarithm (axis times angle, radians)
///   of its rotation relative to its mean over the clip; the body root's in the world, with the yaw
///   taken away;
/// - the position channels below the body root that change over the clip (most clips have none).
/// So they are small numbers, continuous over time, in which lines are poses.
struct PoseCode {
    Format format = Format::bvh;
    Skeleton skeleton;
    std::vector<std::string> channel_names;
    Axis up = Axis::y;
    double frame_time = 0;         ///< of the source clip; 0: 1 / fps
    std::vector<double> rest;      ///< a row of the clip: what poses do not say stays as it is here
    std::size_t root = 0;          ///< the body root (heading.hpp)
    std::vector<Quaternion> means; ///< of turning_joints(skeleton, root)
    std::vector<std::size_t> moves; ///< columns of the position channels in the vector

    std::int64_t size() const; ///< of a pose vector
};

/// The code of a clip, which has a skeleton, and the pose vectors of all its frames.
struct CodedPoses {
    PoseCode code;
    Matrix vectors; ///< frames x code.size()
};
CodedPoses encode_poses(const Clip& clip, Axis up);

/// A clip of these poses: the body root over the origin, at its height, yaw taken away. Angles are
/// the nearest to those of the row before, the first row's to `rest`.
Clip decode_poses(const PoseCode& code, ConstMatrixView vectors, double fps);

/// Features of decoded poses, column by column those of the clip that was encoded. (features()
/// would look for the body root among these frames, and few frames may not show it.)
Matrix pose_features(const PoseCode& code, const Clip& poses, Features kind);

} // namespace stltsa::clip
