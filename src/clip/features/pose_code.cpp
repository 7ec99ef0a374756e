// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/pose_code.hpp"

#include <algorithm>

#include "clip/body/angles.hpp"
#include "clip/body/heading.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/features.hpp"
#include "clip/text/number.hpp"
#include "linalg/eigen.hpp"

namespace stltsa::clip {
namespace {

using Rotations = std::vector<Quaternion>; ///< of one joint, one per frame

/// Index of the first logarithm in a pose vector.
constexpr std::int64_t first_turn = 1;

std::size_t up_index(Axis up) {
    return static_cast<std::size_t>(up) - 1;
}

/// The rotation with the least sum of squared (chordal) distances to these: the principal
/// eigenvector of the sum of q q^T (Markley et al., "Averaging Quaternions", 2007).
Quaternion mean_rotation(const Rotations& rotations) {
    Matrix sum(4, 4);
    for (const Quaternion& q : rotations) {
        const double components[] = {q.w, q.x, q.y, q.z};
        for (std::int64_t i = 0; i < 4; ++i)
            for (std::int64_t j = 0; j < 4; ++j)
                sum(i, j) += components[i] * components[j];
    }
    std::vector<double> values;
    symmetric_eigen(sum, values);
    const double* largest = sum.row(3);
    return {largest[0], largest[1], largest[2], largest[3]};
}

/// Columns of the position channels below the body root that change.
std::vector<std::size_t> moving_columns(const Clip& clip, std::size_t root) {
    std::vector<std::size_t> columns;
    const std::vector<Joint>& joints = clip.skeleton->joints;
    const std::vector<std::size_t> begins = channel_begins(*clip.skeleton);
    const auto changes = [&clip](std::size_t column) {
        const double* first = clip.values.data() + column;
        for (std::int64_t frame = 1; frame < clip.frames(); ++frame)
            if (first[frame * clip.values.cols()] != *first)
                return true;
        return false;
    };
    for (std::size_t j = root + 1; j < joints.size(); ++j)
        for (std::size_t c = 0; c < joints[j].channels.size(); ++c)
            if (!is_rotation(joints[j].channels[c]) && changes(begins[j] + c))
                columns.push_back(begins[j] + c);
    return columns;
}

class Encoder {
  public:
    Encoder(const Clip& clip, std::optional<Axis> up) : clip_(clip) {
        code_.format = clip.format;
        code_.skeleton = *clip.skeleton;
        code_.channel_names = clip.channel_names;
        code_.up = up_axis(clip, up);
        code_.frame_time = clip.frame_time;
        code_.root = body_root(clip);
        code_.moves = moving_columns(clip, code_.root);
        joints_ = turning_joints(code_.skeleton, code_.root);
    }

    CodedPoses encode() {
        code_.means.resize(joints_.size());
        vectors_ = Matrix(clip_.frames(), code_.size());
        place_frames();
        for (std::size_t t = 0; t < joints_.size(); ++t)
            put_logarithms(t);
        put_moves();
        const double* typical = clip_.values.row(most_typical_frame());
        code_.rest.assign(typical, typical + clip_.values.cols());
        return {std::move(code_), std::move(vectors_)};
    }

  private:
    /// Computes the heights and the rotations of all joints.
    void place_frames() {
        rotations_.assign(joints_.size(), Rotations());
        Heading heading(clip_, code_.root, code_.up);
        Pose pose;
        for (std::int64_t frame = 0; frame < clip_.frames(); ++frame) {
            pose.place(code_.skeleton, clip_.values.row(frame));
            const Quaternion back = conjugate(heading.next(pose));
            vectors_(frame, 0) = pose.position[code_.root][up_index(code_.up)];
            for (std::size_t t = 0; t < joints_.size(); ++t)
                rotations_[t].push_back(joints_[t] == code_.root ? back * pose.world[code_.root]
                                                                 : pose.local[joints_[t]]);
        }
    }

    void put_logarithms(std::size_t t) {
        code_.means[t] = mean_rotation(rotations_[t]);
        Vec3 vector{};
        for (std::int64_t frame = 0; frame < clip_.frames(); ++frame) {
            const Quaternion& rotation = rotations_[t][static_cast<std::size_t>(frame)];
            vector = rotation_vector(conjugate(code_.means[t]) * rotation, vector);
            std::copy(vector.begin(), vector.end(),
                      vectors_.row(frame) + first_turn + 3 * static_cast<std::int64_t>(t));
        }
    }

