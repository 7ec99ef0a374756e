// SPDX-License-Identifier: BSD-3-Clause
// BVH files of different programs.
#include "clip/testing.hpp"

#include "clip/features/features.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;

Clip bvh(std::string_view text) {
    return parse(text, Format::bvh);
}

/// The clip must equal small_bvh.
void check_same(const std::string& text) {
    const Clip expected = bvh(small_bvh);
    Clip clip;
    const Failure failure = failure_of([&] { clip = bvh(text); });
    if (failure.status != Status::ok)
        FAIL("%s", failure.text.c_str());
    assert_true(clip.fps == expected.fps);
    assert_int_equal(clip.frames(), expected.frames());
    assert_int_equal(clip.values.cols(), expected.values.cols());
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::int64_t c = 0; c < clip.values.cols(); ++c)
            assert_true(clip.values(i, c) == expected.values(i, c));
    assert_true(clip.channel_names == expected.channel_names);
    assert_int_equal(clip.skeleton->joints.size(), expected.skeleton->joints.size());
    for (std::size_t j = 0; j < clip.skeleton->joints.size(); ++j) {
        const Joint& a = clip.skeleton->joints[j];
        const Joint& b = expected.skeleton->joints[j];
        assert_true(a.name == b.name && a.parent == b.parent && a.offset == b.offset);
        assert_true(a.channels == b.channels && a.end_site == b.end_site);
    }
}

