// SPDX-License-Identifier: BSD-3-Clause
// ASF skeletons and AMC motion.
#include "clip/testing.hpp"

#include <sys/stat.h>

#include <cmath>

#include "clip/features/features.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;

/// Reads AMC text with ASF text, from files in the same folder.
Clip acclaim(const std::string& amc, const std::string& asf, std::optional<double> fps = {}) {
    const TemporaryFolder folder;
    folder.write("a.asf", asf);
    ReadOptions options;
    options.fps = fps;
    return stltsa::clip::read(folder.write("a.amc", amc), options);
}

std::string every_line_end(std::string text, std::string_view to) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += to.size())
        text.replace(at, 1, to);
    return text;
}

Vec3 point(const stltsa::Matrix& positions, std::int64_t frame, std::int64_t joint) {
    return {positions(frame, 3 * joint), positions(frame, 3 * joint + 1),
            positions(frame, 3 * joint + 2)};
}

void check_point(const Vec3& actual, const Vec3& expected) {
    for (std::size_t i = 0; i < 3; ++i)
        ASSERT_NEAR(actual[i], expected[i], 1e-12);
}

void bones_become_joints(void**) {
    const Clip clip = acclaim(small_amc, small_asf);
    const std::vector<Joint>& joints = clip.skeleton->joints;
    assert_int_equal(joints.size(), 6);
    const struct {
        const char* name;
        int parent;
        bool end_site;
    } expected[] = {{"root", -1, false},    {"thigh", 0, false}, {"shank", 1, false},
                    {"shank end", 2, true}, {"spine", 0, false}, {"spine end", 4, true}};
    for (std::size_t j = 0; j < joints.size(); ++j) {
        assert_string_equal(joints[j].name.c_str(), expected[j].name);
        assert_int_equal(joints[j].parent, expected[j].parent);
        assert_true(joints[j].end_site == expected[j].end_site);
    }
    check_point(joints[1].offset, {0, 0, 0});
    check_point(joints[2].offset, {6, -8, 0});
    check_point(joints[3].offset, {0, -5, 0});
    assert_int_equal(clip.frames(), 2);
    assert_int_equal(clip.values.cols(), 10);
    assert_true(clip.values(0, 5) == 30 && clip.values(1, 9) == 91);
    assert_string_equal(clip.channel_names[9].c_str(), "shank.rx");
}

void bones_at_rest_follow_the_skeleton(void**) {
    const Clip clip = acclaim("1\nroot 1 2 3 0 0 0\nthigh 0 0 0\nshank 0\n", small_asf);
    const stltsa::Matrix at = positions(clip);
    check_point(point(at, 0, 0), {1, 2, 3});
    check_point(point(at, 0, 2), {7, -6, 3});
    check_point(point(at, 0, 3), {7, -11, 3});
    check_point(point(at, 0, 5), {1, 9, 3});
}

void turns_about_the_axes_of_the_bone(void**) {
    // The shank's axis is turned by 90 degrees about y: its x is the world's -z. About that axis,
    // -y turns by 90 degrees into -x.
    const Clip clip = acclaim("1\nroot 0 0 0 0 0 0\nthigh 0 0 0\nshank 90\n", small_asf);
    check_point(point(positions(clip), 0, 3), {6 - 5, -8, 0});
}

void axes_of_bones_turn_in_their_order(void**) {
    // x by 90, then z by 90: the bone's own x ends along y; in the order ZYX along z.
    const std::string twice = replaced(small_asf, "axis 0 90 0 XYZ", "axis 90 0 90 XYZ");
    const std::string amc = "1\nroot 0 0 0 0 0 0\nthigh 0 0 0\nshank 90\n";
    check_point(point(positions(acclaim(amc, twice)), 0, 3), {6, -8 - 5, 0});
    const Clip other = acclaim(amc, replaced(twice, "90 0 90 XYZ", "90 0 90 zyx"));
    check_point(point(positions(other), 0, 3), {6 + 5, -8, 0});
}

void the_length_of_direction_does_not_matter(void**) {
    const Clip clip =
        acclaim(small_amc, replaced(small_asf, "direction 0.6 -0.8 0", "direction 3 -4 0"));
    check_point(clip.skeleton->joints[2].offset, {6, -8, 0});
    const Clip none =
        acclaim(small_amc, replaced(small_asf, "direction 0 -1 0", "direction 0 0 0"));
    check_point(none.skeleton->joints[3].offset, {0, 0, 0});
}