    void put_moves() {
        for (std::int64_t frame = 0; frame < clip_.frames(); ++frame) {
            double* out = vectors_.row(frame) + code_.size() - code_.moves.size();
            for (const std::size_t column : code_.moves)
                *out++ = clip_.values.row(frame)[column];
        }
    }

    /// The frame nearest to the mean rotations, and so not a T-pose at the start.
    std::int64_t most_typical_frame() const {
        std::int64_t best = 0;
        double least = -1;
        for (std::int64_t frame = 0; frame < clip_.frames(); ++frame) {
            double distance = 0;
            for (std::size_t c = 0; c < 3 * joints_.size(); ++c) {
                const double turn = vectors_.row(frame)[first_turn + c];
                distance += turn * turn;
            }
            if (least < 0 || distance < least) {
                least = distance;
                best = frame;
            }
        }
        return best;
    }

    const Clip& clip_;
    PoseCode code_;
    std::vector<std::size_t> joints_;
    std::vector<Rotations> rotations_; ///< per turning joint
    Matrix vectors_;
};

class Decoder {
  public:
    explicit Decoder(const PoseCode& code)
        : code_(code), begins_(channel_begins(code.skeleton)),
          joints_(turning_joints(code.skeleton, code.root)) {
        Pose above;
        above.place(code.skeleton, code.rest.data(), code.root);
        if (code.root > 0) {
            const int parent = code.skeleton.joints[code.root].parent;
            parent_rotation_ = above.world[static_cast<std::size_t>(parent)];
        }
    }

    /// Writes a pose into a row, which contains the previous row.
    void put(const double* vector, double* row) const {
        put_height(*vector, row);
        const double* turn = vector + first_turn;
        for (std::size_t t = 0; t < joints_.size(); ++t, turn += 3) {
            const std::size_t j = joints_[t];
            Quaternion rotation = code_.means[t] * rotation_by({turn[0], turn[1], turn[2]});
            if (j == code_.root)
                rotation = conjugate(parent_rotation_) * rotation;
            put_rotation(code_.skeleton.joints[j], code_.skeleton.fixed_axes, rotation,
                         row + begins_[j]);
        }
        for (const std::size_t column : code_.moves)
            row[column] = *turn++;
    }

  private:
    void put_height(double height, double* row) const {
        Vec3 place{};
        place[up_index(code_.up)] = height;
        put_world_position(code_.skeleton, code_.root, place, row);
    }

    const PoseCode& code_;
    std::vector<std::size_t> begins_;
    std::vector<std::size_t> joints_;
    Quaternion parent_rotation_; ///< of the body root
};

} // namespace

std::int64_t PoseCode::size() const {
    return first_turn + static_cast<std::int64_t>(3 * means.size() + moves.size());
}

CodedPoses encode_poses(const Clip& clip, std::optional<Axis> up) {
    if (!clip.skeleton)
        fail(Status::unsupported, "poses need a skeleton: this clip is a bare matrix");
    return Encoder(clip, up).encode();
}

Clip decode_poses(const PoseCode& code, ConstMatrixView vectors, double fps) {
    if (vectors.cols != code.size())
        fail(Status::shape, "the pose vectors have {} numbers; expected {}", vectors.cols,
             code.size());
    Clip clip;
    clip.format = code.format;
    clip.skeleton = code.skeleton;
    clip.channel_names = code.channel_names;
    clip.fps = fps;
    if (rate_of(code.frame_time) == fps)
        clip.frame_time = code.frame_time;
    Matrix values(vectors.rows, static_cast<std::int64_t>(code.rest.size()));
    const Decoder decoder(code);
    const double* before = code.rest.data();
    for (std::int64_t i = 0; i < vectors.rows; ++i) {
        std::copy_n(before, values.cols(), values.row(i));
        decoder.put(vectors.row(i), values.row(i));
        before = values.row(i);
    }
    clip.values = std::move(values);
    return clip;
}

Matrix pose_features(const PoseCode& code, const Clip& poses, Features kind) {
    return body_features(poses, feature_kind(poses, kind), Heading(code.root));
}

} // namespace stltsa::clip
