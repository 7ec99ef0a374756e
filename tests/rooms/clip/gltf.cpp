// SPDX-License-Identifier: BSD-3-Clause
// Reads GLB files back as their specification says, with a JSON parser of its own: hierarchy,
// times, and the position of every joint and point in every frame.
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include <nlohmann/json.hpp>

#include "clip/arrays/arrays.hpp"
#include "clip/body/quaternion.hpp"
#include "clip/features/features.hpp"
#include "clip/files/read_file.hpp"
#include "clip/formats.hpp"
#include "clip/gltf/buffer.hpp"
#include "clip/write.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using nlohmann::json;
using stltsa::Matrix;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::size_t word_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0; // the tests run on little-endian machines
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// A parsed file.
struct Glb {
    json text;
    std::string numbers;

    explicit Glb(const std::string& bytes) {
        assert_string_equal(bytes.substr(0, 4).c_str(), "glTF");
        assert_int_equal(word_at(bytes, 4), 2);
        assert_int_equal(word_at(bytes, 8), bytes.size());
        const std::size_t length = word_at(bytes, 12);
        assert_int_equal(length % 4, 0);
        assert_string_equal(bytes.substr(16, 4).c_str(), "JSON");
        text = json::parse(bytes.substr(20, length));
        const std::size_t begin = 20 + length + 8;
        assert_int_equal(word_at(bytes, begin - 8), bytes.size() - begin);
        assert_memory_equal(bytes.data() + begin - 4, "BIN", 4);
        numbers = bytes.substr(begin);
        assert_int_equal(text["buffers"][0]["byteLength"].get<std::size_t>(), numbers.size());
    }

