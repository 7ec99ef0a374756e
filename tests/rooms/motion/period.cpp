// SPDX-License-Identifier: BSD-3-Clause
// The lag after which a motion repeats.
#include "motion/testing.hpp"

#include "motion/period/choose_neighbors.hpp"
#include "motion/period/period.hpp"

namespace {

using namespace motion_testing;
using stltsa::motion::find_period;
using stltsa::motion::Period;

Period period_of(const Matrix& samples, double fps) {
    return find_period(samples.view(), fps, {});
}

void finds_the_period_of_harmonics(void**) {
    for (const double fps : {15.0, 30.0, 60.0, 120.0})
        for (const double seconds : {0.7, 1.1, 1.63, 3.9}) {
            const auto samples = static_cast<std::int64_t>(3.5 * seconds * fps);
            const Period found = period_of(
                sampled(samples, 10, fps,
                        [&](double t, std::int64_t c) { return cyclic_pose(t / seconds, c); }),
                fps);
            ASSERT_NEAR(found.samples / fps, seconds, 0.01 * seconds);
            assert_true(found.quality > 0.9);
        }
}

/// Left and right steps are mirror images: after half a cycle most of the pose is the opposite, but
/// the part that both sides share repeats.
void is_not_misled_by_half_cycles(void**) {
    const double fps = 30, seconds = 1.2;
    const Matrix walk = sampled(200, 10, fps, [&](double t, std::int64_t c) {
        const double sides = c % 2 == 0 ? 0.6 : -0.6;
        return sides * std::sin(turn * t / seconds) +
               std::cos(2 * turn * t / seconds + static_cast<double>(c));
    });
    ASSERT_NEAR(period_of(walk, fps).samples / fps, seconds, 0.005 * seconds);
}

/// After two cycles the motion is slightly more similar to itself than after one.
void prefers_the_single_cycle_to_its_multiples(void**) {
    const double fps = 30, seconds = 1.0;
    const Matrix walk = sampled(240, 10, fps, [&](double t, std::int64_t c) {
        return cyclic_pose(t / seconds, c) +
               0.25 * std::sin(turn * t / (2 * seconds) + static_cast<double>(c));
    });
    ASSERT_NEAR(period_of(walk, fps).samples / fps, seconds, 0.01);
}

void standing_does_not_count(void**) {
    Exercise exercise;
    exercise.stands = 8;
    exercise.rests = 5;
    const double fps = 30;
    Matrix samples = exercise.samples(fps);
    ASSERT_NEAR(period_of(samples, fps).samples / fps, exercise.period, 0.01);
    add_noise(samples, 0.1, 1);
    const Period standing = period_of(samples, fps);
    ASSERT_NEAR(standing.samples / fps, exercise.period, 0.02);
    exercise.stands = exercise.rests = 0.2;
    samples = exercise.samples(fps);
    add_noise(samples, 0.1, 1);
    ASSERT_NEAR(standing.quality, period_of(samples, fps).quality, 0.04);
}

void finds_no_period_without_repetition(void**) {
    const double fps = 30;
    Matrix noise(300, 30);
    add_noise(noise, 1, 7);
    assert_true(period_of(noise, fps).samples == 0);
    const Matrix line =
        sampled(300, 5, fps, [](double t, std::int64_t c) { return t * static_cast<double>(c); });
    assert_true(period_of(line, fps).samples == 0);
    assert_true(period_of(Matrix(300, 5), fps).samples == 0);
    assert_true(period_of(Matrix(3, 5), fps).samples == 0);
}

/// One and a quarter cycles: a repeated quarter proves nothing.
void needs_enough_repetition(void**) {
    const double fps = 30, seconds = 2;
    const auto cycles = [&](double count) {
        return sampled(static_cast<std::int64_t>(count * seconds * fps), 10, fps,
                       [&](double t, std::int64_t c) { return cyclic_pose(t / seconds, c); });
    };
    assert_true(period_of(cycles(1.25), fps).samples == 0);
    ASSERT_NEAR(period_of(cycles(1.7), fps).samples / fps, seconds, 0.01);
    // The same with standing around it, so that the clip itself is long enough.
    Exercise once;
    once.period = 3;
    once.cycles = 1;
    once.fading = 0.1;
    assert_true(period_of(once.samples(fps), fps).samples == 0);
}

/// 1.2 periods or 1.2 s, between the required number and the number of distinct frames.
void period_and_frames_determine_the_neighbors(void**) {
    using stltsa::motion::choose_neighbors;
    assert_int_equal(choose_neighbors({40, 0.9}, 30, {1000, 2, 2}), 48);
    assert_int_equal(choose_neighbors({}, 30, {1000, 2, 2}), 36);
    assert_int_equal(choose_neighbors({}, 0, {1000, 2, 2}), 12);
    assert_int_equal(choose_neighbors({}, 1, {1000, 2, 3}), 5);
    assert_int_equal(choose_neighbors({40, 0.9}, 30, {30, 2, 2}), 29);
    assert_int_equal(choose_neighbors({40, 0.9}, 30, {3, 2, 2}), 4);
    Matrix held(10, 2);
    held(5, 1) = 1;
    assert_int_equal(stltsa::motion::distinct_frames(held.view()), 3);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_period_of_harmonics),
        cmocka_unit_test(is_not_misled_by_half_cycles),
        cmocka_unit_test(prefers_the_single_cycle_to_its_multiples),
        cmocka_unit_test(standing_does_not_count),
        cmocka_unit_test(finds_no_period_without_repetition),
        cmocka_unit_test(needs_enough_repetition),
        cmocka_unit_test(period_and_frames_determine_the_neighbors),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
