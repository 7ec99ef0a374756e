// SPDX-License-Identifier: BSD-3-Clause
// Resampling, periods, distances of repetitions, and roughness of a motion.
#include <algorithm>

#include "clip/body/kinematics.hpp"
#include "clip/testing.hpp"
#include "synthesis/likeness.hpp"
#include "synthesis/measures.hpp"
#include "synthesis/resample.hpp"
#include "synthesis/testing.hpp"

using namespace synthesis_testing;
using namespace stltsa::synthesis;

namespace {

// ---- Resampling ----

void frames_at_source_times_are_the_source_frames(void**) {
    const Clip clip = walking({});
    const Matrix twice = resampled(clip, 2 * clip.fps);
    assert_int_equal(twice.rows(), 2 * clip.frames() - 1);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        assert_memory_equal(twice.row(2 * i), clip.values.row(i), channels * sizeof(double));
    const Matrix third = resampled(clip, clip.fps / 3);
    assert_int_equal(third.rows(), (clip.frames() - 1) / 3 + 1);
    for (std::int64_t i = 0; i < third.rows(); ++i)
        assert_memory_equal(third.row(i), clip.values.row(3 * i), channels * sizeof(double));
}

/// Between two frames: half of the path, and half of the turn about one axis.
void frames_between_source_frames_are_interpolated(void**) {
    const Clip clip = walking({});
    const Matrix twice = resampled(clip, 2 * clip.fps);
    const Joint& head = clip.skeleton->joints[1];
    for (std::int64_t i = 0; i + 1 < clip.frames(); ++i) {
        const double* between = twice.row(2 * i + 1);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(between[c], (clip.values(i, c) + clip.values(i + 1, c)) / 2, 1e-9);
        const auto a = joint_rotation(head, false, clip.values.row(i) + root_channels);
        const auto b = joint_rotation(head, false, clip.values.row(i + 1) + root_channels);
        const auto m = joint_rotation(head, false, between + root_channels);
        ASSERT_NEAR(std::abs(dot(m, a)), std::abs(dot(m, b)), 1e-12);
        ASSERT_NEAR(2 * dot(m, a) * dot(m, a) - 1, std::abs(dot(a, b)), 1e-9);
    }
}

/// 359 degrees and 1 degree are two degrees apart.
void angles_take_the_shorter_way(void**) {
    Matrix values(2, channels);
    std::fill_n(values.row(0), 2 * channels, 0.0);
    values(0, 3) = 359;
    values(1, 3) = 1;
    const Matrix twice = resampled(clip_of(60, std::move(values)), 120);
    ASSERT_NEAR(std::remainder(twice(1, 3), 360), 0, 1e-9);
    assert_true(std::abs(twice(1, 3) - twice(0, 3)) < 2); // and no whole turn in between
}

void rates_of_few_digits_are_the_same(void**) {
    assert_true(same_rate(120, 1 / 0.0083333));
    assert_true(same_rate(30, 1 / 0.03333));
    assert_false(same_rate(30, 29.97));
    assert_false(same_rate(60, 120));
}

// ---- Repetitions ----

void a_period_is_found_around_a_short_piece(void**) {
    for (const double period : {0.7, 1.0, 1.4}) {
        Walk walk;
        walk.seconds = 8;
        walk.period = period;
        const Track track = track_of(walking(walk));
        ASSERT_NEAR(period_near(track, 200, 230), period, 0.02);
    }
    Walk straight;
    straight.period = 1e9;
    straight.phase = 0.1;
    assert_true(period_near(track_of(walking(straight)), 100, 200) == 0);
}

void repetitions_are_as_far_apart_as_the_noise(void**) {
    Clip clip = walking({});
    const double exact = repetition_distance(track_of(clip), 60, 180, 1, 0.1);
    clip_testing::Random random;
    double before = exact;
    for (const double noise : {0.5, 2.0, 8.0}) { // degrees of the arm
        Clip noisy = clip;
        for (std::int64_t i = 0; i < clip.frames(); ++i)
            noisy.values(i, 11) += noise * random.next();
        const double found = repetition_distance(track_of(noisy), 60, 180, 1, 0.1);
        assert_true(found > before);
        before = found;
    }
    // No repetition is nearer than half a frame.
    const Track track = track_of(clip);
    std::vector<double> steps;
    for (std::int64_t i = 60; i < 180; ++i)
        steps.push_back(std::sqrt(squared_distance(track, i, track, i + 1, 0.1)));
    std::ranges::sort(steps);
    ASSERT_NEAR(exact, steps[60] / 2, 0.02 * exact);
}

/// An arm that rises by 10 degrees per cycle: the repetitions are that far apart.
void repetitions_are_other_cycles(void**) {
    Clip clip = walking({});
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 11) -= 10 * static_cast<double>(i) / clip.fps;
    const double found = repetition_distance(track_of(clip), 60, 180, 1, 0);
    const double expected =
        2 * std::sin(5 * std::numbers::pi / 180) * std::sqrt(30.0 * 30 + 38.0 * 38 + 3.0 * 3);
    ASSERT_NEAR(found, expected, 0.2 * expected);
}

