// SPDX-License-Identifier: BSD-3-Clause
// Poses as vectors and back: the same body, over the origin, without its yaw.
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clip/body/angles.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/features/features.hpp"
#include "clip/features/pose_code.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

constexpr int frames = 60;

/// The clip with smooth values of this magnitude in every channel except the first `constant`
/// columns.
Clip moving(Clip clip, double degrees, std::int64_t constant = 0) {
    Random random;
    Matrix values(frames, clip.values.cols());
    for (std::int64_t c = 0; c < values.cols(); ++c) {
        const double size = degrees * random.next();
        const double phase = 4 * random.next();
        const double speed = c < constant ? 0 : 0.1 * random.next();
        for (std::int64_t i = 0; i < frames; ++i)
            values(i, c) = size * std::sin(phase + speed * static_cast<double>(i));
    }
    clip.values = values;
    return clip;
}

Clip moving_bvh(std::string_view order, double degrees) {
    std::string text = small_bvh;
    std::string channels;
    for (const char axis : order)
        channels += std::string(" ") + axis + "rotation";
    for (const char* old : {"Zrotation Xrotation Yrotation\n  JOINT Leg",
                            "Zrotation Xrotation Yrotation\n    End Site"})
        text = replaced(text, old, channels + std::string(old).substr(29));
    return moving(parse(text, Format::bvh), degrees);
}

Clip moving_amc(double degrees) {
    const TemporaryFolder folder;
    ReadOptions options;
    options.skeleton = folder.write("two.asf", replaced(small_asf, "dof rx\n", "dof rx rz\n"));
    return moving(
        parse(replaced(replaced(small_amc, "shank 90", "shank 90 1"), "shank 91", "shank 91 1"),
              Format::amc, options),
        degrees);
}

double body_size(const Matrix& positions) {
    double largest = 0;
    for (std::int64_t i = 0; i < positions.rows(); ++i)
        for (std::int64_t c = 0; c < positions.cols(); ++c)
            largest = std::max(largest, std::abs(positions(i, c)));
    return largest;
}

