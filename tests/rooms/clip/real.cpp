// SPDX-License-Identifier: BSD-3-Clause
// Clips of the CMU motion capture database, from STLTSA_DATA (default: ../shared/data next to the
// source tree). Skipped with a message if they are missing.
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>

#include "clip/features/features.hpp"
#include "clip/features/pose_code.hpp"
#include "clip/features/prepare.hpp"
#include "clip/write.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

std::string folder() {
    const char* given = std::getenv("STLTSA_DATA");
    return std::string(given != nullptr ? given : STLTSA_DATA_DEFAULT) + "/cmu/";
}

struct Expected {
    const char* name;
    std::int64_t frames, channels, tpose;
};

constexpr Expected clips[] = {
    {"walk_from_standing_1.bvh", 549, 117, 0},
    {"walk_from_standing_2.bvh", 530, 117, 0},
    {"131_01.bvh", 994, 96, 0},
    {"cmu_run_filtered.bvh", 174, 60, 5},
    {"10_03.bvh", 363, 132, 4},
    {"35_01.amc", 358, 62, 0},
    {"02_03.amc", 173, 62, 0},
    {"86_01.amc", 4579, 62, 0},
};

Clip read_clip(const std::string& name, const std::string& skeleton = "") {
    ReadOptions options;
    options.skeleton = skeleton.empty() ? "" : folder() + skeleton;
    return stltsa::clip::read(folder() + name, options);
}

void are_read(void**) {
    for (const Expected& expected : clips) {
        const Clip clip = read_clip(expected.name);
        print_message("%s\n", expected.name);
        assert_int_equal(clip.frames(), expected.frames);
        assert_int_equal(clip.values.cols(), expected.channels);
        assert_true(clip.fps == 120);
        assert_true(up_axis(clip, {}) == Axis::y);
    }
}

void start_with_the_known_tpose(void**) {
    for (const Expected& expected : clips) {
        print_message("%s\n", expected.name);
        assert_int_equal(prepare(read_clip(expected.name), {}).first, expected.tpose);
    }
}

void bones_keep_their_lengths(void**) {
    for (const Expected& expected : clips) {
        const Clip clip = read_clip(expected.name);
        const Matrix at = positions(clip);
        const std::vector<Joint>& joints = clip.skeleton->joints;
        for (std::size_t j = 1; j < joints.size(); ++j) {
            const auto child = static_cast<std::int64_t>(3 * j);
            const auto parent = static_cast<std::int64_t>(3 * joints[j].parent);
            const Vec3& offset = joints[j].offset;
            for (std::int64_t i = 0; i < at.rows(); i += 10)
                ASSERT_NEAR(std::hypot(at(i, child) - at(i, parent),
                                       at(i, child + 1) - at(i, parent + 1),
                                       at(i, child + 2) - at(i, parent + 2)),
                            std::hypot(offset[0], offset[1], offset[2]), 1e-11);
        }
    }
}

/// Lowest and highest point of a frame.
std::pair<double, double> heights(const Matrix& at, std::int64_t frame) {
    double least = at(frame, 1), most = least;
    for (std::int64_t c = 4; c < at.cols(); c += 3) {
        least = std::min(least, at(frame, c));
        most = std::max(most, at(frame, c));
    }
    return {least, most};
}

void walkers_stand_upright_on_the_floor(void**) {
    // AMC lengths are in 1 / (0.45 * 39.37) m: 29 units are 1.64 m.
    for (const auto& [name, first, last] :
         {std::tuple{"35_01.amc", 0, 358}, {"86_01.amc", 0, 500}, {"131_01.bvh", 850, 994}}) {
        const Matrix at = positions(read_clip(name));
        for (int i = first; i < last; ++i) {
            const auto [least, most] = heights(at, i);
            if (least < -1.5 || least > 2.5 || most < 25 || most > 32)
                FAIL("%s, frame %d: from %g to %g", name, i, least, most);
        }
    }
}