std::string every(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

void reads_the_plain_file(void**) {
    const Clip clip = bvh(small_bvh);
    assert_true(clip.fps == 120);
    assert_int_equal(clip.frames(), 3);
    assert_int_equal(clip.values.cols(), 10);
    assert_true(clip.values(0, 2) == 3 && clip.values(2, 0) == 3 && clip.values(2, 9) == 71);
    const std::vector<Joint>& joints = clip.skeleton->joints;
    assert_int_equal(joints.size(), 5);
    assert_string_equal(joints[1].name.c_str(), "Leg");
    assert_string_equal(joints[2].name.c_str(), "Leg end");
    assert_true(joints[0].parent == -1 && joints[1].parent == 0 && joints[2].parent == 1);
    assert_true(joints[3].parent == 0 && joints[4].parent == 3);
    assert_true(joints[2].end_site && !joints[3].end_site);
    assert_true(joints[1].offset == (Vec3{1, -2, 0.5}));
    assert_true(joints[1].channels == (std::vector{Channel::rz, Channel::rx, Channel::ry}));
    assert_string_equal(clip.channel_names[0].c_str(), "Hips.tx");
    assert_string_equal(clip.channel_names[9].c_str(), "Arm.rx");
    assert_true(clip.notes.empty());
    assert_false(clip.skeleton->joints.back().adds);
}

void reads_line_ends_of_every_system(void**) {
    check_same(every(small_bvh, "\n", "\r\n"));
    check_same(every(small_bvh, "\n", "\r"));
    check_same(replaced(replaced(small_bvh, "ROOT Hips\n", "ROOT Hips\r\n"), "}\n", "}\r\n"));
    check_same(every(small_bvh, "\n", "\n\n  \n"));
    check_same(small_bvh.substr(0, small_bvh.size() - 1)); // no newline at the end
    check_same(small_bvh + "\n\n \t\n\x1A");               // Ctrl-Z, as on old systems
}

void reads_blanks_of_every_kind(void**) {
    check_same(every(small_bvh, "  ", "\t"));
    check_same(every(small_bvh, " ", " \t "));
    check_same(every(small_bvh, "\n", " \t \n"));
    check_same(every(small_bvh, "End Site\n", "End Site \n"));
    check_same(every(small_bvh, "rotation\n", "rotation \n"));
    check_same("\xEF\xBB\xBF" + small_bvh);
    check_same("\n\n" + small_bvh);
}

void reads_keywords_in_any_case(void**) {
    std::string text = small_bvh;
    for (const char* word : {"HIERARCHY", "ROOT", "OFFSET", "CHANNELS", "JOINT", "End", "Site",
                             "MOTION", "Frames", "Frame Time"}) {
        std::string lower;
        for (const char* c = word; *c != '\0'; ++c)
            lower += *c >= 'A' && *c <= 'Z' ? static_cast<char>(*c + 32) : *c;
        text = every(text, word, lower);
    }
    check_same(text);
    check_same(every(small_bvh, "rotation", "ROTATION"));
    check_same(every(small_bvh, "Xposition", "xPosition"));
    check_same(every(small_bvh, "position", "translation"));
}

void reads_headers_of_the_data_with_any_spacing(void**) {
    for (const char* frames :
         {"Frames:3", "Frames:\t3", "Frames :3", "FRAMES:   3  ", "frames: +3"})
        check_same(replaced(small_bvh, "Frames: 3", frames));
    for (const char* time :
         {"Frame Time:0.0083333", "Frame Time:\t.0083333", "Frame  Time: .008333",
          "FRAME TIME : 8.33333e-003", "FrameTime: 0.00833333"})
        check_same(replaced(small_bvh, "Frame Time: 0.0083333", time));
}

void reads_braces_in_any_place(void**) {
    check_same(every(small_bvh, "\n{", " {"));
    check_same(every(replaced(small_bvh, "Leg\n  {\n    ", "Leg{"), "}\n}", "}}"));
}

void reads_rows_over_several_lines(void**) {
    check_same(replaced(small_bvh, "2 3 4 10 20", "2 3\n4 10\n\n20"));
}

void reads_numbers_of_every_form(void**) {
    check_same(replaced(small_bvh, "1 2 3 0 0", "+1 2.0 3e+000 -0.0 0.000000E-015"));
    check_same(replaced(small_bvh, "OFFSET 1.0 -2.0 0.5", "OFFSET 1 -2e0 .5"));
}

void reads_names_with_blanks_and_without(void**) {
    const Clip clip = bvh(replaced(replaced(small_bvh, "JOINT Leg", "JOINT  left upper leg\t"),
                                   "JOINT Arm", "JOINT"));
    assert_string_equal(clip.skeleton->joints[1].name.c_str(), "left upper leg");
    assert_string_equal(clip.skeleton->joints[3].name.c_str(), "joint 3");
    const Clip named = bvh(replaced(small_bvh, "End Site", "End Site toe tip"));
    assert_string_equal(named.skeleton->joints[2].name.c_str(), "toe tip");
}

void reads_channels_in_any_order_and_number(void**) {
    std::string text = replaced(small_bvh, "CHANNELS 1 Xrotation",
                                "CHANNELS 6 Yrotation Zposition Xrotation Xposition Zrotation "
                                "Yposition");
    text = replaced(text, "CHANNELS 3 Zrotation Xrotation Yrotation\n",
                    "CHANNELS 2\nZrotation\nYrotation\n");
    text = text.substr(0, text.find("Frames:")) +
           "Frames: 1\nFrame Time: 0.01\n1 2 3 4 5 6 7 8 9 10 11 12 13 14\n";
    const Clip clip = bvh(text);
    assert_int_equal(clip.values.cols(), 14);
    assert_true(clip.skeleton->joints[3].channels ==
                (std::vector{Channel::ry, Channel::tz, Channel::rx, Channel::tx, Channel::rz,
                             Channel::ty}));
    assert_string_equal(clip.channel_names[13].c_str(), "Arm.ty");
    assert_true(clip.fps == 100);
}

/// small_bvh with a moving arm: these positions in its first frame, similar ones in the others.
Clip moving_arm(double x, double y, double z) {
    std::string text =
        replaced(small_bvh, "CHANNELS 1 Xrotation", "CHANNELS 3 Xposition Yposition Zposition");
    text = text.substr(0, text.find("Frames:")) + "Frames: 2\nFrame Time: 0.01\n";
    for (const double step : {0.0, 0.1})
        text += stltsa::format_text("0 0 0 0 0 0 0 0 0 {} {} {}\n", x + step, y, z);
    return bvh(text);
}

void recognizes_the_meaning_of_positions_below_the_root(void**) {
    const Clip absolute = moving_arm(3, 5, 0); // repeats OFFSET 3 5 0
    assert_false(absolute.skeleton->joints.back().adds);
    ASSERT_NEAR(positions(absolute)(1, 9), 3.1, 1e-12);
    const Clip relative = moving_arm(0, 0, 0);
    assert_true(relative.skeleton->joints.back().adds);
    ASSERT_NEAR(positions(relative)(1, 9), 3.1, 1e-12);
    assert_int_equal(relative.notes.size(), 1);
}

/// Joints of a body that stands still in its own axes; `hips` travel below a static root.
struct Traveler {
    bool add;                     ///< positions add to OFFSET
    int limbs = 3;                ///< joints below the hips that have positions
    Vec3 limb{10, 0, 0};          ///< their OFFSET
    Vec3 hips{0, 90, -450};       ///< OFFSET of the hips
    const char* root_turns = "0"; ///< rotation of the root in the second frame
    bool prop = false;            ///< one more joint, which travels separately

    std::string text() const;
    std::string row(double distance) const;
};

constexpr std::string_view six =
    "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n";

std::string triple(const Vec3& v) {
    return stltsa::format_text(" {} {} {}", v[0], v[1], v[2]);
}

std::string Traveler::row(double distance) const {
    const Vec3 place = add ? Vec3{0, 0, distance} : Vec3{0, 90, distance - 450};
    std::string text = "0 0 0 0 0 " + std::string(distance == 0 ? "0" : root_turns) +
                       triple(place) + triple({distance, distance, 0});
    for (int i = 0; i < limbs; ++i)
        text += triple(add ? Vec3{} : limb) + " 0 0 0";
    if (prop)
        text += triple(add ? Vec3{0, 0, 40 * distance} : Vec3{0, 0, 1 - distance / 500}) + " 0 0 0";
    return text + "\n";
}

std::string Traveler::text() const {
    std::string text = "HIERARCHY\nROOT reference\n{\nOFFSET 0 0 0\n" + std::string(six) +
                       "JOINT hips\n{\nOFFSET" + triple(hips) + "\n" + std::string(six);
    for (int i = 0; i < limbs; ++i)
        text += stltsa::format_text("JOINT limb{}\n{{\nOFFSET{}\n{}}}\n", i, triple(limb), six);
    if (prop)
        text += "JOINT prop\n{\nOFFSET 0 0 500\n" + std::string(six) + "}\n";
    return text + "}\n}\nMOTION\nFrames: 3\nFrame Time: 0.01\n" + row(0) + row(200) + row(450);
}

/// Whether positions have the right meaning, and the body the right place.
void check_meaning(const Traveler& traveler) {
    const Clip clip = bvh(traveler.text());
    assert_true(clip.skeleton->joints.back().adds == traveler.add);
    assert_int_equal(clip.notes.size(), traveler.add ? 1 : 0);
    ASSERT_NEAR(positions(clip)(0, 4), 90, 1e-12); // height of the hips
    ASSERT_NEAR(positions(clip)(0, 5), -450, 1e-12);
    if (traveler.limbs > 0)
        ASSERT_NEAR(positions(clip)(0, 6), traveler.limb[0], 1e-12);
}

void hips_that_travel_below_a_static_root_have_no_vote(void**) {
    check_meaning({.add = false});
    check_meaning({.add = true});
    check_meaning({.add = false, .limbs = 1});
    check_meaning({.add = true, .limbs = 1});
    check_meaning({.add = false, .limbs = 0}); // no other joint has positions: they replace
}

void one_joint_that_travels_has_one_vote(void**) {
    check_meaning({.add = false, .root_turns = "1"}); // the root carries the body, the hips vote
    check_meaning({.add = true, .root_turns = "1"});
    check_meaning({.add = false, .prop = true});
    check_meaning({.add = true, .prop = true});
}

void joints_without_an_offset_have_no_vote(void**) {
    check_meaning({.add = false, .limb = {0, 0, 0}});
    const Clip clip = bvh(every(Traveler{.add = true}.text(), "OFFSET 10 0 0", "OFFSET 0 0 0"));
    assert_false(clip.skeleton->joints.back().adds); // no evidence: the default, as in most files
}

void a_single_joint_replaces(void**) {
    const Clip clip = bvh("HIERARCHY\nROOT a\n{\nOFFSET 5 0 0\nCHANNELS 1 Xposition\n}\n"
                          "MOTION\nFrames: 2\nFrame Time: 0.01\n0\n1\n");
    assert_false(clip.skeleton->joints.back().adds);
    assert_true(positions(clip)(1, 0) == 1);
}

void a_root_offset_does_not_add_to_its_position(void**) {
    const Clip clip = bvh(replaced(small_bvh, "OFFSET 0.0 0.0 0.0", "OFFSET 1.0 2.0 3.0"));
    assert_true(positions(clip)(0, 1) == 2);
}

/// Some exporters count one frame more or less than they write.
void a_count_that_is_off_by_one(void**) {
    const Clip expected = bvh(small_bvh);
    for (const char* declared : {"2", "4"}) {
        const Clip clip = bvh(replaced(small_bvh, "Frames: 3", std::string("Frames: ") + declared));
        clip_testing::check_same(clip.values, expected.values, 0);
        assert_int_equal(clip.notes.size(), 1);
        assert_string_equal(clip.notes[0].c_str(), (std::string("the file declares ") + declared +
                                                    " frames, but has 3, which are read")
                                                       .c_str());
    }
}

void a_frame_time_of_zero_means_unknown(void**) {
    const std::string text = replaced(small_bvh, "Time: 0.0083333", "Time: 0");
    assert_true(bvh(text).fps == 0);
    assert_int_equal(bvh(text).notes.size(), 1);
    ReadOptions options;
    options.fps = 60;
    assert_true(parse(text, Format::bvh, options).fps == 60);
    assert_true(parse(text, Format::bvh, options).notes.empty());
    const Clip replaces = parse(small_bvh, Format::bvh, options);
    assert_true(replaces.fps == 60 && replaces.frame_time == 0);
    assert_int_equal(replaces.notes.size(), 1);
    assert_string_equal(replaces.notes[0].c_str(),
                        "option fps: 60 frames a second instead of the file's 120");
}

void tells_formats_by_content_and_suffix(void**) {
    assert_true(sniff(small_bvh) == Format::bvh);
    assert_true(sniff("\n" + every(small_bvh, "HIERARCHY", "hierarchy")) == Format::bvh);
    assert_true(sniff(small_amc) == Format::amc);
    assert_true(sniff("\x93NUMPY\x01") == Format::npy);
    assert_true(sniff("1,2,3\n") == Format::csv);
    assert_true(sniff("") == Format::csv);
    const TemporaryFolder folder;
    const Clip clip = stltsa::clip::read(folder.write("walk.BVH", small_bvh), {});
    assert_true(clip.format == Format::bvh);
    assert_string_equal(clip.path.c_str(), folder.path("walk.BVH").c_str());
    assert_true(stltsa::clip::read(folder.write("walk.txt", small_bvh), {}).format == Format::bvh);
    assert_true(stltsa::clip::read(folder.write("rows.txt", "1 2\n3 4\n"), {}).format ==
                Format::csv);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(reads_the_plain_file),
        cmocka_unit_test(reads_line_ends_of_every_system),
        cmocka_unit_test(reads_blanks_of_every_kind),
        cmocka_unit_test(reads_keywords_in_any_case),
        cmocka_unit_test(reads_headers_of_the_data_with_any_spacing),
        cmocka_unit_test(reads_braces_in_any_place),
        cmocka_unit_test(reads_rows_over_several_lines),
        cmocka_unit_test(reads_numbers_of_every_form),
        cmocka_unit_test(reads_names_with_blanks_and_without),
        cmocka_unit_test(reads_channels_in_any_order_and_number),
        cmocka_unit_test(recognizes_the_meaning_of_positions_below_the_root),
        cmocka_unit_test(hips_that_travel_below_a_static_root_have_no_vote),
        cmocka_unit_test(one_joint_that_travels_has_one_vote),
        cmocka_unit_test(joints_without_an_offset_have_no_vote),
        cmocka_unit_test(a_single_joint_replaces),
        cmocka_unit_test(a_root_offset_does_not_add_to_its_position),
        cmocka_unit_test(a_count_that_is_off_by_one),
        cmocka_unit_test(a_frame_time_of_zero_means_unknown),
        cmocka_unit_test(tells_formats_by_content_and_suffix),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