void check_round_trip(const Clip& clip, Axis up) {
    const CodedPoses coded = encode_poses(clip, up);
    const Clip decoded = decode_poses(coded.code, coded.vectors.view(), clip.fps);
    const Matrix wanted = features(clip, Features::positions, up);
    check_same(features(decoded, Features::positions, up), wanted, 1e-9 * body_size(wanted));
    check_same(features(decoded, Features::rotations6d, up),
               features(clip, Features::rotations6d, up), 1e-9);
    assert_true(decoded.fps == clip.fps && decoded.frame_time == clip.frame_time);
    assert_true(decoded.format == clip.format && decoded.channel_names == clip.channel_names);
    // The body root stands over the origin at its height.
    const Matrix before = positions(clip);
    const Matrix after = positions(decoded);
    const auto root = static_cast<std::int64_t>(3 * coded.code.root);
    const auto up_index = static_cast<std::int64_t>(coded.code.up) - 1;
    for (std::int64_t i = 0; i < after.rows(); ++i)
        for (std::int64_t axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(after(i, root + axis), axis == up_index ? before(i, root + axis) : 0,
                        1e-12 * body_size(before));
}

void every_order_of_rotations_comes_back(void**) {
    for (const char* order : {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX", "ZXZ", "YXY"})
        for (const Axis up : {Axis::x, Axis::y, Axis::z})
            for (const double degrees : {20.0, 200.0})
                check_round_trip(moving_bvh(order, degrees), up);
}

void joints_with_few_axes_come_back(void**) {
    check_round_trip(moving_amc(20), Axis::y);
    check_round_trip(moving_amc(200), Axis::y);
}

void joints_that_move_come_back(void**) {
    const std::string text =
        replaced(small_bvh, "CHANNELS 1 Xrotation", "CHANNELS 3 Yposition Xrotation Xposition");
    Clip clip = moving(parse(replaced(replaced(replaced(text, "0 0 0 0 0 0 0", "0 0 0 0 0 0 0 0 0"),
                                               "70\n", "70 1 1\n"),
                                      "71\n", "71 1 1\n"),
                             Format::bvh),
                       50);
    assert_int_equal(encode_poses(clip, Axis::y).code.moves.size(), 2);
    check_round_trip(clip, Axis::y);
    clip.skeleton->joints[3].adds = true;
    check_round_trip(clip, Axis::y);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 9) = 7;
    assert_int_equal(encode_poses(clip, Axis::y).code.moves.size(), 1);
    check_round_trip(clip, Axis::y);
}

/// Two constant joints above the body's root.
Clip moving_below_constant_joints() {
    const std::string above = "HIERARCHY\nROOT scene\n{\nOFFSET 1 2 3\nCHANNELS 6 Xposition "
                              "Yposition Zposition Xrotation Yrotation Zrotation\nJOINT "
                              "armature\n{\nOFFSET 0 1 0\nCHANNELS 1 Xrotation\n";
    std::string text = replaced(small_bvh, "HIERARCHY\nROOT", above + "JOINT");
    text = replaced(text, "MOTION", "}\n}\nMOTION");
    for (const char* row : {"\n1 2 3 0", "\n2 3 4 10", "\n3 4 5 11"})
        text = replaced(text, row, "\n0 0 0 0 0 0 0 " + std::string(row).substr(1));
    return moving(parse(text, Format::bvh), 50, 7);
}

void joints_that_hardly_turn_are_above_the_body(void**) {
    for (const auto& [degrees, root] : {std::pair{1e-4, 2}, {0.1, 0}}) {
        Clip clip = moving_below_constant_joints();
        for (std::int64_t i = 0; i < clip.frames(); ++i)
            clip.values(i, 4) += degrees * static_cast<double>(i % 7);
        assert_int_equal(body_root(clip), root);
    }
}

void constant_joints_above_the_body_stay(void**) {
    const Clip clip = moving_below_constant_joints();
    for (const Axis up : {Axis::x, Axis::y, Axis::z}) {
        assert_int_equal(encode_poses(clip, up).code.root, 2);
        check_round_trip(clip, up);
    }
}

/// The clip turned about the up axis and moved on the floor, by a body root without ancestors.
Clip elsewhere(const Clip& clip, Axis up) {
    Clip result = clip;
    const auto axis = static_cast<std::size_t>(up) - 1;
    Pose pose;
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        const double t = static_cast<double>(i);
        const Quaternion turn = axis_rotation(static_cast<int>(axis), 1 + 0.1 * t);
        pose.place(*clip.skeleton, clip.values.row(i));
        Vec3 place = rotate(turn, pose.position[0]);
        place[(axis + 1) % 3] += 30 - t;
        place[(axis + 2) % 3] += 2 * t;
        const Joint& root = clip.skeleton->joints[0];
        put_position(root, place, result.values.row(i));
        put_rotation(root, clip.skeleton->fixed_axes, turn * pose.world[0], result.values.row(i));
    }
    return result;
}

void poses_have_no_place_and_no_heading(void**) {
    for (const Axis up : {Axis::x, Axis::y, Axis::z})
        for (const Clip& clip : {moving_bvh("ZXY", 40), moving_amc(40)})
            check_same(encode_poses(elsewhere(clip, up), up).vectors,
                       encode_poses(clip, up).vectors, 1e-10);
}

void vectors_are_continuous(void**) {
    // Angles up to 200 degrees in steps of at most 20, which jump by whole turns in the file.
    Clip clip = moving_bvh("ZXY", 200);
    const Matrix smooth = encode_poses(clip, Axis::y).vectors;
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::int64_t c = 3; c < clip.values.cols(); ++c)
            clip.values(i, c) = std::remainder(clip.values(i, c), 360);
    check_same(encode_poses(clip, Axis::y).vectors, smooth, 1e-10);
    // One and a half turns of a joint: the logarithm continues beyond half a turn.
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 9) = 9 * static_cast<double>(i);
    const CodedPoses coded = encode_poses(clip, Axis::y);
    const std::int64_t arm = coded.code.size() - 3;
    for (std::int64_t i = 1; i < clip.frames(); ++i)
        ASSERT_NEAR(coded.vectors(i, arm) - coded.vectors(i - 1, arm), 9 * std::numbers::pi / 180,
                    1e-9);
    check_round_trip(clip, Axis::y);
}