    /// The vectors of an accessor of floats; checks its bounds.
    std::vector<std::vector<double>> read(const json& index) const {
        const json& accessor = text["accessors"][index.get<std::size_t>()];
        const json& view = text["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const std::map<std::string, std::size_t> sizes{
            {"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
        assert_int_equal(accessor["componentType"].get<int>(), 5126);
        const std::size_t size = sizes.at(accessor["type"]);
        const std::size_t count = accessor["count"];
        const std::size_t begin = view["byteOffset"];
        assert_int_equal(begin % 4, 0);
        assert_int_equal(view["byteLength"].get<std::size_t>(), 4 * size * count);
        assert_true(begin + 4 * size * count <= numbers.size());
        std::vector<std::vector<double>> vectors(count, std::vector<double>(size));
        for (std::size_t i = 0; i < count * size; ++i) {
            float value = 0;
            std::memcpy(&value, numbers.data() + begin + 4 * i, sizeof value);
            vectors[i / size][i % size] = static_cast<double>(value);
        }
        check_bounds(accessor, vectors);
        return vectors;
    }

    static void check_bounds(const json& accessor,
                             const std::vector<std::vector<double>>& vectors) {
        for (std::size_t c = 0; c < vectors[0].size(); ++c) {
            const auto less = [c](const auto& a, const auto& b) { return a[c] < b[c]; };
            const auto [least, most] = std::minmax_element(vectors.begin(), vectors.end(), less);
            assert_true(accessor["min"][c].get<double>() == (*least)[c]);
            assert_true(accessor["max"][c].get<double>() == (*most)[c]);
        }
    }

    /// The values of a node along a path ("rotation"), and their times; false: it has none.
    bool animated(std::size_t node, const char* path, std::vector<std::vector<double>>& times,
                  std::vector<std::vector<double>>& values) const {
        const json& animation = text["animations"][0];
        for (const json& channel : animation["channels"])
            if (channel["target"]["node"] == node && channel["target"]["path"] == path) {
                const json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
                assert_true(sampler["interpolation"] == "LINEAR");
                times = read(sampler["input"]);
                values = read(sampler["output"]);
                assert_int_equal(times.size(), values.size());
                return true;
            }
        return false;
    }
};

Glb glb_of(const Clip& clip) {
    const TemporaryFolder folder;
    write(clip, folder.path("a.GLB"));
    return Glb(read_file(folder.path("a.GLB")));
}

void check_times(const std::vector<std::vector<double>>& times, const Clip& clip) {
    assert_int_equal(times.size(), clip.frames());
    for (std::size_t i = 0; i < times.size(); ++i)
        ASSERT_NEAR(times[i][0], static_cast<double>(i) / clip.fps, 1e-7 * times.back()[0]);
}

/// A node's local motion, frame by frame.
struct Track {
    std::vector<Quaternion> turns;
    std::vector<Vec3> places;
};

Track track_of(const Glb& glb, const Clip& clip, std::size_t node) {
    const json& rest = glb.text["nodes"][node]["translation"];
    const auto frames = static_cast<std::size_t>(clip.frames());
    Track track{std::vector<Quaternion>(frames),
                std::vector<Vec3>(frames, Vec3{rest[0], rest[1], rest[2]})};
    std::vector<std::vector<double>> times, values;
    if (glb.animated(node, "rotation", times, values)) {
        check_times(times, clip);
        for (std::size_t i = 0; i < frames; ++i) {
            track.turns[i] = {values[i][3], values[i][0], values[i][1], values[i][2]};
            ASSERT_NEAR(dot(track.turns[i], track.turns[i]), 1, 1e-6);
            assert_true(i == 0 || dot(track.turns[i], track.turns[i - 1]) >= 0);
        }
    }
    if (glb.animated(node, "translation", times, values)) {
        check_times(times, clip);
        for (std::size_t i = 0; i < frames; ++i)
            track.places[i] = {values[i][0], values[i][1], values[i][2]};
    }
    return track;
}

/// The parents of the nodes by the lists of children; -1: in the scene's own list.
std::vector<int> parents_of(const Glb& glb) {
    std::vector<int> parents(glb.text["nodes"].size(), -2);
    for (const int top : glb.text["scenes"][0]["nodes"])
        parents[static_cast<std::size_t>(top)] = -1;
    for (std::size_t n = 0; n < parents.size(); ++n)
        for (const int child : glb.text["nodes"][n].value("children", std::vector<int>()))
            parents[static_cast<std::size_t>(child)] = static_cast<int>(n);
    return parents;
}

void check_world_positions(const Glb& glb, const Clip& clip) {
    const Matrix expected = positions(clip);
    double largest = 0;
    for (std::int64_t i = 0; i < expected.rows() * expected.cols(); ++i)
        largest = std::max(largest, std::abs(expected.data()[i]));
    const std::vector<int> parents = parents_of(glb);
    std::vector<Track> worlds;
    for (std::size_t j = 0; j < clip.skeleton->joints.size(); ++j) {
        Track track = track_of(glb, clip, j);
        for (std::size_t i = 0; i < track.turns.size(); ++i) {
            if (parents[j] >= 0) {
                const Track& parent = worlds[static_cast<std::size_t>(parents[j])];
                track.places[i] = parent.places[i] + rotate(parent.turns[i], track.places[i]);
                track.turns[i] = parent.turns[i] * track.turns[i];
            }
            for (std::size_t axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(
                    track.places[i][axis],
                    expected(static_cast<std::int64_t>(i), static_cast<std::int64_t>(3 * j + axis)),
                    1e-5 * largest);
        }
        worlds.push_back(std::move(track));
    }
}

/// The inverse bind matrices take the joints of the resting skeleton to the origin.
void check_skin(const Glb& glb, const Clip& clip) {
    const json& skin = glb.text["skins"][0];
    const auto binds = glb.read(skin["inverseBindMatrices"]);
    const auto& joints = clip.skeleton->joints;
    assert_int_equal(skin["joints"].size(), joints.size());
    assert_int_equal(binds.size(), joints.size());
    std::vector<Vec3> rest;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        assert_int_equal(skin["joints"][j].get<std::size_t>(), j);
        const int parent = joints[j].parent;
        rest.push_back(joints[j].offset +
                       (parent < 0 ? Vec3{} : rest[static_cast<std::size_t>(parent)]));
        for (std::size_t k = 0; k < 16; ++k) // by columns
            ASSERT_NEAR(binds[j][k],
                        k % 5 == 0                ? 1
                        : k / 4 == 3 && k % 4 < 3 ? -rest[j][k % 4]
                                                  : 0,
                        1e-5);
    }
}

void check_skeleton(const Clip& clip) {
    const Glb glb = glb_of(clip);
    const auto& joints = clip.skeleton->joints;
    const std::vector<int> parents = parents_of(glb);
    assert_int_equal(glb.text["nodes"].size(), joints.size());
    for (std::size_t j = 0; j < joints.size(); ++j) {
        assert_true(glb.text["nodes"][j]["name"] == joints[j].name);
        assert_int_equal(parents[j], joints[j].parent);
    }
    check_world_positions(glb, clip);
    check_skin(glb, clip);
}

void a_bvh_keeps_its_joints_and_positions(void**) {
    check_skeleton(parse(small_bvh, Format::bvh));
    const std::string moving =
        replaced(small_bvh, "CHANNELS 1 Xrotation", "CHANNELS 2 Yposition Xrotation");
    Clip clip = parse(replaced(replaced(replaced(moving, " 0\n2 3", " 9 0\n2 3"), "70\n", "8 70\n"),
                               " 71\n", " 7 71\n"),
                      Format::bvh);
    check_skeleton(clip);
    clip.skeleton->joints[3].adds = true;
    clip.skeleton->joints[0].offset = {7, 90, -5}; // the positions of the root replace it
    check_skeleton(clip);
}

void an_amc_keeps_its_joints_and_positions(void**) {
    const TemporaryFolder folder;
    ReadOptions options;
    options.skeleton = folder.write(
        "small.asf", replaced(small_asf, "orientation 0 0 0", "orientation 10 -20 30"));
    check_skeleton(parse(small_amc, Format::amc, options));
}

void signs_do_not_jump_in_a_turn(void**) {
    std::string text = replaced(small_bvh, "Frames: 3", "Frames: 60");
    text.resize(text.find("1 2 3 0 0"));
    for (int i = 0; i < 60; ++i)
        text += "1 2 3 0 0 " + std::to_string((10 * i + 180) % 360 - 180) + " 0 0 0 0\n";
    check_skeleton(parse(text, Format::bvh));
}

Clip points_clip(int space, const std::vector<double>& values, std::int64_t frames) {
    PointArrays arrays;
    arrays.space = space;
    arrays.positions = {values.data(), frames, static_cast<std::int64_t>(values.size()) / frames};
    arrays.names = {"heel", "toe"};
    arrays.fps = 50;
    return clip_from_points(arrays);
}

/// Six frames of two points; the second one is missing in two frames and in the first one.
std::vector<double> heel_and_toe(int space) {
    std::vector<double> values;
    for (int i = 0; i < 6; ++i)
        for (int p = 0; p < 2; ++p)
            for (int axis = 0; axis < space; ++axis)
                values.push_back(p == 1 && (i == 0 || i == 2 || i == 3) ? missing
                                                                        : i + 10 * p + 0.1 * axis);
    return values;
}

void points_move_in_the_frames_in_which_they_are_seen(void**) {
    for (const int space : {2, 3}) {
        const Glb glb = glb_of(points_clip(space, heel_and_toe(space), 6));
        assert_int_equal(glb.text["nodes"].size(), 2);
        assert_true(glb.text["nodes"][0]["name"] == "heel" &&
                    glb.text["nodes"][1]["name"] == "toe");
        assert_true(parents_of(glb) == std::vector<int>({-1, -1}));
        for (std::size_t p = 0; p < 2; ++p) {
            std::vector<std::vector<double>> times, places;
            assert_true(glb.animated(p, "translation", times, places));
            const std::vector<int> frames =
                p == 0 ? std::vector{0, 1, 2, 3, 4, 5} : std::vector{1, 4, 5};
            assert_int_equal(times.size(), frames.size());
            // Where nothing is animated, a point rests where it is seen first.
            const auto rest = glb.text["nodes"][p]["translation"].get<std::vector<double>>();
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(rest[static_cast<std::size_t>(axis)],
                            places[0][static_cast<std::size_t>(axis)], 1e-5);
            for (std::size_t k = 0; k < frames.size(); ++k) {
                ASSERT_NEAR(times[k][0], frames[k] / 50.0, 1e-7);
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_NEAR(
                        places[k][static_cast<std::size_t>(axis)],
                        axis < space ? frames[k] + 10.0 * static_cast<double>(p) + 0.1 * axis : 0.0,
                        1e-5);
            }
        }
    }
}

void what_the_format_cannot_hold_is_refused(void**) {
    const auto written = [](const Clip& clip) { find_format(Format::glb)->write(clip); };
    const Clip raw = parse("a,b\n1,2\n3,4\n5,6\n", Format::csv);
    ASSERT_FAILS(Status::unsupported, "name its columns as coordinates of points", written(raw));
    Clip clip = parse(small_bvh, Format::bvh);
    clip.fps = 0;
    ASSERT_FAILS(Status::unsupported, "open it with option fps", written(clip));
    clip = parse(small_bvh, Format::bvh);
    clip.values(1, 0) = 1e39;
    ASSERT_FAILS(Status::unsupported, "1e+39 is too large", written(clip));
    ASSERT_FAILS(Status::unsupported, "no point of this clip is seen",
                 written(points_clip(3, std::vector<double>(12, missing), 2)));
    const TemporaryFolder folder;
    const std::string path = folder.write("a.glb", "glTF");
    ASSERT_FAILS(Status::format, ".glb files are only written", read(path, {}));
}

/// Numbers of 32 bits have 24 binary digits.
void frames_whose_times_are_the_same_are_refused(void**) {
    assert_int_equal(gltf_times({0, 1, (1 << 24) - 1, 1 << 24}, 1).size(), 4);
    ASSERT_FAILS(Status::unsupported, "the same for frame 16777217",
                 gltf_times({1 << 24, (1 << 24) + 1}, 1));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_bvh_keeps_its_joints_and_positions),
        cmocka_unit_test(an_amc_keeps_its_joints_and_positions),
        cmocka_unit_test(signs_do_not_jump_in_a_turn),
        cmocka_unit_test(points_move_in_the_frames_in_which_they_are_seen),
        cmocka_unit_test(what_the_format_cannot_hold_is_refused),
        cmocka_unit_test(frames_whose_times_are_the_same_are_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
