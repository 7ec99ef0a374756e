// SPDX-License-Identifier: BSD-3-Clause
// Converts poses to vectors that can be averaged and regressed, and back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features/features.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// The code by which the poses of a clip become vectors. A pose vector contains
/// - the height of the body root;
/// - for the body root and every rotating joint after it, the logarithm (axis times angle, radians)
///   of its rotation relative to its mean over the clip; that of the body root in the world, with
///   the yaw removed;
/// - the position channels below the body root that change over the clip (most clips have none).
/// These are small numbers, continuous over time, and points between two poses are poses.
struct PoseCode {
    Format format = Format::bvh;
    Skeleton skeleton;
    std::vector<std::string> channel_names;
    Axis up = Axis::y;
    double frame_time = 0; ///< of the source clip; 0: 1 / fps
    std::vector<double>
        rest;             ///< a row of the clip: supplies the values that poses do not determine
    std::size_t root = 0; ///< the body root (heading.hpp)
    std::vector<Quaternion> means;  ///< of turning_joints(skeleton, root)
    std::vector<std::size_t> moves; ///< columns of the position channels in the vector

    std::int64_t size() const; ///< length of a pose vector
};

/// The code of a clip that has a skeleton, and the pose vectors of all its frames.
struct CodedPoses {
    PoseCode code;
    Matrix vectors; ///< frames x code.size()
};
CodedPoses encode_poses(const Clip& clip, std::optional<Axis> up);

/// A clip of these poses, with the body root above the origin and without yaw. Angles are those
/// nearest to the previous row; for the first row, nearest to `rest`.
Clip decode_poses(const PoseCode& code, ConstMatrixView vectors, double fps);

/// Features of decoded poses, with the same columns as for the encoded clip. (features() would
/// search these frames for the body root, and few frames may not determine it.)
Matrix pose_features(const PoseCode& code, const Clip& poses, Features kind);

} // namespace stltsa::clip
