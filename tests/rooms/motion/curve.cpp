// SPDX-License-Identifier: BSD-3-Clause
// Curves of one coordinate: smoothing, slopes, extrema, cyclicity.
#include "motion/testing.hpp"

#include <algorithm>

#include "motion/curve/extrema.hpp"
#include "motion/curve/smoothing.hpp"
#include "motion/curve/statistics.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;

std::vector<double> curve_of(std::size_t samples, const std::function<double(double)>& value) {
    std::vector<double> curve;
    for (std::size_t i = 0; i < samples; ++i)
        curve.push_back(value(static_cast<double>(i)));
    return curve;
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
    const auto swing = [](double per_cycle) {
        return cyclicity(
            curve_of(200, [&](double t) { return std::sin(turn * per_cycle * t / 40); }), 40);
    };
    ASSERT_NEAR(swing(1), 1, 0.01);
    ASSERT_NEAR(swing(2), 0, 0.02);
    assert_true(swing(0.5) < 0.2);
    ASSERT_NEAR(cyclicity(curve_of(200, [](double t) { return t; }), 40), 0, 0.01);
    assert_true(cyclicity(std::vector<double>(200, 1.0), 40) == 0);
    assert_true(cyclicity(std::vector<double>(30, 1.0), 40) == 0); // too short
}

void correlation_knows_likes_and_opposites(void**) {
    const auto up = curve_of(50, [](double t) { return 3 + t; });
    const auto down = curve_of(70, [](double t) { return -2 * t; });
    ASSERT_NEAR(correlation(up, up), 1, 1e-12);
    ASSERT_NEAR(correlation(up, down), -1, 1e-12);
    assert_true(correlation(up, std::vector<double>(50, 1.0)) == 0);
    assert_true(correlation({}, {}) == 0);
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
        cmocka_unit_test(correlation_knows_likes_and_opposites),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