void turns_about_fixed_axes_in_the_listed_order(void**) {
    // rx first: y -> z, then rz: z stays.
    const Clip clip = acclaim("1\nroot 0 0 0 90 0 90\nthigh 0 0 0\nshank 0\n", small_asf);
    check_point(point(positions(clip), 0, 5), {0, 0, 7});
    const Clip other = acclaim("1\nroot 0 0 0 90 0 90\nthigh 0 0 0\nshank 0\n",
                               replaced(small_asf, "RX RY RZ", "RZ RY RX"));
    check_point(point(positions(other), 0, 5), {-7, 0, 0}); // rz first: y -> -x, rx keeps it
}

void degrees_of_freedom_in_any_order(void**) {
    const std::string asf = replaced(small_asf, "dof rx ry rz", "dof rz rx");
    const Clip clip = acclaim("1\nroot 0 0 0 0 0 0\nshank 3\nthigh 1 2\n", asf);
    assert_true(clip.skeleton->joints[1].channels == (std::vector{Channel::rz, Channel::rx}));
    assert_true(clip.values(0, 6) == 1 && clip.values(0, 7) == 2 && clip.values(0, 8) == 3);
}

void radians_become_degrees(void**) {
    const std::string amc = replaced(replaced(small_amc, ":DEGREES", ":radians"), "shank 90",
                                     "shank 1.5707963267948966");
    const Clip clip = acclaim(amc, small_asf);
    ASSERT_NEAR(clip.values(0, 9), 90, 1e-12);
    assert_true(clip.values(0, 0) == 1); // lengths do not change
    const std::string asf = replaced(replaced(small_asf, "angle deg", "angle rad"), "axis 0 90 0",
                                     "axis 0 1.5707963267948966 0");
    const Clip both = acclaim(replaced(amc, ":radians\n", ""), asf); // the ASF's unit applies
    ASSERT_NEAR(both.values(0, 9), 90, 1e-12);
    ASSERT_NEAR(both.skeleton->joints[2].axis.y, std::sqrt(0.5), 1e-12);
}

void root_position_adds_and_orientation_turns_axes(void**) {
    const std::string asf = replaced(replaced(small_asf, "position 0 0 0", "position 10 20 30"),
                                     "orientation 0 0 0", "orientation 0 90 0");
    const Clip clip = acclaim("1\nroot 1 2 3 90 0 0\nthigh 0 0 0\nshank 0\n", asf);
    const stltsa::Matrix at = positions(clip);
    check_point(point(at, 0, 0), {11, 22, 33});
    check_point(point(at, 0, 5), {18, 22, 33}); // about -z: y -> x
}

void reads_dialects(void**) {
    const Clip plain = acclaim(small_amc, small_asf);
    for (const auto& [amc, asf] :
         {std::pair{every_line_end(small_amc, "\r\n"), every_line_end(small_asf, " \r\n")},
          {replaced(small_amc, "thigh 5", "THIGH 5"),
           replaced(small_asf, "name thigh", "name Thigh")},
          {replaced(small_amc, "shank 91\n", "shank 91"),
           replaced(small_asf, "dof rx ry rz\n", "dof rx ry rz # all\n")},
          {replaced(small_amc, "root 1 2", "# note\n\n  root\t+1 2.0"),
           replaced(small_asf, "axis 0 0 20 XYZ", "axis (0, 0, 20) xyz")},
          {replaced(small_amc, "1\nroot", "57\nroot"),
           replaced(small_asf, "id 1\n", "bodymass 3\n")}}) {
        const std::string numbered =
            amc.find("57\n") == amc.npos ? amc : replaced(amc, "\n2\n", "\n58\n");
        const Clip clip = acclaim(numbered, asf);
        const stltsa::Matrix a = positions(clip);
        const stltsa::Matrix b = positions(plain);
        assert_int_equal(a.rows(), b.rows());
        assert_int_equal(a.cols(), b.cols());
        for (std::int64_t i = 0; i < a.rows() * a.cols(); ++i)
            assert_true(a.data()[i] == b.data()[i]);
    }
}

void assumes_a_frame_rate_and_says_so(void**) {
    const Clip clip = acclaim(small_amc, small_asf);
    assert_true(clip.fps == 120);
    assert_int_equal(clip.notes.size(), 2);
    assert_true(clip.notes[0].find("120 frames a second assumed") != std::string::npos);
    assert_true(clip.notes[1].find("a.asf") != std::string::npos);
    const Clip set = acclaim(small_amc, small_asf, 60);
    assert_true(set.fps == 60);
    assert_int_equal(set.notes.size(), 1);
    const Clip said = acclaim(":SAMPLES-PER-SECOND 30\n" + small_amc, small_asf);
    assert_true(said.fps == 30);
    assert_int_equal(said.notes.size(), 1);
    for (const char* rate : {"0", "-1", "5e-324", "1e7", "inf", "nan", "x"})
        ASSERT_FAILS(
            Status::format, "is not a frame rate from 1e-09 to 1e+06",
            acclaim(":SAMPLES-PER-SECOND " + std::string(rate) + "\n" + small_amc, small_asf));
}

