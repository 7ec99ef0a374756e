// SPDX-License-Identifier: BSD-3-Clause
// Activity, rests and units.
#include "motion/testing.hpp"

#include <algorithm>

#include "motion/activity.hpp"
#include "motion/rests.hpp"
#include "motion/units.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;

void typical_speed_is_that_of_the_motion(void**) {
    // A feature that moves at 2 per sample for 60 of 400 samples, drifts at 0.01 otherwise, and
    // jerks once.
    Matrix samples(400, 1);
    for (std::int64_t i = 1; i < 400; ++i)
        samples(i, 0) = samples(i - 1, 0) + (i >= 200 && i < 260 ? 2 : 0.01) + (i == 230 ? 20 : 0);
    const Activity activity = measure_activity(samples.view(), 30);
    ASSERT_NEAR(activity.typical, 2, 0.05);
    assert_true(activity.moving(210));
    assert_false(activity.moving(100));
    ASSERT_NEAR(activity.level[230], 1, 1e-9);

    Span span = moving_span(activity, 0);
    ASSERT_NEAR(static_cast<double>(span.first), 200, 3);
    ASSERT_NEAR(static_cast<double>(span.first + span.count), 260, 3);
    span = moving_span(activity, 250);
    assert_int_equal(span.first, 0);
    assert_int_equal(span.count, 400);
}

void a_body_that_never_moves_has_no_activity(void**) {
    Matrix still(50, 3);
    for (std::int64_t i = 0; i < 50; ++i)
        still(i, 1) = 0.1; // not exact in binary: smoothing must not create motion
    const Activity activity = measure_activity(still.view(), 30);
    assert_true(activity.typical == 0);
    assert_int_equal(moving_span(activity, 5).count, 50);
    const auto units = action_units(activity, 30);
    assert_int_equal(units.size(), 1);
    assert_true(units[0].kind == UnitKind::preparing);
}

/// Relative to motion at a speed of 1.
constexpr Standing standing{0.4, 8, 0.15};

/// Speed 0 up to `onset`, then rising by 0.05 per sample up to 1, plus noise of a standing body.
std::vector<double> starts_at(double onset, double sway, std::size_t samples) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> even(-1, 1);
    std::vector<double> speed;
    for (std::size_t i = 0; i < samples; ++i) {
        const double ramp = std::clamp(0.05 * (static_cast<double>(i) - onset), 0.0, 1.0);
        speed.push_back(std::hypot(ramp, sway * (1 + 0.2 * even(random))));
    }
    return speed;
}

void rests_end_at_the_onset(void**) {
    for (const double sway : {0.0, 0.02, 0.1, 0.2}) {
        const auto speed = starts_at(60, sway, 150);
        const auto rests = find_rests(speed, standing);
        assert_int_equal(rests.size(), 1);
        ASSERT_NEAR(rests[0].begin, 0, 0);
        ASSERT_NEAR(rests[0].end, 61, 2.5);

        std::vector<double> reversed(speed.rbegin(), speed.rend());
        const auto last = find_rests(reversed, standing);
        assert_int_equal(last.size(), 1);
        ASSERT_NEAR(last[0].end, 150, 0);
        ASSERT_NEAR(last[0].begin, 149 - rests[0].end, 1e-9);
    }
}

/// A swaying body is fastest just before it starts, which is not yet the start.
void sway_is_standing(void**) {
    std::vector<double> speed;
    for (std::size_t i = 0; i < 150; ++i) {
        const double since = static_cast<double>(i) - 60;
        const double sway = 0.2 * (1 + 0.3 * std::cos(turn * since / 40));
        speed.push_back(std::hypot(std::clamp(0.05 * since, 0.0, 1.0), sway));
    }
    const auto rests = find_rests(speed, standing);
    assert_int_equal(rests.size(), 1);
    ASSERT_NEAR(rests[0].end, 63, 3);
}

/// If the speeds of a rest scatter so much that motion beside it is no faster than two deviations
/// above their median.
void a_rest_ends_before_the_motion(void**) {
    std::vector<double> speed(60, 0.45);
    for (std::size_t i = 20; i < 40; ++i)
        speed[i] = i % 2 == 0 ? 0.0 : 0.39;
    const auto rests = find_rests(speed, standing);
    assert_int_equal(rests.size(), 1);
    assert_true(rests[0].begin >= 19 && rests[0].begin <= 20);
    assert_true(rests[0].end >= 39 && rests[0].end <= 40);
}

void short_dips_are_not_rests(void**) {
    std::vector<double> speed(100, 1.0);
    std::fill_n(speed.begin() + 40, 7, 0.0);
    assert_true(find_rests(speed, standing).empty());
    speed[47] = 0;
    assert_int_equal(find_rests(speed, standing).size(), 1);
    // The same at the ends of a clip, which may be cut at a turning point.
    std::fill_n(speed.begin(), 7, 0.0);
    assert_int_equal(find_rests(speed, standing).size(), 1);
    speed[7] = 0;
    assert_int_equal(find_rests(speed, standing).size(), 2);
}