void the_skeleton_is_found_or_must_be_given(void**) {
    assert_true(read_clip("86_01.amc").notes.back().ends_with("86.asf"));
    ASSERT_FAILS(Status::io, "set option skeleton", read_clip("13_30.amc"));
    assert_int_equal(read_clip("13_30.amc", "86.asf").frames(), 2465);
}

double largest(const Matrix& matrix) {
    double result = 0;
    for (std::int64_t i = 0; i < matrix.rows() * matrix.cols(); ++i)
        result = std::max(result, std::abs(matrix.data()[i]));
    return result;
}

double largest_difference(const Matrix& a, const Matrix& b) {
    assert_int_equal(a.rows(), b.rows());
    assert_int_equal(a.cols(), b.cols());
    double result = 0;
    for (std::int64_t i = 0; i < a.rows() * a.cols(); ++i)
        result = std::max(result, std::abs(a.data()[i] - b.data()[i]));
    return result;
}

void are_the_same_after_writing(void**) {
    const TemporaryFolder temporary;
    for (const Expected& expected : clips) {
        const Clip clip = read_clip(expected.name);
        const std::string copy = temporary.path(expected.name);
        write(clip, copy);
        ReadOptions options;
        if (clip.format == Format::amc)
            options.skeleton = folder() + std::string(expected.name, 2) + ".asf";
        const Clip again = stltsa::clip::read(copy, options);
        assert_int_equal(again.frames(), clip.frames());
        assert_memory_equal(again.values.data(), clip.values.data(),
                            static_cast<std::size_t>(clip.frames() * clip.values.cols()) * 8);
        assert_true(again.channel_names == clip.channel_names);
        assert_true(again.fps == clip.fps && again.frame_time == clip.frame_time);
        assert_true(largest_difference(positions(again), positions(clip)) == 0);
    }
}

void amc_and_bvh_show_the_same_motion(void**) {
    const TemporaryFolder temporary;
    for (const char* name : {"35_01.amc", "02_03.amc", "86_01.amc"}) {
        const Clip clip = read_clip(name);
        write(clip, temporary.path("copy.bvh"));
        const Clip bvh = stltsa::clip::read(temporary.path("copy.bvh"), {});
        const double difference =
            largest_difference(positions(bvh), positions(clip)) / largest(positions(clip));
        print_message("%s: %.1e of the largest coordinate\n", name, difference);
        assert_true(difference < 1e-12);
    }
}

void poses_come_back_from_their_vectors(void**) {
    for (const Expected& expected : clips) {
        const Clip clip = read_clip(expected.name);
        const CodedPoses coded = encode_poses(clip, {});
        const Clip decoded = decode_poses(coded.code, coded.vectors.view(), clip.fps);
        const Matrix wanted = features(clip, Features::positions, Axis::y);
        const double difference =
            largest_difference(features(decoded, Features::positions, Axis::y), wanted) /
            largest(wanted);
        print_message("%s: %.1e of the body's size\n", expected.name, difference);
        assert_true(difference < 1e-12);
    }
}

} // namespace

int main() {
    if (!std::filesystem::exists(folder())) {
        print_message("SKIPPED: no real clips at %s (set STLTSA_DATA)\n", folder().c_str());
        return 77; // Meson's status for skipped tests
    }
    const CMUnitTest tests[] = {
        cmocka_unit_test(are_read),
        cmocka_unit_test(start_with_the_known_tpose),
        cmocka_unit_test(bones_keep_their_lengths),
        cmocka_unit_test(walkers_stand_upright_on_the_floor),
        cmocka_unit_test(the_skeleton_is_found_or_must_be_given),
        cmocka_unit_test(are_the_same_after_writing),
        cmocka_unit_test(amc_and_bvh_show_the_same_motion),
        cmocka_unit_test(poses_come_back_from_their_vectors),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
