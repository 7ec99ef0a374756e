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
    take_points(clip, "test.csv", {});
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
    assert_true(unit_of("heel_x_pixels") == "pixels");
    // The right and the left ankle; without the left one, rotations.
    assert_true(
        names_points({"toe_x", "toe_y", "ankle_rx", "ankle_ry", "ankle_lx", "ankle_ly"}, 2));
    assert_false(names_points({"toe_x", "toe_y", "ankle_rx", "ankle_ry", "hip_x", "hip_y"}, 2));
    assert_true(names_points({"x_heel", "y_heel", "z_heel", "x_toe", "y_toe", "z_toe"}));
    assert_true(names_points({"x1", "y1", "z1", "x2", "y2", "z2"}));
    assert_true(names_points({"X.heel (m)", "Y.heel (m)", "X.toe (m)", "Y.toe (m)"}, 2));
    assert_true(with("heel[0]", "heel[1]", "heel[2]") && with("heel (x)", "heel (y)", "heel (z)"));
    assert_true(with("heel_x", "heel_z", "heel_y") && with("heel.Z", "heel.X", "heel.Y"));
    assert_false(with("heel_x", "heel_x", "heel_y") || with("heel_y", "heel_z", "heel_z"));
    assert_false(with("heel_x (deg)", "heel_y (deg)", "heel_z (deg)"));
    assert_true(with("heel_x (mm)", "heel_y (mm)", "heel_z (mm)"));
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

/// Each coordinate goes to its place, wherever its column is.
void axes_in_any_order(void**) {
    const auto taken = [](const std::vector<std::string>& names) {
        Clip clip;
        clip.channel_names = names;
        clip.values = Matrix(1, std::ssize(names));
        for (std::int64_t c = 0; c < clip.values.cols(); ++c)
            clip.values(0, c) = static_cast<double>(c);
        take_points(clip, "test.csv", {});
        return clip;
    };
    const auto has = [](const Clip& clip, const std::vector<double>& values) {
        return std::ssize(values) == clip.values.cols() &&
               std::equal(values.begin(), values.end(), clip.values.row(0));
    };
    assert_true(has(taken({"a_z", "a_x", "a_y", "b_y", "b_z", "b_x"}), {1, 2, 0, 5, 3, 4}));
    const Clip apart = taken({"a_x", "b_x", "c_x", "a_y", "b_y", "c_y", "a_z", "b_z", "c_z"});
    assert_true(has(apart, {0, 3, 6, 1, 4, 7, 2, 5, 8}));
    assert_true(apart.channel_names == (std::vector<std::string>{"a_x", "a_y", "a_z", "b_x", "b_y",
                                                                 "b_z", "c_x", "c_y", "c_z"}));
    const Clip indexed = taken({"a[0]", "a[1]", "a[2]", "b[2]", "b[1]", "b[0]"});
    assert_true(has(indexed, {0, 1, 2, 5, 4, 3}) && indexed.channel_names[3] == "b_x");
    // Two points of one name.
    assert_true(has(taken({"a_x", "a_y", "a_z", "a_z", "a_y", "a_x"}), {0, 1, 2, 5, 4, 3}));
    // Confidence of three points in a plane, wherever it is: none is below 0.
    assert_true(
        has(taken({"a_y", "a_x", "a_score", "b_x", "b_y", "c_x", "c_y", "b_score", "c_score"}),
            {1, 0, 3, 4, 5, 6}));
}

/// The name of a file may say that all its columns are angles.
void files_of_angles(void**) {
    const auto space_in = [](const std::string& file) {
        Clip clip;
        clip.channel_names = columns_of_points(4);
        clip.values = Matrix(2, 12);
        take_points(clip, file, {});
        assert_int_equal(clip.notes.size(), clip.space == 0 ? 1 : 0);
        return clip.space;
    };
    for (const char* file : {"walk_rot.csv", "a/walk01_rot.csv", "joint angles.csv", "Euler_2.tsv"})
        assert_int_equal(space_in(file), 0);
    for (const char* file : {"walk.csv", "parrot.csv", "angles/walk.csv", "rot_walk.csv", ""})
        assert_int_equal(space_in(file), 3);
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
    take_points(clip, "test.csv", {});
    assert_true(clip.space == 3 && clip.channel_names == columns_of_points(3) &&
                clip.values(1, 3) == 8);
    assert_true(clip.notes.at(0).find("left out: column 'speed'") != std::string::npos);

    Clip mixed;
    mixed.channel_names = columns_of_points(1);
    mixed.channel_names.emplace_back("speed");
    mixed.values = Matrix(2, 4);
    take_points(mixed, "test.csv", {});
    assert_true(mixed.space == 0 && mixed.values.cols() == 4);
    assert_true(mixed.notes.at(0).find("3 columns are named as coordinates, but not taken") == 0 &&
                mixed.notes.at(0).find("'speed'") != std::string::npos);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(triples_of_names_are_points),
        cmocka_unit_test(axes_in_any_order),
        cmocka_unit_test(files_of_angles),
        cmocka_unit_test(columns_beside_points),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
