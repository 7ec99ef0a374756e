// SPDX-License-Identifier: BSD-3-Clause
// src/phase: lags of curves, intervals of differences, and the two together.
#include <cmath>
#include <random>

#include "../motion/testing.hpp"
#include "motion/curve/statistics.hpp"
#include "phase/compare.hpp"
#include "phase/lag.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::phase;

/// samples x 2 over a cycle, the first sample not repeated.
Matrix curves(std::int64_t samples, double late, double high = 0.4) {
    Matrix made(samples, 2);
    for (std::int64_t s = 0; s < samples; ++s) {
        const double at = turn * (static_cast<double>(s) / static_cast<double>(samples) - late);
        made(s, 0) = 3 + std::sin(at) + high * std::cos(2 * at);
        made(s, 1) = 2 * std::cos(at) - high * std::sin(3 * at);
    }
    return made;
}

void quantiles_are_those_of_tables(void**) {
    const double table[][2] = {{1, 12.7062}, {1.5, 6.0167}, {2, 4.3027},  {3, 3.1824},
                               {5, 2.5706},  {10, 2.2281},  {30, 2.0423}, {1000, 1.9623}};
    for (const auto& [freedom, value] : table)
        ASSERT_NEAR(stltsa::motion::t_quantile(freedom) / value, 1,
                    freedom < 2 && freedom > 1 ? 0.03 : 5e-4);
}

void a_lag_is_found_to_a_part_of_a_sample(void**) {
    for (const double late : {0.0, 0.013, -0.11, 0.2437}) {
        const Lag lag = lag_between(curves(100, 0).view(), curves(100, late).view(), 25);
        ASSERT_NEAR(lag.samples, 100 * late, 0.02);
        ASSERT_NEAR(lag.correlation, 1, 1e-4);
    }
    assert_true(
        std::isnan(lag_between(curves(100, 0).view(), curves(100, 0.3).view(), 25).samples));
    const Lag far = lag_between(curves(100, 0).view(), curves(100, 0.3).view(), 50);
    ASSERT_NEAR(far.samples, 30, 0.02);
    const Lag still = lag_between(curves(100, 0).view(), Matrix(100, 2).view(), 25);
    assert_true(std::isnan(still.samples) && std::isnan(still.correlation));
}

void the_next_best_lag_is_found(void**) {
    Matrix twice(100, 1);
    for (std::int64_t s = 0; s < 100; ++s) {
        const double at = turn * static_cast<double>(s) / 100;
        twice(s, 0) = std::sin(2 * at) + 0.1 * std::sin(at);
    }
    const Lag lag = lag_between(twice.view(), twice.view(), 50);
    ASSERT_NEAR(lag.samples, 0, 1e-9);
    ASSERT_NEAR(lag.runner_up, (1 - 0.01) / (1 + 0.01), 1e-3);
    Matrix narrow(100, 1); // each peak is one sample wide
    for (std::int64_t s = 0; s < 100; ++s)
        narrow(s, 0) =
            (s % 2 == 0 ? 1 : -1) * (1 + 0.3 * std::cos(turn * static_cast<double>(s) / 100));
    const Lag at_end = lag_between(narrow.view(), later(narrow.view(), 20).view(), 20);
    ASSERT_NEAR(at_end.samples, -20, 1e-9);
    ASSERT_NEAR(at_end.runner_up, (1 + 0.045 * std::cos(turn * 0.02)) / 1.045, 1e-9);
    const Matrix once = curves(100, 0, 0);
    assert_true(std::isnan(lag_between(once.view(), once.view(), 50).runner_up));
}

void later_and_slope_are_cyclic(void**) {
    const Matrix at = curves(100, 0), moved = later(at.view(), 12.5), there = curves(100, -0.125);
    for (std::int64_t s = 0; s < 100; ++s)
        ASSERT_NEAR(moved(s, 0), there(s, 0), 5e-3);
    const Matrix rise = slope(at.view());
    ASSERT_NEAR(rise(0, 0), turn / 100, 1e-4);
    ASSERT_NEAR(rise(50, 0), -turn / 100, 1e-4);
}

/// Values with a correlation of `memory` with the one before.
std::vector<double> remembering(std::int64_t count, double memory, std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::vector<double> values{normal(random)};
    while (std::ssize(values) < count)
        values.push_back(memory * values.back() + std::sqrt(1 - memory * memory) * normal(random));
    return values;
}

Quantity quantity(std::vector<double> values, double value) {
    double mean = 0;
    for (const double each : values)
        mean += each / static_cast<double>(values.size());
    for (double& each : values)
        each -= mean;
    return {value + mean, std::move(values)};
}

/// How often intervals contain the true value, 2, for cycles that resemble those before them.
double coverage(double memory, bool paired) {
    std::mt19937 random(7);
    int inside = 0;
    constexpr int tries = 400, like = 12;
    for (int i = 0; i < tries; ++i) {
        Quantity first, second;
        Dependences all(paired);
        for (int q = 0; q < like; ++q) {
            first = quantity(remembering(12, memory, random), 1);
            second = quantity(remembering(paired ? 12 : 9, memory, random), 3);
            all.add(first, second);
        }
        const Estimate found = estimate(first, second, all.value());
        inside += found.low <= 2 && 2 <= found.high ? 1 : 0;
    }
    return static_cast<double>(inside) / tries;
}

void intervals_contain_the_truth(void**) {
    for (const bool paired : {false, true}) {
        ASSERT_NEAR(coverage(0, paired), 0.95, 0.03);
        assert_true(coverage(0.4, paired) > 0.89);
    }
}