std::string skeleton_name(const TemporaryFolder& folder, std::string_view amc) {
    return stltsa::clip::read(folder.write(amc, small_amc), {}).notes.back();
}

void finds_the_skeleton_beside_the_clip(void**) {
    const TemporaryFolder folder;
    folder.write("7.ASF", small_asf);
    // Only regular files count: opening a pipe would wait for its writer.
    assert_int_equal(mkfifo(folder.path("9.asf").c_str(), 0600), 0);
    std::filesystem::create_directory(folder.path("8.asf"));
    std::filesystem::create_symlink("nowhere", folder.path("6.asf"));
    assert_true(skeleton_name(folder, "9_01.amc").ends_with("7.ASF")); // the only one
    folder.write("35.asf", small_asf);
    assert_true(skeleton_name(folder, "35_01.amc").ends_with("/35.asf"));
    assert_true(skeleton_name(folder, "7_12.AMC").ends_with("/7.ASF"));
    folder.write("35_01.asf", small_asf);
    assert_true(skeleton_name(folder, "35_01.amc").ends_with("/35_01.asf"));
    ASSERT_FAILS(Status::io, "set option skeleton", skeleton_name(folder, "9_01.amc"));
    ReadOptions options;
    options.skeleton = folder.path("7.ASF");
    const Clip clip = stltsa::clip::read(folder.path("9_01.amc"), options);
    assert_int_equal(clip.notes.size(), 1); // only the frame rate: there was no search
    ASSERT_FAILS(Status::argument, "set option skeleton", parse(small_amc, Format::amc));
    options.skeleton = folder.path("none.asf");
    ASSERT_FAILS(Status::io, "none.asf: cannot open", parse(small_amc, Format::amc, options));
    // A CSV file does not need the skeleton, which is not even opened.
    const Clip bare = parse("1,2\n3,4\n", Format::csv, options);
    assert_true(bare.notes.back().starts_with("option skeleton is not used"));
}

void refuses_amc(std::string_view from, std::string_view to, Status status, std::string_view part,
                 int line) {
    const std::string amc = replaced(small_amc, from, to);
    check_fails(
        status, part, [&] { acclaim(amc, small_asf); }, __FILE__, line);
}

void malformed_amc(void**) {
    refuses_amc("shank 90", "shank", Status::format, "a.amc:7: bone 'shank' has 1 degrees",
                __LINE__);
    refuses_amc("shank 90", "shank 90 1", Status::format, "a.amc:7: bone 'shank' has 1", __LINE__);
    refuses_amc("shank 90", "shank ninety", Status::format, "a.amc:7: 'ninety' is not a number",
                __LINE__);
    refuses_amc("shank 91", "shank nan", Status::not_finite,
                "a.amc:11: frame 1, rx of bone 'shank' is nan", __LINE__);
    refuses_amc("shank 90\n", "", Status::format,
                "a.amc:7: frame 1 ends before this line without bone 'shank'", __LINE__);
    refuses_amc("shank 91\n", "", Status::format, "frame 2 ends before this line without",
                __LINE__);
    refuses_amc("shank 90", "thigh 5 6 7", Status::format,
                "a.amc:7: bone 'thigh' appears twice in frame 1", __LINE__);
    refuses_amc("shank 90", "elbow 90", Status::format, "a.asf has no moving bone 'elbow'",
                __LINE__);
    refuses_amc("shank 90", "spine 90", Status::format, "a.amc:7:", __LINE__);
    refuses_amc("\n2\n", "\n3\n", Status::format, "a.amc:8: frame 3 follows frame 1", __LINE__);
    refuses_amc("\n2\n", "\n-9223372036854775808\n", Status::format,
                "a.amc:8: invalid frame number -", __LINE__);
    refuses_amc("1\nroot", "root", Status::format,
                "a.amc:4: 'root' comes before the number of the first frame", __LINE__);
    refuses_amc(small_amc, ":DEGREES\n", Status::format, "a.amc:1: the file has no frames",
                __LINE__);
    refuses_amc(":DEGREES", ":SAMPLES-PER-SECOND 0", Status::format, "a.amc:3: '0' is not a frame",
                __LINE__);
}

