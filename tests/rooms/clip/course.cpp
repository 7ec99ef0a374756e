// SPDX-License-Identifier: BSD-3-Clause
// Way, stride and turn of a body over the ground.
#include "clip/body/course.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "clip/testing.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

constexpr double pi = std::numbers::pi;
constexpr std::int64_t frames = 601; // one turn in 300 frames
constexpr double radius = 3;

double angle(std::int64_t frame) {
    return 2 * pi * static_cast<double>(frame) / 300;
}

/// Four points of a rigid body that goes round counterclockwise as seen from above, facing ahead.
Clip round_walk(Axis up) {
    const std::int64_t axis = static_cast<std::int64_t>(up) - 1;
    Clip clip;
    clip.fps = 60;
    clip.space = 3;
    clip.values = Matrix(frames, 12);
    const double shape[4][3] = {{0.2, 0, 1}, {-0.2, 0.1, 1.2}, {0, 0.3, 0.8}, {0, -0.4, 1.5}};
    for (std::int64_t i = 0; i < frames; ++i)
        for (std::int64_t p = 0; p < 4; ++p) {
            const double c = std::cos(angle(i)), s = std::sin(angle(i));
            const double x = radius + shape[p][0], y = shape[p][1] + 0.1;
            clip.values(i, 3 * p + (axis + 1) % 3) = c * x - s * y;
            clip.values(i, 3 * p + (axis + 2) % 3) = s * x + c * y;
            clip.values(i, 3 * p + axis) = shape[p][2];
        }
    return clip;
}

/// Follows the shape above: its mean is at (0, 0, 1.125) and (0, 0.1) from the circle.
double mean_radius() {
    return std::hypot(radius, 0.1);
}

void check_round_walk(const Clip& clip, Axis up, double tolerance) {
    const Course course(clip, up, 3);
    const Travel half = course.between(0, 150);
    ASSERT_NEAR(half.way, pi * mean_radius(), tolerance);
    ASSERT_NEAR(half.stride, 2 * mean_radius(), tolerance);
    ASSERT_NEAR(half.turn, 180, 1e-6 + tolerance);
    const Travel more = course.between(100, 550);
    ASSERT_NEAR(more.turn, 540, 1e-6 + tolerance);
    ASSERT_NEAR(more.way, 3 * pi * mean_radius(), 3 * tolerance);
    ASSERT_NEAR(course.between(20.25, 40.75).way, 20.5 / 300 * 2 * pi * mean_radius(), tolerance);
}

void points_go_round_about_each_axis(void**) {
    for (const Axis up : {Axis::x, Axis::y, Axis::z})
        check_round_walk(round_walk(up), up, 1e-3);
}

void the_other_way_round_is_negative(void**) {
    Clip clip = round_walk(Axis::z);
    for (std::int64_t i = 0; i < frames; ++i)
        for (std::int64_t p = 0; p < 4; ++p)
            clip.values(i, 3 * p) = -clip.values(i, 3 * p);
    ASSERT_NEAR(Course(clip, Axis::z, 3).between(0, 450).turn, -540, 1e-6);
}

void points_come_and_go(void**) {
    Clip clip = round_walk(Axis::z);
    for (std::int64_t i = 30; i < 60; ++i)
        clip.values(i, 1) = std::numeric_limits<double>::quiet_NaN();
    for (std::int64_t i = 200; i < 210; ++i) // none is seen
        for (std::int64_t p = 0; p < 4; ++p)
            clip.values(i, 3 * p) = std::numeric_limits<double>::quiet_NaN();
    for (std::int64_t i = 100; i < 120; ++i) // missing, as in C3D files
        for (std::int64_t axis = 0; axis < 3; ++axis)
            clip.values(i, axis) = 0;
    check_round_walk(clip, Axis::z, 0.1);
}

void too_few_points_do_not_show_a_turn(void**) {
    Clip clip = round_walk(Axis::z);
    for (const std::int64_t p : {0, 1})
        clip.values(150, 3 * p) = std::numeric_limits<double>::quiet_NaN();
    const Travel half = Course(clip, Axis::z, 3).between(0, 150);
    assert_true(std::isnan(half.turn));
    ASSERT_NEAR(half.way, pi * mean_radius(), 0.1);
}

void what_has_no_ground_is_unknown(void**) {
    const Clip clip = round_walk(Axis::z);
    for (const Course& course : {Course(clip, Axis::none, 3), Course(clip, Axis::z, 0)}) {
        const Travel nothing = course.between(0, 150);
        assert_true(std::isnan(nothing.way) && std::isnan(nothing.stride) &&
                    std::isnan(nothing.turn));
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(points_go_round_about_each_axis),
        cmocka_unit_test(the_other_way_round_is_negative),
        cmocka_unit_test(points_come_and_go),
        cmocka_unit_test(too_few_points_do_not_show_a_turn),
        cmocka_unit_test(what_has_no_ground_is_unknown),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