void single_cycles_have_no_interval(void**) {
    const Quantity one{1, {0}}, other{3, {0}};
    const Estimate found = estimate(one, other, {});
    ASSERT_NEAR(found.difference, 2, 0);
    assert_true(std::isnan(found.low) && std::isnan(found.first_sd) && !found.significant);
    const Quantity same{1, {0, 0, 0}}, changed{1 + 1e-12, {0, 0, 0}};
    assert_false(estimate(same, changed, {}).significant); // only rounding
    const Quantity far{1.01, {0, 0, 0}};
    assert_true(estimate(same, far, {}).significant);
}

/// Cycles of 100 samples from a run at a constant rate.
Resampled cycles_of(double late, double gain, unsigned seed) {
    constexpr std::int64_t count = 9;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Matrix signals(100 * count + 1, 3), rows(count, 101);
    for (std::int64_t k = 0; k < count; ++k) {
        const double own_gain = gain * (1 + 0.03 * normal(random));
        const double own_late = late + 0.005 * normal(random);
        for (std::int64_t s = 0; s <= 100; ++s) {
            const double at = turn * static_cast<double>(s) / 100;
            const std::int64_t row = 100 * k + s;
            signals(row, 0) = own_gain * 5 * std::sin(at);
            signals(row, 1) = 4 * std::cos(at - turn * own_late);
            signals(row, 2) = 4 * std::cos(at + turn * own_late);
            rows(k, s) = static_cast<double>(row);
        }
    }
    return resample(signals.view(), {std::move(rows), {}});
}

void lag_and_amplitude_have_their_errors(void**) {
    const Resampled first = cycles_of(0, 1, 1), second = cycles_of(0.04, 1.3, 2);
    const std::vector<std::int64_t> groups{0, 1, 2};
    const Differences found = compare(first, second, groups, false);
    const PartDifference &gain = found.parts[0], &late = found.parts[1], &early = found.parts[2];
    ASSERT_NEAR(late.lag.difference, 0.04, 0.006);
    ASSERT_NEAR(early.lag.difference, -0.04, 0.006);
    ASSERT_NEAR(late.lag.first_sd, 0.005, 0.003);
    ASSERT_NEAR(gain.ratio.difference, 1.3, 0.05);
    ASSERT_NEAR(gain.amplitude.first_sd, 10 * 0.03, 0.2);
    assert_true(late.lag.significant && early.lag.significant && gain.amplitude.significant);
    assert_false(late.amplitude.significant);
    assert_true(found.columns.size() == 3 && found.difference.rows() == 101);
    // Two columns that are one part: the longest diameter of an ellipse.
    const std::vector<std::int64_t> together{0, 0, 1};
    const Differences joint = compare(first, second, together, false);
    ASSERT_NEAR(joint.parts[0].amplitude.first, 10, 0.4);
    assert_true(std::isnan(joint.parts[0].mean.difference));
}

/// Ten cycles of two columns, by turns 0.01 of a cycle early and late.
Resampled jittered(double late, double by = 0.01) {
    Matrix signals(1001, 2), rows(10, 101);
    for (std::int64_t k = 0; k < 10; ++k)
        for (std::int64_t s = 0; s <= 100; ++s) {
            const double own = late + (k % 2 == 0 ? by : -by);
            const double at = turn * (static_cast<double>(s) / 100 - own);
            signals(100 * k + s, 0) = std::sin(at);
            signals(100 * k + s, 1) = std::cos(at);
            rows(k, s) = static_cast<double>(100 * k + s);
        }
    return resample(signals.view(), {std::move(rows), {}});
}

void deviations_of_lags_are_those_of_the_cycles(void**) {
    const Resampled first = jittered(0), second = jittered(0.04);
    const std::vector<std::int64_t> groups{0, 1};
    const double sd = 0.01 * std::sqrt(10.0 / 9);
    const Estimate pairs = compare(first, second, groups, true).parts[0].lag;
    ASSERT_NEAR(pairs.difference, 0.04, 1e-3);
    ASSERT_NEAR(pairs.first_sd / sd, 1, 0.1);
    ASSERT_NEAR(pairs.second_sd / sd, 1, 0.1);
    ASSERT_NEAR(pairs.error, 0, 2e-4); // both are late together
    const Differences found = compare(first, second, groups, false);
    ASSERT_NEAR(found.shift, 0.04, 1e-3);
    ASSERT_NEAR(found.parts[0].lag.difference, 0, 1e-3); // counts from that of the body
    ASSERT_NEAR(found.parts[0].lag.first_sd, 0, 1e-3);
    ASSERT_NEAR(estimate({0, {-1, 0, 1}}, {0, {-1, 0, 1}}, {}).first_sd, 1, 1e-12);
}

/// What chance would give is due to the cycles of both.
void chance_has_the_spread_of_both(void**) {
    const Resampled still = jittered(0, 0), moves = jittered(0);
    const std::vector<std::int64_t> groups{0, 1};
    for (const bool paired : {false, true}) {
        const double second = compare(still, moves, groups, paired).parts[0].chance;
        ASSERT_NEAR(second, turn * 0.01 / std::sqrt(2.0) / 3, 1e-3); // of 10 cycles
        ASSERT_NEAR(compare(moves, still, groups, paired).parts[0].chance, second, 1e-12);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(quantiles_are_those_of_tables),
        cmocka_unit_test(a_lag_is_found_to_a_part_of_a_sample),
        cmocka_unit_test(the_next_best_lag_is_found),
        cmocka_unit_test(later_and_slope_are_cyclic),
        cmocka_unit_test(intervals_contain_the_truth),
        cmocka_unit_test(single_cycles_have_no_interval),
        cmocka_unit_test(lag_and_amplitude_have_their_errors),
        cmocka_unit_test(deviations_of_lags_are_those_of_the_cycles),
        cmocka_unit_test(chance_has_the_spread_of_both),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