void refuses_asf(std::string_view from, std::string_view to, Status status, std::string_view part,
                 int line) {
    const std::string asf = replaced(small_asf, from, to);
    check_fails(
        status, part, [&] { acclaim(small_amc, asf); }, __FILE__, line);
}

void malformed_asf(void**) {
    refuses_asf("angle deg", "angle grad", Status::format, "a.asf:7: the angle unit must be",
                __LINE__);
    refuses_asf("TX TY TZ", "TX TY TW", Status::format, "a.asf:11: 'tw' is not one of", __LINE__);
    refuses_asf("  order TX TY TZ RX RY RZ\n", "", Status::format, "has no 'order'", __LINE__);
    refuses_asf("direction 0.6 -0.8 0", "direction 0.6 -0.8", Status::format,
                "a.asf:19: 'direction' needs finite numbers, not ''", __LINE__);
    refuses_asf("length 10", "length inf", Status::not_finite, "a.asf:20: 'length'", __LINE__);
    refuses_asf("axis 0 0 20 XYZ", "axis 0 0 20 XYQ", Status::format,
                "a.asf:21: 'XYQ' is not an order of axes", __LINE__);
    refuses_asf("dof rx ry rz", "dof rx ty", Status::unsupported,
                "a.asf:22: bone 'thigh' has the position channel ty", __LINE__);
    refuses_asf("dof rx ry rz", "dof rx ry rz rx ry rz rx", Status::format,
                "a.asf:22: bone 'thigh' has one 'rx' too many", __LINE__);
    refuses_asf("TX TY TZ", "TX TY TX", Status::format,
                "a.asf:11: bone 'root' has one 'TX' too many", __LINE__);
    refuses_asf("name shank", "name " + std::string(257, 'a'), Status::format, "a.asf:29: the name",
                __LINE__);
    refuses_asf("thigh shank", std::string(257, 'a') + " shank", Status::format,
                "257 bytes; at most 256", __LINE__);
    refuses_asf("dof rx ry rz", "dof rx l", Status::unsupported,
                "a.asf:22: bones of variable length", __LINE__);
    refuses_asf("name shank", "name thigh", Status::format, "a.asf:27: a second bone named 'thigh'",
                __LINE__);
    refuses_asf("    name shank\n", "", Status::format,
                "the bone that begins on line 27 has no name", __LINE__);
    refuses_asf("(-60.0 70.0)\n  end\n", "\n", Status::format,
                "a.asf:26: 'begin' is inside bone 'thigh'", __LINE__);
    refuses_asf("length 7\n    axis 0 0 0 XYZ\n  end\n", "", Status::format,
                "is inside bone 'spine'", __LINE__);
    refuses_asf("    thigh shank\n", "", Status::format,
                "a.asf:27: bone 'shank' is missing from the section :hierarchy", __LINE__);
    refuses_asf("thigh shank\n", "thigh foot\n", Status::format,
                "'foot' is not among the bones of :bonedata", __LINE__);
    refuses_asf("thigh shank\n", "thigh shank spine\n", Status::format,
                "'spine' already has a parent", __LINE__);
    refuses_asf("thigh shank\n", "thigh shank root\n", Status::format,
                "'root' already has a parent", __LINE__);
    refuses_asf("root thigh spine\n    thigh shank\n", "root spine\nthigh shank\nshank thigh\n",
                Status::format, "does not connect all bones", __LINE__);
    refuses_asf(small_asf, ":root\norder tx\n:bonedata\n", Status::format, "no bones", __LINE__);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(bones_become_joints),
        cmocka_unit_test(bones_at_rest_follow_the_skeleton),
        cmocka_unit_test(turns_about_the_axes_of_the_bone),
        cmocka_unit_test(axes_of_bones_turn_in_their_order),
        cmocka_unit_test(the_length_of_direction_does_not_matter),
        cmocka_unit_test(turns_about_fixed_axes_in_the_listed_order),
        cmocka_unit_test(degrees_of_freedom_in_any_order),
        cmocka_unit_test(radians_become_degrees),
        cmocka_unit_test(root_position_adds_and_orientation_turns_axes),
        cmocka_unit_test(reads_dialects),
        cmocka_unit_test(assumes_a_frame_rate_and_says_so),
        cmocka_unit_test(finds_the_skeleton_beside_the_clip),
        cmocka_unit_test(malformed_amc),
        cmocka_unit_test(malformed_asf),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
