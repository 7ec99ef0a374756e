// SPDX-License-Identifier: BSD-3-Clause
// From a coordinate to margins and cycles: smoothing, extrema, steepest points, sequences.
#include "motion/testing.hpp"

#include <algorithm>

#include "motion/coordinate.hpp"
#include "motion/curve/extrema.hpp"
#include "motion/curve/smoothing.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/cycles.hpp"
#include "motion/margins.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;

std::vector<double> curve_of(std::size_t samples, const std::function<double(double)>& value) {
    std::vector<double> curve;
    for (std::size_t i = 0; i < samples; ++i)
        curve.push_back(value(static_cast<double>(i)));
    return curve;
}

Activity always_moving(std::size_t samples) {
    return {std::vector<double>(samples, 1.0), 1, std::vector<double>(samples, 1.0)};
}

void quantiles_are_linear_between_values(void**) {
    const std::vector<double> values{4, 1, 3, 2};
    ASSERT_NEAR(quantile(values, 0), 1, 0);
    ASSERT_NEAR(quantile(values, 1), 4, 0);
    ASSERT_NEAR(quantile(values, 0.25), 1.75, 1e-15);
    ASSERT_NEAR(median(values), 2.5, 1e-15);
    ASSERT_NEAR(median(std::vector<double>{}), 0, 0);
}

void smoothing_keeps_constants_and_damps_waves(void**) {
    const std::vector<double> level(50, 3.0);
    for (const double value : smooth(level, 4))
        ASSERT_NEAR(value, 3, 1e-14);
    const double sigma = 3, wavelength = 20;
    const auto wave = curve_of(200, [&](double t) { return std::sin(turn * t / wavelength); });
    const double damped = std::exp(-0.5 * std::pow(turn * sigma / wavelength, 2));
    const auto smoothed = smooth(wave, sigma);
    for (std::size_t i = 20; i < 180; ++i)
        ASSERT_NEAR(smoothed[i], damped * wave[i], 1e-3);
    assert_true(smooth(wave, 0) == wave);
}

void slopes_are_central(void**) {
    const std::vector<double> slopes = slope(std::vector<double>{0, 1, 4, 9});
    const std::vector<double> expected{1, 2, 4, 5};
    assert_true(slopes == expected);
}

void extrema_alternate_and_are_prominent(void**) {
    // Peaks at 10, 30, 50, ..., with a bump of 0.2 on every flank.
    const auto curve = curve_of(101, [](double t) {
        return std::sin(turn * (t - 5) / 20) + 0.2 * std::sin(turn * (t - 5) / 4);
    });
    const auto found = alternating_extrema(curve, 0.6);
    for (std::size_t i = 1; i < found.size(); ++i) {
        assert_true(found[i].peak != found[i - 1].peak);
        assert_true(found[i].at > found[i - 1].at);
    }
    const auto peaks = std::count_if(found.begin(), found.end(), [](auto e) { return e.peak; });
    assert_int_equal(peaks, 5);
    for (const Extremum& e : found) // each the most extreme of its surroundings
        for (std::int64_t i = std::max<std::int64_t>(0, e.at - 5);
             i < std::min<std::int64_t>(101, e.at + 6); ++i) {
            const double there = curve[static_cast<std::size_t>(i)];
            const double here = curve[static_cast<std::size_t>(e.at)];
            assert_true(e.peak ? there <= here : there >= here);
        }
}

void extrema_include_the_ends(void**) {
    const std::vector<double> rising{0, 1, 2, 3};
    const auto found = alternating_extrema(rising, 2);
    assert_int_equal(found.size(), 2);
    assert_int_equal(found[0].at, 0);
    assert_false(found[0].peak);
    assert_int_equal(found[1].at, 3);
    assert_true(found[1].peak);
    assert_true(alternating_extrema(rising, 4).empty());
    assert_true(alternating_extrema(std::vector<double>(10, 1.0), 0).empty());
    assert_true(alternating_extrema(std::vector<double>{}, 1).empty());
}

void finds_the_vertex_of_a_parabola(void**) {
    const auto parabola = [](double x) { return 3 - 2 * (x - 0.3) * (x - 0.3); };
    ASSERT_NEAR(parabola_vertex(parabola(-1), parabola(0), parabola(1)), 0.3, 1e-12);
    ASSERT_NEAR(parabola_vertex(1, 1, 1), 0, 0);
    ASSERT_NEAR(parabola_vertex(0, 1, 2), 0, 0);     // a line has no vertex
    ASSERT_NEAR(parabola_vertex(0, 1, 1.9), 0.5, 0); // beyond the neighbors
}

