// SPDX-License-Identifier: BSD-3-Clause
// src/phase: phases of a motion whose true phase is known, and signals on 0 to 100 % of its cycles.
#include <algorithm>
#include <complex>

#include "../checkpoints.hpp"
#include "../motion/testing.hpp"
#include "phase/phases.hpp"
#include "phase/resample.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::phase;

constexpr double rate = 50, period = 1.2;

/// In turns: the first half of each cycle is faster than the second.
double true_phase(double row) {
    const double t = row / rate / period;
    return t + 0.06 * std::sin(turn * t) / turn * 4;
}

Matrix motion(std::int64_t rows, double noise, unsigned seed) {
    Matrix samples = sampled(
        rows, 10, 1, [](double row, std::int64_t c) { return cyclic_pose(true_phase(row), c); });
    add_noise(samples, noise, seed);
    return samples;
}

/// Borders at whole turns of linear time, each off by up to `off` rows.
Borders sequence(double first, int cycles, double off) {
    Borders made;
    for (int i = 0; i <= cycles; ++i)
        made.push_back(first + i * rate * period + off * std::sin(2.3 * i));
    return made;
}

/// Largest difference of phases from the truth, less their mean difference.
double spread(const Run& run) {
    std::complex<double> sum = 0;
    const auto off = [&](std::int64_t i) {
        return run.phase[static_cast<std::size_t>(i)] -
               true_phase(static_cast<double>(run.begin + i));
    };
    for (std::int64_t i = 0; i < run.rows(); ++i)
        sum += std::polar(1.0, turn * off(i));
    const double mean = std::arg(sum) / turn;
    double largest = 0;
    for (std::int64_t i = 0; i < run.rows(); ++i)
        largest = std::max(largest, std::abs(std::remainder(off(i) - mean, 1.0)));
    return largest;
}

void borders_that_are_off_do_not_matter(void**) {
    const Matrix samples = motion(600, 0.05, 1);
    const Borders given = sequence(30, 8, 3);
    const Phases found = find_phases(samples.view(), rate, {&given, 1}, {});
    assert_false(found.linear);
    assert_true(found.residual < 0.1);
    const Run& run = found.runs[0];
    for (std::int64_t i = 0; i + 1 < run.rows(); ++i)
        assert_true(run.phase[static_cast<std::size_t>(i + 1)] >
                    run.phase[static_cast<std::size_t>(i)]);
    // The gauge makes time even on average, and the motion speeds up in each cycle: what is left is
    // the same in all of them.
    const double turns = run.phase.back() - run.phase.front();
    ASSERT_NEAR(turns, 8, 0.1);
    for (std::int64_t i = 0; i + 60 < run.rows(); ++i)
        ASSERT_NEAR(run.phase[static_cast<std::size_t>(i + 60)] -
                        run.phase[static_cast<std::size_t>(i)],
                    1, 0.01);
}

void phases_follow_the_motion_not_time(void**) {
    // Cycles of different tempo: linear time between borders is off by what the borders are.
    const auto slow = [](double row) { return row / 60 + 0.1 * std::sin(turn * row / 210); };
    Matrix samples =
        sampled(600, 10, 1, [&](double row, std::int64_t c) { return cyclic_pose(slow(row), c); });
    const Borders given = sequence(30, 8, 0);
    const Phases found = find_phases(samples.view(), rate, {&given, 1}, {});
    const Run& run = found.runs[0];
    double worst = 0, linear = 0;
    for (std::int64_t i = 0; i < run.rows(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const auto row = static_cast<double>(run.begin + i);
        worst = std::max(worst, std::abs((run.phase[at] - run.phase[0]) -
                                         (slow(row) - slow(static_cast<double>(run.begin)))));
        linear = std::max(linear, std::abs(row / 60 - slow(row)));
    }
    assert_true(linear > 0.09);
    assert_true(worst < 0.02);
}

void sequences_share_their_mean_cycle(void**) {
    const Matrix samples = motion(900, 0.02, 3);
    // The second begins 18 rows, 0.3 cycles, later than the first.
    const Borders given[] = {sequence(30, 5, 1), sequence(30 + 7 * 60 + 18, 4, 1)};
    const Phases found = find_phases(samples.view(), rate, given, {});
    const auto at = [&](std::size_t run, std::int64_t row) {
        return found.runs[run].phase[static_cast<std::size_t>(row - found.runs[run].begin)];
    };
    for (std::int64_t row = 60; row < 120; row += 10) // nine periods apart
        ASSERT_NEAR(std::remainder(at(0, row) - at(1, row + 9 * 60), 1.0), 0, 0.01);
}

/// Cycle k goes from phase k to k + 1, on average over the borders.
void borders_are_at_whole_phases(void**) {
    const Matrix samples = motion(900, 0.05, 3);
    const Borders given[] = {sequence(30, 5, 1), sequence(30 + 7 * 60, 4, 1)};
    const Phases found = find_phases(samples.view(), rate, given, {});
    double sum = 0;
    for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t k = 0; k < given[r].size(); ++k) {
            const double off = found.runs[r].phase_at(given[r][k]) - static_cast<double>(k);
            assert_true(std::abs(off) < 0.05);
            sum += off;
        }
    ASSERT_NEAR(sum, 0, 0.002);
}

