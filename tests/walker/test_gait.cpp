// SPDX-License-Identifier: BSD-3-Clause
// The walker's gait is human, and its cycles match the reported borders.
#include <csetjmp>
#include <cstdarg>
#include <cstddef>
#include <cstdint>

#include "gait.hpp"
#include "reading.hpp"

extern "C" {
#include <cmocka.h> // last: it defines fail as a macro
}

namespace {

using namespace walker;

void cycles_repeat_exactly(void**) {
    Settings s; // 132 frames per cycle
    const Walk walk = make_walk(s);
    const Interval& cyclic = unit(walk, "cyclic");
    const double stride = row(walk, cyclic.begin + 132)[2] - row(walk, cyclic.begin)[2];
    assert_true(stride > 120 && stride < 160); // cm, for a walk
    for (std::int64_t f = cyclic.begin; f + 132 < cyclic.end; ++f)
        for (std::size_t c = 0; c < channel_count; ++c) {
            const double step = row(walk, f + 132)[c] - row(walk, f)[c];
            assert_true(std::fabs(step - (c == 2 ? stride : 0)) < 1e-9);
        }
}

void half_a_cycle_is_the_mirror_image(void**) {
    Settings s;
    const Walk walk = make_walk(s);
    const Interval& cyclic = unit(walk, "cyclic");
    const Joints a = joints(walk, cyclic.begin);
    const Joints b = joints(walk, cyclic.begin + 66);
    for (const auto& [l, r] : {std::pair{ankle(a, left), ankle(b, right)},
                               std::pair{a.at[left_arm + 2], b.at[right_arm + 2]}}) {
        const Vector from_a = l - a.at[hips];
        const Vector from_b = r - b.at[hips];
        assert_true(distance({-from_a.x, from_a.y, from_a.z}, from_b) < 1e-6);
    }
}

void right_first_is_the_mirror_image(void**) {
    Settings s;
    const Walk one = make_walk(s);
    s.right_first = true;
    const Walk two = make_walk(s);
    for (const std::int64_t f : {std::int64_t{150}, std::int64_t{300}, std::int64_t{660}}) {
        const Vector a = ankle(joints(one, f), left);
        assert_true(distance({-a.x, a.y, a.z}, ankle(joints(two, f), right)) < 1e-9);
    }
}

/// The legs pass each other at the borders, within 1 % of a cycle.
void legs_pass_at_the_borders(void**) {
    for (const double stride : {0.7, 1.0, 1.15})
        for (const double turn : {0.0, 30.0}) {
            Settings s;
            s.fps = 1000;
            s.stride = stride;
            s.turn = turn;
            const Walk walk = make_walk(s);
            for (const Interval& cycle : walk.cycles)
                for (const std::int64_t f : {cycle.begin, (cycle.begin + cycle.end) / 2}) {
                    const double before = ahead(joints(walk, f - 11));
                    const double after = ahead(joints(walk, f + 11));
                    assert_true(before * after < 0);
                    assert_true((before > 0) == (f == cycle.begin)); // the right leg comes first
                }
        }
}

/// A foot may slip by millimeters while the other one takes over or gives back the weight, and not
/// at all in between; no foot sinks into the floor.
void feet_stay_on_the_floor(void**) {
    for (const double turn : {0.0, 30.0}) {
        Settings s;
        s.turn = turn;
        const Walk walk = make_walk(s);
        const Interval& cycle = walk.cycles[1];
        const double landing = cycle.end_s - 0.294 * s.period; // landing of the left heel
        for (std::int64_t f = cycle.begin; f < cycle.begin + 264; ++f) {
            const Joints now = joints(walk, f);
            const Joints next = joints(walk, f + 1);
            assert_true(heel(now, left, s.height).y > -0.5);
            assert_true(ball(now, left).y - make_sole(s.height).ball_height > -0.5);
            const double cycles = (static_cast<double>(f) / s.fps - landing) / s.period;
            const double phase = cycles - std::floor(cycles);
            const double slip =
                phase < 0.2 ? distance(heel(now, left, s.height), heel(next, left, s.height))
                            : distance(ball(now, left), ball(next, left));
            assert_true(slip < 0.3 || phase < 0.02 || phase > 0.58);
            assert_true(slip < 0.01 || phase < 0.13 || phase > 0.49);
        }
    }
}

/// Largest second difference of a rotation channel, in degrees per frame squared.
double jerkiest(const Walk& walk, const Interval& unit) {
    double largest = 0;
    for (std::int64_t f = std::max<std::int64_t>(unit.begin, 1); f < unit.end; ++f)
        for (std::size_t c = 3; c < channel_count; ++c) {
            const double bend = row(walk, f - 1)[c] - 2 * row(walk, f)[c] + row(walk, f + 1)[c];
            largest = std::max(largest, std::fabs(bend));
        }
    return largest;
}

/// The first and last step join the cycles without a jump in angle or speed.
void no_unit_joins_with_a_jump(void**) {
    for (const double ramp : {0.0, 0.3}) {
        Settings s;
        s.fps = 1000;
        s.ramp = ramp;
        const Walk walk = make_walk(s);
        const double usual = jerkiest(walk, unit(walk, "cyclic"));
        assert_true(jerkiest(walk, unit(walk, "initial")) < 1.1 * usual);
        assert_true(jerkiest(walk, unit(walk, "final")) < 1.1 * usual);
    }
}

/// The key points must stay within the ranges of normal walking (README.md).
void joint_angles_are_those_of_walking(void**) {
    double ankle_up = -90;
    double ankle_down = 90;
    double knee = 0;
    for (double phase = 0; phase < 1; phase += 0.001) {
        const LegAngles a = leg_angles(phase);
        const double angle = a.foot - a.thigh + a.knee;
        ankle_up = std::max(ankle_up, angle);
        ankle_down = std::min(ankle_down, angle);
        knee = std::max(knee, a.knee);
        assert_true(a.knee > 0 && a.thigh < 30 && a.thigh > -21);
    }
    assert_true(knee > 55 && knee < 65);
    assert_true(ankle_up > 8 && ankle_up < 17);
    assert_true(ankle_down < -13 && ankle_down > -22);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(cycles_repeat_exactly),
        cmocka_unit_test(half_a_cycle_is_the_mirror_image),
        cmocka_unit_test(right_first_is_the_mirror_image),
        cmocka_unit_test(legs_pass_at_the_borders),
        cmocka_unit_test(feet_stay_on_the_floor),
        cmocka_unit_test(no_unit_joins_with_a_jump),
        cmocka_unit_test(joint_angles_are_those_of_walking),
    };
    return cmocka_run_group_tests_name("walker gait", tests, nullptr, nullptr);
}
