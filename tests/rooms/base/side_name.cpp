// SPDX-License-Identifier: BSD-3-Clause
// Left and right in the names of joints, points and columns.
#include "base/side_name.hpp"

#include "../assertions.hpp"

namespace {

using stltsa::Side;
using stltsa::Sided;
using Names = std::vector<std::string>;

void check(const Names& names, std::size_t index, Side side, std::size_t partner) {
    const Sided found = stltsa::sides_of(names)[index];
    if (found.side != side || found.partner != partner)
        FAIL("%s: side %d, partner %zu", names[index].c_str(), static_cast<int>(found.side),
             found.partner);
}

/// The forms of motion capture systems, of skeletons and of trackers of videos.
void pairs_of_every_form(void**) {
    const std::pair<const char*, const char*> pairs[] = {
        {"LHEE", "RHEE"},
        {"LASI", "RASI"},
        {"L_TOE", "R_TOE"},
        {"left_heel", "right_heel"},
        {"LEFT_HEEL", "RIGHT_HEEL"},
        {"leftheel", "rightheel"},
        {"l-ankle", "r-ankle"},
        {"l_ankle", "r_ankle"},
        {"Heel.L", "Heel.R"},
        {"Heel.L.001", "Heel.R.001"},
        {"DEF-toe.L", "DEF-toe.R"},
        {"toe_left", "toe_right"},
        {"toe_l", "toe_r"},
        {"FootLeft", "FootRight"},
        {"HeelL", "HeelR"},
        {"HeelL1", "HeelR1"},
        {"heell", "heelr"},
        {"LeftFoot", "RightFoot"},
        {"lfemur", "rfemur"},
        {"Lknee", "Rknee"},
        {"L.Knee", "R.Knee"},
        {"L Knee", "R Knee"},
        {"Knee (L)", "Knee (R)"},
        {"Lt Knee", "Rt Knee"},
        {"LBigToe", "RBigToe"},
        {"leftEar", "rightEar"},
        {"calcn_l", "calcn_r"},
        {"mixamorig:LeftFoot", "mixamorig:RightFoot"},
        {"mixamorigLeftFoot", "mixamorigRightFoot"},
        {"Bip01 L Foot", "Bip01 R Foot"},
        {"Bip001_L_Toe0", "Bip001_R_Toe0"},
        {"Subject:LHEE", "Subject:RHEE"},
        {"Subject:lheel", "Subject:rheel"},
        {"R:LHEE", "R:RHEE"},
        {"Rory_L:LeftFoot", "Rory_L:RightFoot"},
        {"Q_LKneeOut", "Q_RKneeOut"},
        {"HL", "HR"},
        {"RL", "RR"},
        {"hind paw L", "hind paw R"},
    };
    for (const auto& [left, right] : pairs) {
        const Names names{"head", right, left, "spine_01", "LUMBAR"};
        check(names, 1, Side::right, 2);
        check(names, 2, Side::left, 1);
        for (const std::size_t other : {0U, 3U, 4U})
            check(names, other, Side::neither, other);
    }
}

void names_without_a_side(void**) {
    for (const char* name :
         {"Clavicle",       "Larm",        "CLAV",         "LUMBAR",  "Lumbar", "ROOT",
          "Root",           "root",        "rib",          "L5",      "L4_L5",  "T10",
          "lower leg",      "reference",   "Rigid Body 1", "upright", "Bright", "light",
          "lock",           "LELB",        "HeelL",        "towel",   "Neck",   "pelvis",
          "mixamorig:Hips", "Bip01 Spine", "Subject:CLAV", ""}) {
        check({"head", name}, 1, Side::neither, 1);
    }
    check({"lock", "clock", "lumber", "level"}, 0, Side::neither, 0);
}

/// Contacts with the ground have the side of their names.
void names_of_events(void**) {
    const std::pair<const char*, Side> names[] = {
        {"eRHS", Side::right}, {"eLTO", Side::left},          {"rto", Side::right},
        {"LIC", Side::left},   {"Left Foot Off", Side::left}, {"LON", Side::left},
        {"ROFF", Side::right}, {"Foot Off", Side::neither},   {"ron", Side::neither},
    };
    for (const auto& [name, side] : names)
        check({"head", name}, 1, side, 1);
    check({"eRHS", "eLHS"}, 0, Side::right, 1);
    const auto others = stltsa::other_sides("eRHS", false);
    assert_true(others.size() == 1 && others[0].name == "eLHS");
    assert_true(!stltsa::foot_event("LHEE") && !stltsa::foot_event("") && !stltsa::foot_event("e"));
    assert_true(!stltsa::foot_event("left foot off")->is_strike);
    assert_true(stltsa::foot_event("left heel strike")->is_strike);
}

/// A name without a partner has the side that it states; names of several points pair in order.
void single_and_repeated_names(void**) {
    check({"LHEE", "head"}, 0, Side::left, 0);
    check({"Right Foot", "head"}, 1, Side::neither, 1);
    check({"Right Foot", "head"}, 0, Side::right, 0);
    const Names twice{"L_toe", "R_toe", "L_toe", "R_toe", "L_toe"};
    check(twice, 0, Side::left, 1);
    check(twice, 2, Side::left, 3);
    check(twice, 3, Side::right, 2);
    check(twice, 4, Side::left, 4);
    assert_true(stltsa::sides_of({}).empty());
    std::string left, right; // would be terabytes
    for (int i = 0; i < 1'000'000; ++i)
        left += "l ";
    right = "r" + left.substr(1);
    check({left, right}, 0, Side::left, 0);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(pairs_of_every_form),
        cmocka_unit_test(names_without_a_side),
        cmocka_unit_test(names_of_events),
        cmocka_unit_test(single_and_repeated_names),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