/// Wherever cycles begin, with known sides or without: half a cycle off, a crop of markers had its
/// zero on the other foot.
void zero_does_not_depend_on_where_cycles_begin(void**) {
    const Matrix samples = motion(600, 0.02, 4);
    const Borders one = sequence(30, 6, 0);
    const auto at = [](const Phases& phases, std::int64_t row) {
        return phases.runs[0].phase[static_cast<std::size_t>(row - phases.runs[0].begin)] -
               phases.zero;
    };
    for (const auto& side : {std::vector<double>{1, -1, 0, 0, 0, 0, 0, 0, 0, 0}, {}}) {
        const Phases a = find_phases(samples.view(), rate, {&one, 1}, side);
        for (const double later : {7.0, 15.0, 23.0, 30.0, 41.0, 52.0}) {
            const Borders other = sequence(30 + later, 6, 0);
            const Phases b = find_phases(samples.view(), rate, {&other, 1}, side);
            assert_true(b.zero >= 0 && b.zero < 1);
            for (std::int64_t row = 100; row < 300; row += 20)
                ASSERT_NEAR(std::remainder(at(a, row) - at(b, row), 1.0), 0, 0.02);
        }
    }
}

/// Legs that stand still say nothing: the zero of a wave is that of its hands.
void sides_that_do_not_swing_are_not_asked(void**) {
    Matrix samples = motion(600, 0.02, 8);
    Matrix noisy = copied(samples.view());
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (const std::int64_t c : {0, 1}) {
            samples(i, c) *= 0.001;
            noisy(i, c) = samples(i, c) * -1; // the other leg first
        }
    const std::vector<double> side = {1, -1, 0, 0, 0, 0, 0, 0, 0, 0};
    const Borders given = sequence(30, 6, 0);
    const Phases a = find_phases(samples.view(), rate, {&given, 1}, side);
    const Phases b = find_phases(noisy.view(), rate, {&given, 1}, side);
    ASSERT_NEAR(std::remainder(a.zero - b.zero, 1.0), 0, 0.02);
}

void without_a_mean_cycle_time_is_linear(void**) {
    Matrix samples = motion(600, 5, 5);
    const Borders given = sequence(30, 8, 0);
    const Phases found = find_phases(samples.view(), rate, {&given, 1}, {});
    assert_true(found.linear);
    assert_true(found.residual > 0.4);
    const std::vector<double>& phase = found.runs[0].phase;
    for (std::size_t i = 0; i + 1 < phase.size(); ++i)
        ASSERT_NEAR(phase[i + 1] - phase[i], 1 / (rate * period), 1e-12);
}

void runs_grow_beyond_their_borders(void**) {
    const Matrix samples = motion(600, 0.02, 6);
    const Borders given = sequence(150, 4, 0);
    const Phases found = find_phases(samples.view(), rate, {&given, 1}, {});
    const Matrix both = stltsa::motion::pose_and_velocity(samples.view(), rate, found.mean.period);
    const Run run = grown(both.view(), found.mean, found.runs[0], {20, 580});
    assert_int_equal(run.begin, 20);
    assert_int_equal(run.end(), 580);
    assert_true(spread(run) < spread(found.runs[0]) + 0.02);
}

