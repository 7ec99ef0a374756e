// SPDX-License-Identifier: BSD-3-Clause
// Columns of files that are the coordinates of points, by their names.
#include "clip/testing.hpp"

#include "clip/csv/point_columns.hpp"
#include "clip/features/point_names.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

/// Whether a file with these columns is one of points in space, all of whose columns are kept.
bool names_points(const std::vector<std::string>& all, int space = 3) {
    Clip clip;
    clip.channel_names = all;
    clip.values = Matrix(2, std::ssize(all));
    take_points(clip, {});
    return clip.space == space && clip.values.cols() == std::ssize(all);
}

void triples_of_names_are_points(void**) {
    using Names = std::vector<std::string>;
    const auto with = [](const std::string& x, const std::string& y, const std::string& z) {
        Names all = columns_of_points(3);
        all.insert(all.end(), {x, y, z});
        return names_points(all);
    };
    assert_true(names_points(columns_of_points(3)));
    assert_true(with("heel_x", "heel_y", "heel_z") && with("heel.X", "heel.Y", "heel.Z"));
    assert_true(with("L heel x", "L heel y", "L heel z") && with("LHEEX", "LHEEY", "LHEEZ"));
    assert_true(with("Sub:heel:x", "sub:heel:y", "SUB:heel:z") && with("V_a-x", "V_a-y", "V_a-z"));
    assert_true(with("pelvis_x", "pelvis_y", "pelvis_z"));
    assert_false(names_points({}));
    assert_true(names_points(columns_of_points(1)));
    assert_true(names_points({"LHEEX", "LHEEY", "LHEEZ"}));
    assert_false(names_points({"max", "may"}) || names_points({"relax", "relay", "relaz"}));
    assert_false(names_points({"hip_x", "hip_y", "hip_z", "angle"})); // one point, something else
    assert_true(names_points({"heel_x [mm]", "heel_y [mm]", "heel_z [mm]"}));
    assert_true(names_points({"x_heel", "y_heel", "z_heel", "x_toe", "y_toe", "z_toe"}));
    assert_true(names_points({"x1", "y1", "z1", "x2", "y2", "z2"}));
    assert_true(names_points({"X.heel (m)", "Y.heel (m)", "X.toe (m)", "Y.toe (m)"}, 2));
    assert_false(with("heel_x", "heel_z", "heel_y"));
    assert_false(with("heel_x", "toe_y", "heel_z"));
    assert_false(with("_x", "_y", "_z") || with("x", "y", "z") || with("", "", ""));
    assert_false(with("hip_acc_x", "hip_acc_y", "hip_acc_z") || with("ROT.x", "ROT.y", "ROT.z"));
    assert_false(with("LHipAnglesX", "LHipAnglesY", "LHipAnglesZ"));
    Names more = columns_of_points(3);
    more.push_back("temperature");
    assert_false(names_points(more)); // one is left out
    assert_true(names_coordinate(more, 0) && names_coordinate(more, 8));
    assert_false(names_coordinate(more, 9));
}

/// Columns beside the points are left out if the points are many, or the points are not taken, and
/// a note says so.
void columns_beside_points(void**) {
    Clip clip;
    clip.channel_names = columns_of_points(3);
    clip.channel_names.insert(clip.channel_names.begin() + 3, "speed");
    clip.values = Matrix(2, 10);
    clip.values(1, 3) = 7;
    clip.values(1, 4) = 8;
    take_points(clip, {});
    assert_true(clip.space == 3 && clip.channel_names == columns_of_points(3) &&
                clip.values(1, 3) == 8);
    assert_true(clip.notes.at(0).find("left out: column 'speed'") != std::string::npos);

    Clip mixed;
    mixed.channel_names = columns_of_points(1);
    mixed.channel_names.emplace_back("speed");
    mixed.values = Matrix(2, 4);
    take_points(mixed, {});
    assert_true(mixed.space == 0 && mixed.values.cols() == 4);
    assert_true(mixed.notes.at(0).find("3 columns are named as coordinates, but not taken") == 0 &&
                mixed.notes.at(0).find("'speed'") != std::string::npos);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(triples_of_names_are_points),
        cmocka_unit_test(columns_beside_points),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
