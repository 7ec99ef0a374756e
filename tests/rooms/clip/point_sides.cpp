// SPDX-License-Identifier: BSD-3-Clause
// The two sides of a body of points, by their names.
#include "clip/testing.hpp"

#include <cmath>

#include "clip/features/point_sides.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

struct Point {
    std::string name;
    double forward, left, up;
};

const std::vector<Point> points = {
    {"LHEE", -50, 90, 40},  {"RHEE", -55, -90, 45},  {"RTOE", 120, -100, 20}, {"LTOE", 125, 95, 20},
    {"LWRI", 30, 300, 800}, {"RWRI", 20, -290, 810}, {"HEAD", 60, 3, 1600}};

/// The features of a body that stands, turned about the up axis z.
Matrix standing(double angle, const std::vector<Point>& of) {
    Matrix rows(4, static_cast<std::int64_t>(3 * of.size()));
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        for (std::size_t p = 0; p < of.size(); ++p) {
            double* at = rows.row(i) + 3 * p;
            at[0] = std::cos(angle) * of[p].forward - std::sin(angle) * of[p].left;
            at[1] = std::sin(angle) * of[p].forward + std::cos(angle) * of[p].left;
            at[2] = of[p].up;
        }
    return rows;
}

Clip named(const std::vector<Point>& of) {
    Clip clip;
    clip.space = 3;
    clip.fps = 100;
    for (const Point& point : of)
        for (const char* axis : {"_x", "_y", "_z"})
            clip.channel_names.push_back(point.name + axis);
    clip.values = standing(0, of);
    return clip;
}

std::vector<double> weights(double angle, const std::vector<Point>& of) {
    return point_side_weights(named(of), Axis::z, standing(angle, of).view());
}

/// Weights point forward or backward on the feet, one way left and the other right, whichever name
/// of a pair comes first; hands and head have none.
void feet_have_sides(void**) {
    for (const double angle : {0.0, 0.6, 2.5, -1.7}) {
        const auto found = weights(angle, points);
        assert_int_equal(found.size(), 3 * points.size());
        for (std::size_t p = 0; p < points.size(); ++p) {
            const double along =
                std::cos(angle) * found[3 * p] + std::sin(angle) * found[3 * p + 1];
            const double size = std::hypot(found[3 * p], found[3 * p + 1]);
            assert_true(found[3 * p + 2] == 0);
            if (points[p].up > 100) {
                assert_true(size == 0);
                continue;
            }
            ASSERT_NEAR(size, 1, 1e-12);
            ASSERT_NEAR(std::abs(along), 1, 0.01);
            const bool as_first = (points[p].left > 0) == (points[0].left > 0);
            const double first = std::cos(angle) * found[0] + std::sin(angle) * found[1];
            assert_true((along * first > 0) == as_first);
        }
    }
}

/// The lowest points are feet even if one foot is higher than the other.
void a_limp_does_not_part_the_feet(void**) {
    const std::vector<Point> feet = {{"RHEE", -60, -90, 40},
                                     {"RTOE", 120, -90, 42},
                                     {"LHEE", -60, 90, 30},
                                     {"LTOE", 120, 90, 50}};
    assert_false(weights(0, feet).empty());
}

void without_names_there_are_no_sides(void**) {
    std::vector<Point> bare = points;
    for (std::size_t p = 0; p < bare.size(); ++p)
        bare[p].name = "m" + std::to_string(p);
    assert_true(weights(0, bare).empty());
    Clip clip = named(points);
    clip.channel_names.clear();
    const Matrix rows = standing(0, points);
    assert_true(point_side_weights(clip, Axis::z, rows.view()).empty());
    assert_true(point_side_weights(named(points), Axis::none, rows.view()).empty());
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(feet_have_sides),
        cmocka_unit_test(a_limp_does_not_part_the_feet),
        cmocka_unit_test(without_names_there_are_no_sides),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
