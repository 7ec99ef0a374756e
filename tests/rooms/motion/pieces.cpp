// SPDX-License-Identifier: BSD-3-Clause
// The steps from a recording to its segments, one by one.
#include "recordings.hpp"

#include <algorithm>

#include "../checkpoints.hpp"
#include "motion/behaviors/behaviors.hpp"
#include "motion/behaviors/change_points.hpp"
#include "motion/behaviors/grouping.hpp"
#include "motion/behaviors/likeness.hpp"
#include "motion/behaviors/repetitions.hpp"
#include "motion/cycles/least_squares.hpp"
#include "motion/cycles/phase_curve.hpp"
#include "motion/cycles/sides.hpp"
#include "motion/period/period_track.hpp"
#include "motion/recording/drafts.hpp"

namespace {

using namespace motion_testing;

void least_squares_are_exact_for_a_line(void**) {
    Matrix a(5, 2);
    std::vector<double> b;
    for (std::int64_t i = 0; i < 5; ++i) {
        a(i, 0) = 1;
        a(i, 1) = static_cast<double>(i);
        b.push_back(3 - 2 * static_cast<double>(i));
    }
    const auto x = least_squares(a.view(), b, 0);
    ASSERT_NEAR(x[0], 3, 1e-9);
    ASSERT_NEAR(x[1], -2, 1e-9);
    // A column of zeros gets no weight.
    for (std::int64_t i = 0; i < 5; ++i)
        a(i, 1) = 0;
    ASSERT_NEAR(least_squares(a.view(), b, 0)[1], 0, 0);
    // A ridge as large as the variance halves the weight of a single column.
    const Matrix one = [] {
        Matrix column(4, 1);
        for (std::int64_t i = 0; i < 4; ++i)
            column(i, 0) = 2;
        return column;
    }();
    ASSERT_NEAR(least_squares(one.view(), std::vector<double>{4, 4, 4, 4}, 1)[0], 1, 1e-12);
}

/// Points on a line: groups of points within 1, numbered by first appearance.
void groups_are_those_of_average_linkage(void**) {
    const std::vector<double> points{10, 0, 0.5, 10.4, 20, 0.2, 10.1};
    const auto groups =
        group(static_cast<std::int64_t>(points.size()), 1, [&](std::int64_t i, std::int64_t k) {
            return std::abs(points[static_cast<std::size_t>(i)] -
                            points[static_cast<std::size_t>(k)]);
        });
    assert_true((groups == std::vector<int>{0, 1, 1, 0, 2, 1, 0}));
    assert_true(group(0, 1, {}).empty());
    // The mean distance counts, not the smallest: 0 and 1 join, then 2.1 is 1.6 away.
    const std::vector<double> chain{0, 1, 2.1};
    assert_true((group(3, 1.2, [&](std::int64_t i, std::int64_t k) {
                     return std::abs(chain[static_cast<std::size_t>(i)] -
                                     chain[static_cast<std::size_t>(k)]);
                 }) == std::vector<int>{0, 0, 1}));
    // Beyond some thousands, the nearest earlier item decides.
    const auto many = group(
        2500, 0.5, [](std::int64_t i, std::int64_t k) { return (i - k) % 3 == 0 ? 0.0 : 1.0; });
    for (std::size_t i = 0; i < many.size(); ++i)
        assert_int_equal(many[i], i % 3);
}

void behaviors_are_divided_where_they_change(void**) {
    const Matrix samples = Recorder().cycles(15, 1, 0).cycles(15, 1, 3).cycles(15, 1, 6).samples();
    const Signal signal = make_signal(samples.view(), fps, 0, 0);
    const KernelFeatures features(signal);
    const auto borders = change_points(features, border_price(features));
    assert_int_equal(borders.size(), 2);
    ASSERT_NEAR(static_cast<double>(borders[0]), 150, 4);
    ASSERT_NEAR(static_cast<double>(borders[1]), 300, 4);
    assert_true(features.gain(0, 150, 300) > 2 * border_price(features));
    const Describer describe(features);
    assert_true(likeness(describe({0, 70}), describe({70, 140})) > 0.9);
    assert_true(likeness(describe({0, 140}), describe({160, 290})) < 0.5);
    const Matrix one = Recorder().cycles(300, 1, 0).samples();
    assert_true(
        change_points(KernelFeatures(make_signal(one.view(), fps, 0, 0)), border_price(features))
            .empty());
}

void the_period_is_tracked(void**) {
    const Matrix samples = Recorder().cycles(40, 1.5, 0, 2).samples();
    const Signal signal = make_signal(samples.view(), fps, 0, 0);
    const PeriodTrack track = track_period(signal, {0, signal.rows()}, {});
    assert_int_equal(track.stretches.size(), 1);
    const Stretch& stretch = track.stretches[0];
    assert_true(stretch.quality > 0.9);
    for (std::int64_t i = stretch.rows.begin + 60; i < stretch.rows.end - 60; ++i) {
        const double t = static_cast<double>(i) / fps;
        const double expected = fps * 1.5 / (1 + t / 40);
        ASSERT_NEAR(stretch.period[static_cast<std::size_t>(i - stretch.rows.begin)], expected,
                    0.08 * expected);
    }
    // Too short, still, or without repetition: no stretch.
    assert_true(track_period(signal, {0, 20}, {}).stretches.empty());
    const Matrix still = Recorder().rest(20).samples(0);
    const Signal none = make_signal(still.view(), fps, 0, 0);
    assert_true(track_period(none, {0, none.rows()}, {}).stretches.empty());
}

/// The curve goes on over the chunks without a jump, and its partner is a quarter behind.
void the_curve_keeps_phase_and_sign(void**) {
    const Matrix samples = Recorder().cycles(60, 1, 0).samples();
    const Signal signal = make_signal(samples.view(), fps, 0, 0);
    const Rows all{0, signal.rows()};
    const Stretch stretch{all, std::vector<double>(static_cast<std::size_t>(all.end), fps), 1};
    const PhaseCurve whole = trace_phase(signal, grow(signal, stretch, all));
    assert_true(whole.typical_cyclicity() > 0.95);
    const auto height = std::ranges::max(whole.curve);
    for (std::size_t i = samples_per_period; i < whole.curve.size(); ++i) {
        ASSERT_NEAR(whole.curve[i], whole.curve[i - samples_per_period], 0.05 * height);
        ASSERT_NEAR(whole.partner[i], whole.curve[i - samples_per_period / 4], 0.05 * height);
    }
}

void rests_and_motions_between_them(void**) {
    const Matrix samples = Recorder().rest(2).action(2, 0).rest(1.5).action(1, 3).rest(2).samples();
    const Signal signal = make_signal(samples.view(), fps, 0, 0);
    const Pauses pauses = find_pauses(signal, find_rests(signal));
    assert_int_equal(pauses.rests.size(), 3);
    assert_true(std::ranges::count(pauses.home, true) == 3);
    const auto motions = find_motions(signal, pauses, {{0, signal.rows()}});
    assert_int_equal(motions.size(), 2);
    ASSERT_NEAR(static_cast<double>(motions[0].begin), 2 * fps, 1);
    ASSERT_NEAR(static_cast<double>(motions[0].end), 4 * fps, 1);
    assert_true(unlikeness(signal, motions[0], motions[0]) < 1e-9);
    assert_true(unlikeness(signal, motions[0], motions[1]) > same_motion);
    assert_true((group_motions(signal, motions) == std::vector<int>{0, 1}));
}

void cycles_begin_on_one_side(void**) {
    std::vector<double> motion;
    for (int i = 0; i < 200; ++i)
        motion.push_back(std::sin(2 * std::numbers::pi * (i - 10) / 40));
    const std::vector<Interval> cycles{{20, 60}, {60, 100}, {100, 140}};
    Signal signal;
    signal.rate = 30;
    signal.usual.assign(motion.size(), 1);
    assert_false(halves_of(signal, cycles).reason.empty());
    signal.side = motion;
    signal.forward = true;
    for (const double each : motion) { // each side does half of it
        signal.one_side.push_back(each / 2);
        signal.other_side.push_back(-each / 2);
    }
    assert_true(halves_of(signal, cycles).reason.empty());
    ASSERT_NEAR(halves_of(signal, cycles).first, 0.5, 0);
    assert_true(std::isnan(halves_of(signal, std::span(cycles).first(2)).margin));
    // The motion is positive at 20 and negative at 40.
    assert_int_equal(leading_side(motion, std::vector<double>{20, 60, 100}), 1);
    assert_int_equal(leading_side(motion, std::vector<double>{40, 80, 120}), 0);
    signal.side.assign(200, 1);
    assert_false(halves_of(signal, cycles).reason.empty());
    // Both sides move alike, twice in each cycle.
    for (int i = 0; i < 200; ++i)
        signal.side[static_cast<std::size_t>(i)] = std::sin(2 * std::numbers::pi * (i - 10) / 20);
    assert_false(halves_of(signal, cycles).reason.empty());
}

/// The first step is longer than the second in each cycle.
void unequal_steps_are_unequal(void**) {
    Signal signal;
    signal.rate = 30;
    signal.forward = true;
    const auto swing = [](double phase) {
        const double off = (phase - std::round(phase)) / 0.1;
        return std::exp(-off * off / 2);
    };
    for (int i = 0; i < 200; ++i) {
        const double phase = (i - 20) / 40.0;
        signal.one_side.push_back(swing(phase));
        signal.other_side.push_back(swing(phase - 0.55));
        signal.side.push_back(swing(phase) - swing(phase - 0.55));
    }
    signal.usual.assign(200, 1);
    const std::vector<Interval> cycles{{20, 60}, {60, 100}, {100, 140}};
    const Halves halves = halves_of(signal, cycles);
    ASSERT_NEAR(halves.first, 0.55, 0.02);
    assert_true(halves.margin < 0.01);
}

/// Each step has checkpoints while it works on half an hour, in which the motion changes every ten
/// seconds.
void steps_of_long_recordings_have_checkpoints(void**) {
    Recorder recorder;
    for (int i = 0; i < 180; ++i)
        recorder.cycles(10, 1 + 0.2 * (i % 3), 3 * (i % 3));
    const Matrix samples = recorder.samples();
    const auto check = [&](int least, const auto& step) {
        assert_in_range(testing::checkpoints_of(step), least, 100000);
    };
    Signal signal;
    check(12, [&] { signal = make_signal(samples.view(), fps, 0, 0); });
    const KernelFeatures features(signal);
    std::vector<std::int64_t> borders;
    check(30, [&] { const KernelFeatures again(signal); });
    check(7, [&] { borders = change_points(features, border_price(features)); });
    check(190, [&] { behavior_borders(features, 0); });
    check(36, [&] { track_period(signal, {0, signal.rows()}, {}); });
    check(1000, [&] { group(1000, 0.5, [](auto, auto) { return 1.0; }); });
    assert_int_equal(borders.size(), 179);
}

/// Each repetition is compared with all before it, which takes long if there are thousands.
void drafts_have_checkpoints_between_repetitions(void**) {
    Recorder recorder;
    for (int i = 0; i < 40; ++i)
        recorder.rest(2).action(1.5, 0);
    const Matrix samples = recorder.rest(2).samples();
    const Signal signal = make_signal(samples.view(), fps, 0, 0);
    const KernelFeatures features(signal);
    const auto rests = find_rests(signal);
    const Pauses pauses = find_pauses(signal, rests);
    const auto parts = divide(signal, {&features, 0}, {rests, pauses.rests, {}}, {});
    std::vector<Draft> drafts;
    const int checkpoints =
        testing::checkpoints_of([&] { drafts = make_drafts(signal, parts, pauses, false); });
    assert_true(std::ranges::any_of(drafts, [](const Draft& draft) {
        return draft.kind == SegmentKind::repetitions && draft.motions.size() == 40;
    }));
    assert_in_range(checkpoints, 80, 1000);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(least_squares_are_exact_for_a_line),
        cmocka_unit_test(groups_are_those_of_average_linkage),
        cmocka_unit_test(behaviors_are_divided_where_they_change),
        cmocka_unit_test(the_period_is_tracked),
        cmocka_unit_test(the_curve_keeps_phase_and_sign),
        cmocka_unit_test(rests_and_motions_between_them),
        cmocka_unit_test(cycles_begin_on_one_side),
        cmocka_unit_test(unequal_steps_are_unequal),
        cmocka_unit_test(steps_of_long_recordings_have_checkpoints),
        cmocka_unit_test(drafts_have_checkpoints_between_repetitions),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