void cyclicity_recognizes_one_swing_per_cycle(void**) {
    const std::vector<double> level(200, 1.0);
    const auto swing = [&](double per_cycle) {
        return cyclicity(
            curve_of(200, [&](double t) { return std::sin(turn * per_cycle * t / 40.5); }), level,
            40.5);
    };
    ASSERT_NEAR(swing(1), 1, 0.01);
    ASSERT_NEAR(swing(2), 0, 0.02);
    assert_true(swing(0.5) < 0.2);
    const auto line = curve_of(200, [](double t) { return t; });
    ASSERT_NEAR(cyclicity(line, level, 40.5), 0, 0.01);
    assert_true(cyclicity(std::vector<double>(200, 1.0), level, 40.5) == 0);
    // Without movement nothing counts.
    auto drifting = curve_of(200, [](double t) { return std::sin(turn * t / 40.5); });
    std::vector<double> activity = level;
    for (std::size_t i = 100; i < 200; ++i) {
        drifting[i] = static_cast<double>(i);
        activity[i] = 0;
    }
    ASSERT_NEAR(cyclicity(drifting, activity, 40.5), 1, 0.02);
}

void more_dimensions_must_be_clearly_better(void**) {
    const std::vector<double> level(200, 1.0);
    const auto model = [](std::vector<double> once_per_cycle) {
        stltsa::ltsa::Model made;
        made.coords = Matrix(200, static_cast<std::int64_t>(once_per_cycle.size()));
        for (std::int64_t i = 0; i < 200; ++i)
            for (std::int64_t c = 0; c < made.coords.cols(); ++c) {
                const double share = once_per_cycle[static_cast<std::size_t>(c)];
                const double t = static_cast<double>(i) / 40;
                made.coords(i, c) =
                    share * std::sin(turn * t) + (1 - share) * std::sin(2 * turn * t);
            }
        return made;
    };
    std::vector<stltsa::ltsa::Model> models;
    models.push_back(model({0.8}));
    models.push_back(model({0.3, 0.85}));
    models.push_back(model({0.2, 0.3, 0.1}));
    Coordinate chosen = choose_coordinate(models, {}, level, 40);
    assert_int_equal(chosen.model, 0);
    models[0] = model({0.2});
    chosen = choose_coordinate(models, {}, level, 40);
    assert_int_equal(chosen.model, 1);
    assert_int_equal(chosen.column, 1);
    chosen = choose_coordinate(models, 3, level, 40);
    assert_int_equal(chosen.model, 2);
    assert_int_equal(chosen.column, 1);

    // A loop takes two columns that swing once per cycle.
    models[2] = model({1.0, 0.1, 0.1});
    Loop loop = *choose_loop(models, level, 40);
    assert_int_equal(loop.model, 1);
    models[2] = model({0.9, 0.1, 0.8});
    loop = *choose_loop(models, level, 40);
    assert_int_equal(loop.model, 2);
    assert_int_equal(loop.first, 0);
    assert_int_equal(loop.second, 2);
    models.resize(1);
    assert_true(!choose_loop(models, level, 40));
}

void margins_lie_at_the_steepest_points(void**) {
    const double period = 37.3;
    const auto curve =
        curve_of(260, [&](double t) { return std::sin(turn * (t - 12.4) / period); });
    const auto margins = find_margins(curve, always_moving(curve.size()));
    for (const Margin& margin : margins) {
        const double halves = (margin.at - 12.4) / (period / 2);
        ASSERT_NEAR(halves, std::round(halves), 0.005);
        assert_true(margin.rising == (std::lround(halves) % 2 == 0));
        if (&margin != &margins.front() && &margin != &margins.back())
            ASSERT_NEAR(margin.swing, 2, 0.02);
    }
    const auto found_margins = longest_sequence(margins, period);
    assert_int_equal(found_margins.size(), 14);
    const auto cycles = cycles_between(found_margins);
    assert_int_equal(cycles.size(), 6);
    for (const Cycle& cycle : cycles)
        ASSERT_NEAR(cycle.end - cycle.begin, period, 0.1);
    for (std::size_t i = 1; i < cycles.size(); ++i)
        assert_true(cycles[i].begin == cycles[i - 1].end);
}