void a_peak_at_the_border_stays_one_peak(void**) {
    const Matrix samples = motion(600, 0.02, 7);
    const Borders given = sequence(30, 8, 0);
    const Phases found = find_phases(samples.view(), rate, {&given, 1}, {});
    Matrix peak(600, 1); // at phase 0
    const Run& run = found.runs[0];
    for (std::int64_t i = 0; i < peak.rows(); ++i) {
        const double off = std::remainder(run.phase_at(static_cast<double>(i)), 1.0);
        peak(i, 0) = std::exp(-off * off / 0.01);
    }
    const Resampled made = resample(peak.view(), {times_of(run, given, 101), {}});
    ASSERT_NEAR(made.mean(0, 0), 1, 0.02);
    ASSERT_NEAR(made.mean(100, 0), 1, 0.02);
    int peaks = 0; // on the circle
    for (std::int64_t s = 0; s < 100; ++s)
        peaks += made.mean(s, 0) > made.mean((s + 99) % 100, 0) &&
                 made.mean(s, 0) >= made.mean((s + 1) % 100, 0);
    assert_int_equal(peaks, 1);
}

void cycles_go_from_border_to_border(void**) {
    Run run{10, {}};
    for (int i = 0; i <= 80; ++i)
        run.phase.push_back(-0.01 + i * 0.025);
    const Borders borders{10, 50, 91}; // the last row is 90
    const Matrix rows = times_of(run, borders, 5);
    for (std::int64_t s = 0; s < 5; ++s) {
        ASSERT_NEAR(rows(0, s), 10 + 10 * static_cast<double>(s), 1e-12);
        ASSERT_NEAR(rows(1, s), 50 + 10.25 * static_cast<double>(s), 1e-12);
    }
    const Matrix shifted = times_of(run, borders, 5, 0.3);
    const double expected[] = {22, 32, 42, 12, 22};
    for (std::int64_t s = 0; s < 5; ++s)
        ASSERT_NEAR(shifted(0, s), expected[s], 1e-9);
}

void a_cycle_at_the_end_goes_on_at_its_beginning(void**) {
    Run run{10, {}};
    Matrix signal(50, 1);
    for (std::int64_t i = 0; i < 10; ++i)
        signal(i, 0) = std::nan("");
    for (int i = 0; i < 40; ++i) {
        run.phase.push_back(i * 0.025);
        signal(10 + i, 0) = std::cos(turn * run.phase.back());
    }
    const Turns turns{times_of(run, {10, 50}, 41), {{10, 50}}};
    ASSERT_NEAR(turns.rows(0, 40), 50, 1e-12);
    const Resampled made = resample(signal.view(), turns);
    for (std::int64_t s = 0; s <= 40; ++s)
        ASSERT_NEAR(made.mean(s, 0), std::cos(turn * static_cast<double>(s) / 40), 1e-9);
}

/// Each of many short sequences is too short for a checkpoint of its own, but together they take
/// long.
void many_short_sequences_have_checkpoints(void**) {
    const Matrix samples = motion(40'000, 0.05, 1);
    std::vector<Borders> sequences;
    for (int i = 0; i < 300; ++i)
        sequences.push_back(sequence(10 + 130 * i, 1, 0));
    assert_in_range(
        testing::checkpoints_of([&] { find_phases(samples.view(), rate, sequences, {}); }), 10,
        1000);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(borders_that_are_off_do_not_matter),
        cmocka_unit_test(phases_follow_the_motion_not_time),
        cmocka_unit_test(sequences_share_their_mean_cycle),
        cmocka_unit_test(borders_are_at_whole_phases),
        cmocka_unit_test(zero_does_not_depend_on_where_cycles_begin),
        cmocka_unit_test(sides_that_do_not_swing_are_not_asked),
        cmocka_unit_test(without_a_mean_cycle_time_is_linear),
        cmocka_unit_test(runs_grow_beyond_their_borders),
        cmocka_unit_test(a_peak_at_the_border_stays_one_peak),
        cmocka_unit_test(cycles_go_from_border_to_border),
        cmocka_unit_test(a_cycle_at_the_end_goes_on_at_its_beginning),
        cmocka_unit_test(many_short_sequences_have_checkpoints),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
