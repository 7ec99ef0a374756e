// SPDX-License-Identifier: BSD-3-Clause
// Feet alone: they swing, but the body does not turn; they are longer and wider than high.
#include "clip/testing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "clip/features/points.hpp"
#include "clip/features/prepare.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

constexpr double fps = 60;

/// Feet alone, which swing against each other: the heel, ankle and toe of each in the order of
/// `at`.
Clip feet(double speed) {
    constexpr std::array<std::array<double, 2>, 3> at{{{-0.06, 0.03}, {0, 0.09}, {0.16, 0.02}}};
    Clip clip;
    clip.fps = fps;
    clip.space = 3;
    for (const char* name : {"LHEE", "LANK", "LTOE", "RHEE", "RANK", "RTOE"})
        for (const char* axis : {"_x", "_y", "_z"})
            clip.channel_names.push_back(std::string(name) + axis);
    clip.values = Matrix(600, 18);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::int64_t p = 0; p < 6; ++p) {
            const double side = p < 3 ? 1 : -1, t = static_cast<double>(i) / fps;
            const auto [forward, up] = at[static_cast<std::size_t>(p % 3)];
            const double swing = side * std::sin(2 * std::numbers::pi * t);
            const double lift = side * std::cos(2 * std::numbers::pi * t);
            clip.values(i, 3 * p) = speed * t + forward + 0.3 * swing;
            clip.values(i, 3 * p + 1) = 0.1 * side;
            clip.values(i, 3 * p + 2) = up + 0.1 * std::max(0.0, lift);
        }
    return clip;
}

/// A foot keeps its direction, and the feet their distance to the side.
void legs_that_swing_do_not_turn_the_body(void**) {
    const Matrix found = features(feet(1.3), Features::points, Axis::z);
    const double a = found(0, 6) - found(0, 0), b = found(0, 7) - found(0, 1);
    for (std::int64_t i = 0; i < found.rows(); ++i) {
        ASSERT_NEAR(found(i, 6) - found(i, 0), a, 1e-3);
        ASSERT_NEAR(found(i, 7) - found(i, 1), b, 1e-3);
        const double apart = a * (found(i, 1) - found(i, 10)) - b * (found(i, 0) - found(i, 9));
        ASSERT_NEAR(apart, 0.2 * std::hypot(a, b), 1e-3);
    }
}

/// Feet alone are longer and wider than high.
void up_of_feet_is_not_along_them(void**) {
    assert_true(points_up(feet(0)) == Axis::z);
    assert_true(points_up(feet(1.3)) == Axis::z);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(legs_that_swing_do_not_turn_the_body),
        cmocka_unit_test(up_of_feet_is_not_along_them),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