/// Fast up, slow down: margins of one kind are a period apart, consecutive margins are not.
void uneven_halves_are_one_cycle(void**) {
    const auto curve = curve_of(300, [](double t) {
        const double phase = std::fmod(t, 60.0) / 60;
        return phase < 0.25 ? -std::cos(turn * phase / 0.5) : std::cos(turn * (phase - 0.25) / 1.5);
    });
    const auto found_margins =
        longest_sequence(find_margins(curve, always_moving(curve.size())), 60);
    assert_int_equal(found_margins.size(), 10);
    assert_int_equal(cycles_between(found_margins).size(), 4);
}

/// Standing in the middle of the swing or above: the first swing has 0.5 or 0.7 of the height, at
/// nearly full steepness.
void the_half_swing_from_standing_is_not_cyclic(void**) {
    for (const double stands_at : {0.0, 0.4}) {
        const auto curve = curve_of(240, [&](double t) {
            if (t < 45)
                return stands_at;
            if (t < 60)
                return stands_at - (stands_at + 1) * (1 - std::cos(turn * (t - 45) / 30)) / 2;
            return -std::cos(turn * (t - 60) / 40);
        });
        Activity activity = always_moving(curve.size());
        std::fill_n(activity.level.begin(), 47, 0.0);
        auto found_margins = longest_sequence(find_margins(curve, activity), 40);
        assert_int_equal(found_margins.size(), 9);
        ASSERT_NEAR(found_margins.front(), 70, 0.1);
        // The same swing at the start of a cut clip, with the standing at its end.
        if (stands_at > 0) {
            found_margins = longest_sequence(find_margins(curve, always_moving(curve.size())), 40);
            assert_int_equal(found_margins.size(), 10);
        }
        std::vector<double> reversed(curve.rbegin(), curve.rend());
        std::reverse(activity.level.begin(), activity.level.end());
        found_margins = longest_sequence(find_margins(reversed, activity), 40);
        assert_int_equal(found_margins.size(), 9);
        ASSERT_NEAR(found_margins.back(), 239 - 70, 0.1);
    }
}

void sequences_break_at_pauses_and_odd_swings(void**) {
    const auto swing = [](double t) { return -std::cos(turn * t / 40); };
    // Two cycles, one period of standing, then three cycles.
    const auto paused =
        curve_of(245, [&](double t) { return t < 80 ? swing(t) : (t < 120 ? -1.0 : swing(t)); });
    auto found_margins = longest_sequence(find_margins(paused, always_moving(paused.size())), 40);
    assert_int_equal(found_margins.size(), 6);
    assert_true(found_margins.front() > 120);
    // Three cycles, one of a third of the height, one more.
    const auto odd = curve_of(205, [&](double t) {
        const bool low = t >= 120 && t < 160;
        return low ? -1 + (1 + swing(t)) / 3 : swing(t);
    });
    found_margins = longest_sequence(find_margins(odd, always_moving(odd.size())), 40);
    assert_int_equal(found_margins.size(), 6);
    assert_true(found_margins.back() < 120);
}

void finds_the_most_typical_cycle(void**) {
    const double period = 25;
    Matrix samples = sampled(4 * 25 + 1, 3, 1, [&](double t, std::int64_t c) {
        return std::sin(turn * t / period + static_cast<double>(c));
    });
    const std::vector<Cycle> cycles{{0, 25}, {25, 50}, {50, 75}, {75, 100}};
    for (std::int64_t i = 0; i < 25; ++i) { // all but the third are wrong, in different ways
        samples(i, 0) += 0.3;
        samples(25 + i, 1) += 0.3;
        samples(75 + i, 2) += 0.3;
    }
    assert_int_equal(most_typical(cycles, samples.view()), 2);
    assert_int_equal(most_typical({cycles[0], cycles[1]}, samples.view()), 0);
    assert_int_equal(most_typical({}, samples.view()), -1);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(quantiles_are_linear_between_values),
        cmocka_unit_test(smoothing_keeps_constants_and_damps_waves),
        cmocka_unit_test(slopes_are_central),
        cmocka_unit_test(extrema_alternate_and_are_prominent),
        cmocka_unit_test(extrema_include_the_ends),
        cmocka_unit_test(finds_the_vertex_of_a_parabola),
        cmocka_unit_test(cyclicity_recognizes_one_swing_per_cycle),
        cmocka_unit_test(more_dimensions_must_be_clearly_better),
        cmocka_unit_test(margins_lie_at_the_steepest_points),
        cmocka_unit_test(uneven_halves_are_one_cycle),
        cmocka_unit_test(the_half_swing_from_standing_is_not_cyclic),
        cmocka_unit_test(sequences_break_at_pauses_and_odd_swings),
        cmocka_unit_test(finds_the_most_typical_cycle),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
