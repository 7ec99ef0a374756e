// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "clip/arrays/arrays.hpp"
#include "clip/body/angles.hpp"
#include "clip/body/quaternion.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Largest deviation of a quaternion's length, or of a matrix's columns, from those of a rotation:
/// numbers rounded to two digits pass, other quantities do not.
constexpr double most_deviation = 0.05;

std::int64_t expected_columns(const SkeletonArrays& arrays) {
    const auto count = std::ssize(arrays.skeleton.joints);
    switch (arrays.form) {
    case RotationForm::quaternions:
        return 4 * count;
    case RotationForm::matrices:
        return 9 * count;
    case RotationForm::channels:
        return channel_count(arrays.skeleton);
    }
    fail(Status::argument, "form is {}; expected STLTSA_ROTATIONS_*",
         static_cast<int>(arrays.form));
}

void check_hierarchy(const Skeleton& skeleton) {
    if (skeleton.joints.empty())
        fail(Status::argument, "a skeleton needs at least one joint");
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
        const Joint& joint = skeleton.joints[j];
        if (joint.name.empty())
            fail(Status::argument, "joint {} has no name", j);
        if (j == 0 ? joint.parent != -1 : joint.parent < 0 || joint.parent >= static_cast<int>(j))
            fail(Status::argument,
                 "joint {} ({}) has parent {}: joint 0 is the root, with parent -1, and parents "
                 "come before their children",
                 j, in_quotes(joint.name), joint.parent);
        for (const double value : joint.offset)
            if (!std::isfinite(value))
                fail(Status::not_finite, "the offset of joint {} ({}) is {}", j,
                     in_quotes(joint.name), value);
    }
    if (channel_count(skeleton) == 0)
        fail(Status::argument, "no joint has a channel: the skeleton cannot move");
}

void check_arrays(const SkeletonArrays& arrays) {
    const std::int64_t columns = expected_columns(arrays);
    if (arrays.rotations.rows < 1 || arrays.rotations.cols != columns)
        fail(Status::shape,
             "rotations have {} rows and {} columns: expected a row for each frame "
             "and {} columns for {} joints",
             arrays.rotations.rows, arrays.rotations.cols, columns, arrays.skeleton.joints.size());
    const bool has_root = arrays.root.rows > 0;
    if (has_root && (arrays.root.rows != arrays.rotations.rows || arrays.root.cols != 3))
        fail(Status::shape, "root positions have {} rows and {} columns: expected {} x 3",
             arrays.root.rows, arrays.root.cols, arrays.rotations.rows);
    if (has_root && arrays.form == RotationForm::channels)
        fail(Status::argument, "root positions are among the channels: give no others");
    const auto& of_root = arrays.skeleton.joints[0].channels;
    if (has_root && std::count_if(of_root.begin(), of_root.end(),
                                  [](Channel c) { return !is_rotation(c); }) != 3)
        fail(Status::argument, "joint 0 ({}) has no channels tx ty tz for root positions",
             in_quotes(arrays.skeleton.joints[0].name));
    for (const ConstMatrixView& view : {arrays.rotations, arrays.root})
        for (std::int64_t i = 0; i < view.rows; ++i)
            for (std::int64_t c = 0; c < view.cols; ++c)
                if (!std::isfinite(view(i, c)))
                    fail(Status::not_finite, "{}: frame {}, column {} is {}: fill gaps before",
                         view.data == arrays.root.data ? "root positions" : "rotations", i, c,
                         view(i, c));
}

Quaternion normalized(Quaternion q, double length) {
    return {q.w / length, q.x / length, q.y / length, q.z / length};
}

/// The largest of the four components is found first, so that no small number is divided by
/// (Shepperd, "Quaternion from rotation matrix", 1978).
Quaternion from_matrix(const double* m) {
    const double trace = m[0] + m[4] + m[8];
    const double squares[] = {1 + trace, 1 + 2 * m[0] - trace, 1 + 2 * m[4] - trace,
                              1 + 2 * m[8] - trace};                      // 4 w^2, 4 x^2, ...
    const double sums[] = {m[3] + m[1], m[6] + m[2], m[7] + m[5]};        // 4 xy, 4 xz, 4 yz
    const double differences[] = {m[7] - m[5], m[2] - m[6], m[3] - m[1]}; // 4 wx, 4 wy, 4 wz
    switch (std::max_element(std::begin(squares), std::end(squares)) - squares) {
    case 0:
        return {squares[0], differences[0], differences[1], differences[2]};
    case 1:
        return {differences[0], squares[1], sums[0], sums[1]};
    case 2:
        return {differences[1], sums[0], squares[2], sums[2]};
    default:
        return {differences[2], sums[1], sums[2], squares[3]};
    }
}