/// A weak repetition in strong noise does not count.
void a_shallow_valley_is_not_a_period(void**) {
    Walk walk;
    walk.seconds = 8;
    Clip clip = walking(walk);
    clip_testing::Random random;
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (const std::int64_t c : {9, 10, 11})
            clip.values(i, c) += 60 * random.next();
    assert_true(period_near(track_of(clip), 200, 300) == 0);
}

// ---- Roughness ----

/// Equal frames except for one step of the arm, by `size` degrees at frame 100.
Track stepping(double size) {
    Matrix values(200, channels);
    for (std::int64_t i = 0; i < values.rows(); ++i) {
        std::fill_n(values.row(i), channels, 0.0);
        values(i, 11) = i < 100 ? 0 : size;
    }
    return track_of(clip_of(60, std::move(values)));
}

void a_step_counts_only_nearby(void**) {
    const double small = 0.1;
    const Track track = stepping(small);
    // Hand and its end turn about the shoulder: 30 below it, and 38 below and 3 before it.
    const double expected =
        small * std::numbers::pi / 180 * std::sqrt(30.0 * 30 + 38.0 * 38 + 3.0 * 3);
    for (const std::int64_t seam : {94, 100, 106}) {
        ASSERT_NEAR(roughness_near(track, seam).step, expected, 1e-3 * expected);
        ASSERT_NEAR(roughness_near(track, seam).acceleration, expected, 1e-3 * expected);
    }
    for (const std::int64_t seam : {50, 85, 115, 150})
        assert_true(roughness_near(track, seam).step == 0);
    // One step in a hundred is not typical.
    assert_true(usual_roughness(track, 50, 150).step < 0.1 * expected);
}

/// Constant speed is not acceleration.
void equal_steps_are_smooth(void**) {
    Matrix values(200, channels);
    for (std::int64_t i = 0; i < values.rows(); ++i) {
        std::fill_n(values.row(i), channels, 0.0);
        values(i, 11) = 0.2 * static_cast<double>(i);
    }
    const Track track = track_of(clip_of(60, std::move(values)));
    for (const Roughness& found : {roughness_near(track, 100), usual_roughness(track, 0, 200)}) {
        assert_true(found.step > 0.1);
        assert_true(found.acceleration < 0.01 * found.step);
    }
}

void usual_roughness_is_the_95th_percentile(void**) {
    const Track track = track_of(walking({}));
    const Roughness usual = usual_roughness(track, 0, track.frames());
    std::int64_t above = 0;
    for (std::int64_t i = 1; i < track.frames(); ++i)
        above += std::sqrt(squared_distance(track, i - 1, track, i, 0)) > usual.step;
    ASSERT_NEAR(static_cast<double>(above), 0.05 * static_cast<double>(track.frames()), 1.5);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(frames_at_source_times_are_the_source_frames),
        cmocka_unit_test(frames_between_source_frames_are_interpolated),
        cmocka_unit_test(angles_take_the_shorter_way),
        cmocka_unit_test(rates_of_few_digits_are_the_same),
        cmocka_unit_test(a_period_is_found_around_a_short_piece),
        cmocka_unit_test(repetitions_are_as_far_apart_as_the_noise),
        cmocka_unit_test(repetitions_are_other_cycles),
        cmocka_unit_test(a_shallow_valley_is_not_a_period),
        cmocka_unit_test(equal_steps_are_smooth),
        cmocka_unit_test(a_step_counts_only_nearby),
        cmocka_unit_test(usual_roughness_is_the_95th_percentile),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