Activity activity_of(std::vector<double> speed) {
    Activity activity;
    activity.typical = 1;
    activity.level = speed;
    activity.speed = std::move(speed);
    return activity;
}

void check_cover(const std::vector<Unit>& units, double samples) {
    assert_true(!units.empty());
    assert_true(units.front().begin == 0 && units.back().end == samples);
    for (std::size_t i = 0; i < units.size(); ++i) {
        assert_true(units[i].begin < units[i].end);
        assert_true(i == 0 || units[i].begin == units[i - 1].end);
    }
}

std::vector<UnitKind> kinds(const std::vector<Unit>& units) {
    std::vector<UnitKind> result;
    for (const Unit& unit : units)
        result.push_back(unit.kind);
    return result;
}

void five_units_or_fewer(void**) {
    using enum UnitKind;
    const std::vector<double> run{60.25, 75, 90.5, 105, 120.75};
    std::vector<double> speed(200, 1.0);
    auto units = cyclic_units(run, speed, 30);
    check_cover(units, 200);
    assert_true(kinds(units) == (std::vector{initial, cyclic, final}));
    assert_true(units[1].begin == 60.25 && units[1].end == 120.75);

    std::fill_n(speed.begin(), 40, 0.0);
    units = cyclic_units(run, speed, 30);
    check_cover(units, 200);
    assert_true(kinds(units) == (std::vector{preparing, initial, cyclic, final}));
    ASSERT_NEAR(units[0].end, 39, 1.01);

    // Of two rests after the cycles, the first one ends the motion; rests inside belong to the
    // cycles.
    std::fill_n(speed.begin() + 140, 20, 0.0);
    std::fill_n(speed.begin() + 172, 28, 0.0);
    std::fill_n(speed.begin() + 80, 9, 0.0);
    units = cyclic_units(run, speed, 30);
    check_cover(units, 200);
    assert_true(kinds(units) == (std::vector{preparing, initial, cyclic, final, wind_up}));
    ASSERT_NEAR(units[4].begin, 140, 1.01);
}

/// Movement beyond the rests next to the cycles is neither preparing nor wind-up.
void other_motion_is_action(void**) {
    using enum UnitKind;
    const std::vector<double> run{190, 205, 220, 235, 250};
    std::vector<double> speed(450, 0.05);
    std::fill(speed.begin() + 170, speed.begin() + 270, 1.0);
    std::fill(speed.begin() + 40, speed.begin() + 80, 0.9);
    std::fill(speed.begin() + 330, speed.begin() + 420, 0.7);
    auto units = cyclic_units(run, speed, 30);
    check_cover(units, 450);
    assert_true(kinds(units) == (std::vector{preparing, action, preparing, initial, cyclic, final,
                                             wind_up, action, wind_up}));
    ASSERT_NEAR(units[1].begin, 40, 1.01);
    ASSERT_NEAR(units[1].end, 80, 1.01);
    ASSERT_NEAR(units[7].begin, 330, 1.01);

    // To the very ends of the clip.
    std::fill(speed.begin(), speed.begin() + 40, 0.9);
    std::fill(speed.begin() + 420, speed.end(), 0.7);
    units = cyclic_units(run, speed, 30);
    check_cover(units, 450);
    assert_true(kinds(units) ==
                (std::vector{action, preparing, initial, cyclic, final, wind_up, action}));

    // Fidgeting: too short, or too slow.
    std::fill(speed.begin(), speed.begin() + 170, 0.05);
    std::fill(speed.begin() + 270, speed.end(), 0.05);
    std::fill(speed.begin() + 40, speed.begin() + 50, 1.0);
    std::fill(speed.begin() + 330, speed.begin() + 370, 0.5);
    units = cyclic_units(run, speed, 30);
    check_cover(units, 450);
    assert_true(kinds(units) == (std::vector{preparing, initial, cyclic, final, wind_up}));
}

void actions_between_rests(void**) {
    using enum UnitKind;
    std::vector<double> speed(300, 1.0);
    std::fill_n(speed.begin(), 30, 0.0);
    std::fill_n(speed.begin() + 120, 40, 0.0);
    std::fill_n(speed.begin() + 270, 30, 0.0);
    const auto units = action_units(activity_of(speed), 30);
    check_cover(units, 300);
    assert_true(kinds(units) == (std::vector{preparing, action, preparing, action, wind_up}));
    assert_true(kinds(action_units(activity_of(std::vector<double>(100, 1.0)), 30)) ==
                std::vector{action});
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(typical_speed_is_that_of_the_motion),
        cmocka_unit_test(a_body_that_never_moves_has_no_activity),
        cmocka_unit_test(rests_end_at_the_onset),
        cmocka_unit_test(sway_is_standing),
        cmocka_unit_test(a_rest_ends_before_the_motion),
        cmocka_unit_test(short_dips_are_not_rests),
        cmocka_unit_test(five_units_or_fewer),
        cmocka_unit_test(other_motion_is_action),
        cmocka_unit_test(actions_between_rests),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
