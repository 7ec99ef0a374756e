// SPDX-License-Identifier: BSD-3-Clause
// Mirror images, and names of the other side.
#include "clip/arrays/mirror.hpp"

#include <cmath>

#include "base/side_name.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/testing.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Status;

constexpr const char* two_legs = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT LeftLeg
  {
    OFFSET 2 -1 0.5
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0.1 -8 0
    }
  }
  JOINT RightLeg
  {
    OFFSET -2.2 -1 0.4
    CHANNELS 3 Xrotation Yrotation Zrotation
    End Site
    {
      OFFSET 0 -9 1
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.01
1 10 3 5 -7 30 10 20 30 -5 3 8
2 10 4 6 -8 35 12 15 31 -9 2 7
)";

Clip parsed() {
    return parse(two_legs, Format::bvh, "two legs", {});
}

Pose pose_of(const Clip& clip, std::int64_t frame) {
    Pose pose;
    pose.place(*clip.skeleton, clip.values.row(frame));
    return pose;
}

void joints_are_where_their_partners_were(void**) {
    const Clip clip = parsed(), image = mirrored(clip, Axis::y);
    const std::size_t partner[] = {0, 3, 4, 1, 2};
    for (std::int64_t i = 0; i < 2; ++i) {
        const Pose before = pose_of(clip, i), after = pose_of(image, i);
        for (std::size_t j = 0; j < 5; ++j)
            for (std::size_t a = 0; a < 3; ++a) // the legs are apart along x
                ASSERT_NEAR(after.position[j][a],
                            (a == 0 ? -1 : 1) * before.position[partner[j]][a], 1e-12);
    }
    assert_string_equal(image.notes.back().c_str(), "mirror image: left and right are exchanged");
}

void twice_is_the_clip(void**) {
    const Clip clip = parsed(), twice = mirrored(mirrored(clip, Axis::y), Axis::y);
    for (std::int64_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 5; ++j)
            for (std::size_t a = 0; a < 3; ++a)
                ASSERT_NEAR(pose_of(twice, i).position[j][a], pose_of(clip, i).position[j][a],
                            1e-12);
}

void points_change_places(void**) {
    Clip clip;
    clip.fps = 100;
    clip.space = 3;
    for (const char* name : {"L_toe", "R_toe", "head"})
        for (const char* axis : {"_x", "_y", "_z"})
            clip.channel_names.push_back(std::string(name) + axis);
    clip.values = stltsa::Matrix(1, 9);
    for (std::int64_t c = 0; c < 9; ++c)
        clip.values(0, c) = static_cast<double>(c + 1);
    clip.events = {{0, "Foot Strike", "Left"}, {0, "RHS", ""}, {0, "Foot Off", "General"}};
    const Clip image = mirrored(clip, Axis::z); // x is reflected
    assert_true(image.events[0].label == "Foot Strike" && image.events[0].context == "Right");
    assert_true(image.events[1].label == "LHS" && image.events[1].context.empty());
    assert_true(image.events[2].label == "Foot Off" && image.events[2].context == "General");
    const double expected[] = {-4, 5, 6, -1, 2, 3, -7, 8, 9};
    for (std::int64_t c = 0; c < 9; ++c)
        assert_true(image.values(0, c) == expected[c]);
}

void points_of_one_name_are_told_apart_by_order(void**) {
    Clip clip;
    clip.fps = 100;
    clip.space = 2;
    for (const char* name : {"L_toe", "L_toe", "R_toe", "R_toe"})
        for (const char* axis : {"_x", "_y"})
            clip.channel_names.push_back(std::string(name) + axis);
    clip.values = stltsa::Matrix(1, 8);
    for (std::int64_t c = 0; c < 8; ++c)
        clip.values(0, c) = static_cast<double>(c + 1);
    const Clip image = mirrored(clip, {});
    const double expected[] = {-5, 6, -7, 8, -1, 2, -3, 4};
    for (std::int64_t c = 0; c < 8; ++c)
        assert_true(image.values(0, c) == expected[c]);
}

void what_has_no_sides_is_refused(void**) {
    Clip numbers;
    numbers.fps = 100;
    numbers.values = stltsa::Matrix(4, 5);
    ASSERT_FAILS(Status::unsupported, "no sides", mirrored(numbers, {}));
    Clip nameless = parsed();
    for (Joint& joint : nameless.skeleton->joints)
        joint.name = "bone";
    ASSERT_FAILS(Status::unsupported, "differ only in the side", mirrored(nameless, {}));
    Clip uneven = parsed();
    uneven.skeleton->joints[4].end_site = false;
    uneven.skeleton->joints[4].name = "RightFoot";
    ASSERT_FAILS(Status::unsupported, "end sites", mirrored(uneven, {}));
    Clip crooked = parsed();
    crooked.skeleton->joints[3].parent = 1; // the right leg hangs from the left one
    ASSERT_FAILS(Status::unsupported, "'LeftLeg' and 'RightLeg' are the two sides of one another",
                 mirrored(crooked, {}));
    Clip ambiguous = parsed();
    ambiguous.skeleton->joints[0].name = "L_R";
    ambiguous.skeleton->joints[1].name = "R_R";
    ambiguous.skeleton->joints[3].name = "L_L";
    ASSERT_FAILS(Status::unsupported, "cannot both be the other side of", mirrored(ambiguous, {}));
}

/// Three angles about any axes give every rotation, fewer do not: a side that cannot move as the
/// other one does has no mirror image, unless the other one does not use what it has more.
void sides_of_different_channels(void**) {
    const auto image_of = [](const char* left, const char* right, const char* rows) {
        std::string text = replaced(two_legs, "CHANNELS 3 Zrotation Xrotation Yrotation", left);
        text = replaced(text, "CHANNELS 3 Xrotation Yrotation Zrotation", right);
        text.resize(text.find("1 10 3"));
        const Clip clip = parse(text + rows, Format::bvh, "two legs", {});
        const Clip image = mirrored(clip, Axis::y);
        const Pose before = pose_of(clip, 1), after = pose_of(image, 1);
        const std::size_t partner[] = {0, 3, 4, 1, 2};
        for (std::size_t j = 0; j < 5; ++j)
            for (std::size_t a = 0; a < 3; ++a)
                ASSERT_NEAR(after.position[j][a],
                            (a == 0 ? -1 : 1) * before.position[partner[j]][a], 1e-12);
    };
    const char* const four = "0 0 0 0 0 0 5 10 20 30\n0 0 0 0 0 0 6 15 -21 31\n";
    ASSERT_FAILS(
        Status::unsupported,
        "'LeftLeg' cannot move as its other side 'RightLeg' does, because their channels "
        "or axes differ (rx; rz rx ry)",
        image_of("CHANNELS 1 Xrotation", "CHANNELS 3 Zrotation Xrotation Yrotation", four));
    ASSERT_FAILS(
        Status::unsupported, "(rx ry; ry rx)",
        image_of("CHANNELS 2 Xrotation Yrotation", "CHANNELS 2 Yrotation Xrotation", four));
    ASSERT_FAILS(Status::unsupported, "(rx; ty rx)",
                 image_of("CHANNELS 1 Xrotation", "CHANNELS 2 Yposition Xrotation",
                          "0 0 0 0 0 0 5 -1 20\n0 0 0 0 0 0 6 -1.1 -21\n"));
    image_of("CHANNELS 2 Xrotation Yrotation", "CHANNELS 2 Xrotation Yrotation", four);
    image_of("CHANNELS 1 Xrotation", "CHANNELS 3 Zrotation Xrotation Yrotation",
             "0 0 0 0 0 0 5 0 20 0\n0 0 0 0 0 0 6 0 -21 0\n");
}

void names_of_the_other_side(void**) {
    const auto other = [](const char* name, bool first) {
        const auto names = stltsa::other_sides(name, first);
        return names.empty() ? std::string() : names.front().name;
    };
    for (const auto& [left, right] : {std::pair{"LeftFoot", "RightFoot"},
                                      {"L_toe", "R_toe"},
                                      {"heel.l", "heel.r"},
                                      {"toe_left", "toe_right"},
                                      {"LToe", "RToe"}}) {
        assert_string_equal(other(left, false).c_str(), right);
        assert_string_equal(other(right, false).c_str(), left);
    }
    assert_string_equal(other("lfemur", true).c_str(), "rfemur");
    assert_string_equal(other("lfemur", false).c_str(), "");
    assert_string_equal(other("head", true).c_str(), "");
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(joints_are_where_their_partners_were),
        cmocka_unit_test(twice_is_the_clip),
        cmocka_unit_test(points_change_places),
        cmocka_unit_test(points_of_one_name_are_told_apart_by_order),
        cmocka_unit_test(what_has_no_sides_is_refused),
        cmocka_unit_test(sides_of_different_channels),
        cmocka_unit_test(names_of_the_other_side),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