/// Largest deviation of M' M from the identity; large as well for a reflection.
double deviation_of(const double* m) {
    double most = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            const double product = m[i] * m[k] + m[3 + i] * m[3 + k] + m[6 + i] * m[6 + k];
            most = std::max(most, std::abs(product - (i == k ? 1 : 0)));
        }
    const double determinant =
        dot(Vec3{m[0], m[1], m[2]}, cross(Vec3{m[3], m[4], m[5]}, Vec3{m[6], m[7], m[8]}));
    return std::max(most, std::abs(determinant - 1));
}

/// The local rotation of a joint. `deviation`: from a rotation.
Quaternion rotation_at(RotationForm form, const double* row, std::size_t joint, double& deviation) {
    if (form == RotationForm::matrices) {
        deviation = deviation_of(row + 9 * joint);
        const Quaternion q = from_matrix(row + 9 * joint);
        return normalized(q, std::sqrt(dot(q, q)));
    }
    const double* v = row + 4 * joint;
    const Quaternion q{v[0], v[1], v[2], v[3]};
    const double length = std::sqrt(dot(q, q));
    deviation = std::abs(length - 1);
    return normalized(q, length);
}

/// Channel values of a frame; `row` holds those of the previous one. `local`: room.
void put_frame(const SkeletonArrays& arrays, std::int64_t frame, std::span<Quaternion> local,
               double* row) {
    const Skeleton& skeleton = arrays.skeleton;
    if (const std::size_t wrong =
            read_rotations(skeleton, arrays.form, arrays.rotations.row(frame), local);
        wrong < local.size())
        fail(Status::argument, "frame {}: {}", frame, no_rotation(skeleton, arrays.form, wrong));
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
        const Joint& joint = skeleton.joints[j];
        Vec3 place = joint.offset;
        if (j == 0 && arrays.root.rows > 0)
            std::copy_n(arrays.root.row(frame), 3, place.begin());
        put_position(joint, place, row);
        put_rotation(joint, false, local[j], row);
        row += joint.channels.size();
    }
}

} // namespace

Clip clip_from_skeleton(const SkeletonArrays& arrays) {
    check_hierarchy(arrays.skeleton);
    check_arrays(arrays);
    Clip clip;
    clip.format = Format::skeleton;
    clip.fps = arrays.fps;
    clip.skeleton = arrays.skeleton;
    clip.channel_names = channel_names(arrays.skeleton);
    if (arrays.form == RotationForm::channels) {
        clip.values = copied(arrays.rotations);
        return clip;
    }
    clip.values = Matrix(arrays.rotations.rows, channel_count(arrays.skeleton));
    std::vector<Quaternion> local(arrays.skeleton.joints.size());
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        if (i > 0)
            std::copy_n(clip.values.row(i - 1), clip.values.cols(), clip.values.row(i));
        put_frame(arrays, i, local, clip.values.row(i));
    }
    return clip;
}

std::size_t read_rotations(const Skeleton& skeleton, RotationForm form, const double* numbers,
                           std::span<Quaternion> local) {
    for (std::size_t j = 0; j < local.size(); ++j) {
        double deviation = 0;
        local[j] = {};
        if (skeleton.joints[j].channels.empty())
            continue;
        local[j] = rotation_at(form, numbers, j, deviation);
        if (!(deviation <= most_deviation))
            return j;
    }
    return local.size();
}

std::string no_rotation(const Skeleton& skeleton, RotationForm form, std::size_t joint) {
    return format_text("the {} of joint {} ({}) is no rotation, whose {}",
                       form == RotationForm::matrices ? "matrix" : "quaternion", joint,
                       in_quotes(skeleton.joints[joint].name),
                       form == RotationForm::matrices ? "columns are at right angles, of length 1"
                                                      : "length is 1");
}

} // namespace stltsa::clip
