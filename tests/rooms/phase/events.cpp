// SPDX-License-Identifier: BSD-3-Clause
// src/phase: events whose true places are known, in cycles of uneven tempo and in repetitions.
#include "phase/events.hpp"

#include "../motion/testing.hpp"
#include "motion/curve/statistics.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::phase;

constexpr double rate = 30;

/// Turns; the tempo changes by a third.
double phase_at(double row) {
    return row / 36 + 0.15 * std::sin(turn * row / 180);
}

/// The row at which that is `phase`.
double row_at(double phase) {
    double low = 0, high = 1000;
    while (high - low > 1e-9) {
        const double middle = (low + high) / 2;
        (phase_at(middle) < phase ? low : high) = middle;
    }
    return low;
}

Matrix motion(double noise, unsigned seed) {
    Matrix samples = sampled(
        500, 10, 1, [](double row, std::int64_t c) { return cyclic_pose(phase_at(row), c); });
    add_noise(samples, noise, seed);
    return samples;
}

Searched cyclic(const Matrix& samples) {
    Sequence given;
    for (int i = 1; i <= 11; ++i)
        given.borders.push_back(row_at(i) + std::sin(3.1 * i)); // a frame off
    const Phases phases = find_phases(samples.view(), rate, {&given, 1}, {});
    const Matrix both = pose_and_velocity(samples.view(), rate, phases.mean.period);
    return searched(samples.view(), rate, phases,
                    {grown(both.view(), phases.mean, phases.runs[0], {0, 500})});
}

/// Largest distance of an event from the true place, in rows; events nearer than 10 rows to the
/// ends do not count.
double worst(const std::vector<Event>& events, double phase) {
    double off = 0;
    for (const Event& event : events)
        if (event.row > 10 && event.row < 490)
            off = std::max(
                off, std::abs(event.row - row_at(std::round(phase_at(event.row) - phase) + phase)));
    return off;
}

void one_mark_finds_all(void**) {
    const Matrix samples = motion(0.02, 1);
    const Searched in = cyclic(samples);
    for (const double phase : {0.1, 0.35, 0.8}) {
        const double mark = row_at(5 + phase);
        const auto events = find_events(in, {&mark, 1});
        assert_true(events.size() >= 12);
        assert_true(worst(events, phase) < 0.5);
    }
}

void several_marks_average_their_errors(void**) {
    const Matrix samples = motion(0.02, 2);
    const Searched in = cyclic(samples);
    // Two rows late, early and right: the median is right.
    const double marks[] = {row_at(3.2) + 2, row_at(5.2) - 2, row_at(7.2)};
    const double wrong = row_at(3.2) + 2;
    assert_true(worst(find_events(in, marks), 0.2) < 0.7);
    assert_true(worst(find_events(in, {&wrong, 1}), 0.2) > 1.5);
}

void another_recording_has_them_too(void**) {
    const Matrix samples = motion(0.02, 3);
    // The same motion with other amplitudes, as of another body.
    Matrix other = motion(0.02, 4);
    for (std::int64_t i = 0; i < other.rows(); ++i)
        for (std::int64_t c = 0; c < other.cols(); ++c)
            other(i, c) *= 1 + 0.1 * std::sin(static_cast<double>(3 * c));
    const Searched from = cyclic(samples), in = cyclic(other);
    const double mark = row_at(5.35);
    assert_true(likeness(from, in) > 0.95);
    const auto events = find_events(from, {&mark, 1}, in);
    assert_true(events.size() >= 12);
    assert_true(worst(events, 0.35) < 1);
}

void guessed_errors_rise_with_the_distance(void**) {
    Matrix samples = motion(0.002, 5);
    const double bad = row_at(8.35);
    for (auto i = static_cast<std::int64_t>(bad) - 8; i < static_cast<std::int64_t>(bad) + 8; ++i)
        for (std::int64_t c = 0; c < samples.cols(); ++c)
            samples(i, c) += 0.3 * std::sin(0.3 * static_cast<double>(i + 3 * c));
    const Searched in = cyclic(samples);
    const double mark = row_at(5.35);
    double at_bad = 0;
    std::vector<double> elsewhere;
    for (const Event& event : find_events(in, {&mark, 1}))
        if (std::abs(event.row - bad) < 6)
            at_bad = event.error_ms;
        else
            elsewhere.push_back(event.error_ms);
    assert_true(at_bad > 1.5 * stltsa::motion::median(elsewhere));
}

void repetitions_have_one_each(void**) {
    // A bow of 40 rows every 100 rows.
    const Matrix samples = sampled(600, 6, 1, [](double row, std::int64_t c) {
        const double t = std::fmod(row, 100) - 30;
        const double shape = t > 0 && t < 40 ? (1 - std::cos(turn * t / 40)) / 2 : 0;
        const double later = t > 8 && t < 40 ? (1 - std::cos(turn * (t - 8) / 32)) / 2 : 0;
        return c % 2 == 0 ? shape * static_cast<double>(c + 1) : later * static_cast<double>(c);
    });
    std::vector<Sequence> given;
    for (int i = 0; i < 6; ++i)
        given.push_back({{100.0 * i + 28 + i % 2, 100.0 * i + 72 - i % 2}, 0});
    const Phases phases = find_phases_of_repetitions(samples.view(), rate, given);
    assert_false(phases.cyclic);
    const Searched in = searched(samples.view(), rate, phases, phases.runs);
    const double mark = 242;
    const auto events = find_events(in, {&mark, 1});
    assert_int_equal(events.size(), 6);
    for (std::size_t i = 0; i < events.size(); ++i)
        ASSERT_NEAR(events[i].row, 100.0 * static_cast<double>(i) + 42, 1);
}

void a_mark_outside_of_runs_finds_nothing(void**) {
    const Matrix samples = motion(0.02, 6);
    Searched in = cyclic(samples);
    in.runs[0].phase.resize(300);
    in.distance[0].resize(300);
    const double mark = 400;
    assert_int_equal(find_events(in, {&mark, 1}).size(), 0);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(one_mark_finds_all),
        cmocka_unit_test(several_marks_average_their_errors),
        cmocka_unit_test(another_recording_has_them_too),
        cmocka_unit_test(guessed_errors_rise_with_the_distance),
        cmocka_unit_test(repetitions_have_one_each),
        cmocka_unit_test(a_mark_outside_of_runs_finds_nothing),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