void the_zero_vector_is_the_mean_pose(void**) {
    const CodedPoses coded = encode_poses(moving_bvh("ZXY", 20), Axis::y);
    for (std::int64_t c = 1; c < coded.vectors.cols(); ++c) {
        double mean = 0;
        for (std::int64_t i = 0; i < frames; ++i)
            mean += coded.vectors(i, c) / frames;
        ASSERT_NEAR(mean, 0, 0.01); // logarithm and chord differ in third order
    }
}

void a_single_frame_is_decoded_as_among_others(void**) {
    for (const Clip& clip :
         {moving_bvh("ZXY", 100), moving_amc(100), moving_below_constant_joints()})
        for (const Features kind : {Features::positions, Features::rotations6d}) {
            const CodedPoses coded = encode_poses(clip, Axis::y);
            const Matrix all = features(clip, kind, Axis::y);
            for (std::int64_t i = 0; i < frames; i += 7) {
                const Clip one =
                    decode_poses(coded.code, coded.vectors.view().block(i, 1), clip.fps);
                const Matrix alone = pose_features(coded.code, one, kind);
                assert_int_equal(alone.cols(), all.cols());
                for (std::int64_t c = 0; c < all.cols(); ++c)
                    ASSERT_NEAR(alone(0, c), all(i, c), 1e-10);
            }
        }
}

void angles_do_not_jump(void**) {
    Clip clip = moving_bvh("ZXY", 80);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 9) = 9 * static_cast<double>(i); // beyond a whole turn
    const CodedPoses coded = encode_poses(clip, Axis::y);
    const Clip decoded = decode_poses(coded.code, coded.vectors.view(), clip.fps);
    for (std::int64_t i = 1; i < frames; ++i) {
        for (std::int64_t c = 6; c < 9; ++c)
            ASSERT_NEAR(decoded.values(i, c), clip.values(i, c), 1e-9);
        ASSERT_NEAR(decoded.values(i, 9) - decoded.values(i - 1, 9), 9, 1e-9);
    }
}

void the_frame_time_is_kept_for_its_rate(void**) {
    const CodedPoses coded = encode_poses(parse(small_bvh, Format::bvh), Axis::y);
    assert_true(decode_poses(coded.code, coded.vectors.view(), 120).frame_time == 0.0083333);
    assert_true(decode_poses(coded.code, coded.vectors.view(), 30).frame_time == 0);
}

void clips_and_vectors_that_do_not_fit_are_refused(void**) {
    ASSERT_FAILS(Status::unsupported, "need a skeleton",
                 encode_poses(parse("1,2\n3,4\n", Format::csv), Axis::y));
    const CodedPoses coded = encode_poses(parse(small_bvh, Format::bvh), Axis::y);
    ASSERT_FAILS(Status::shape, "the pose vectors have 3 numbers; expected 10",
                 decode_poses(coded.code, Matrix(1, 3).view(), 120));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(every_order_of_rotations_comes_back),
        cmocka_unit_test(joints_with_few_axes_come_back),
        cmocka_unit_test(joints_that_move_come_back),
        cmocka_unit_test(constant_joints_above_the_body_stay),
        cmocka_unit_test(joints_that_hardly_turn_are_above_the_body),
        cmocka_unit_test(poses_have_no_place_and_no_heading),
        cmocka_unit_test(vectors_are_continuous),
        cmocka_unit_test(the_zero_vector_is_the_mean_pose),
        cmocka_unit_test(a_single_frame_is_decoded_as_among_others),
        cmocka_unit_test(angles_do_not_jump),
        cmocka_unit_test(the_frame_time_is_kept_for_its_rate),
        cmocka_unit_test(clips_and_vectors_that_do_not_fit_are_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
