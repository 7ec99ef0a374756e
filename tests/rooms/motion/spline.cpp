// SPDX-License-Identifier: BSD-3-Clause
// Compares the penalized spline with the dense solution of the same least squares, and tests its
// limits.
#include "motion/testing.hpp"

#include <algorithm>
#include <limits>

#include "motion/curve/spline.hpp"
#include "motion/curve/spline_system.hpp"
#include "motion/curve/statistics.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;
using Values = std::vector<double>;

Values noisy_wave(std::size_t rows, double noise, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Values values;
    for (std::size_t i = 0; i < rows; ++i)
        values.push_back(std::sin(turn * static_cast<double>(i) / 33) + noise * normal(random));
    return values;
}

double largest_difference(const Values& a, const Values& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

double rms_difference(const Values& a, const Values& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(squares / static_cast<double>(a.size()));
}

/// Cox and de Boor's recursion, independent of the library's formulas.
double b_spline(int degree, double first_knot, double x) {
    if (degree == 0)
        return x >= first_knot && x < first_knot + 1 ? 1 : 0;
    return (x - first_knot) / degree * b_spline(degree - 1, first_knot, x) +
           (first_knot + degree + 1 - x) / degree * b_spline(degree - 1, first_knot + 1, x);
}

/// The smoother matrix by Gauss-Jordan elimination of the normal equations.
Matrix dense_smoother(std::int64_t rows, double step, std::int64_t coefficients,
                      const Values& weights, double lambda) {
    Matrix b(rows, coefficients);
    for (std::int64_t i = 0; i < rows; ++i)
        for (std::int64_t j = 0; j < coefficients; ++j) {
            // The last row ends the last interval; it does not start another one.
            const double x = std::min(static_cast<double>(i) / step,
                                      static_cast<double>(coefficients - 3) - 1e-14);
            b(i, j) = b_spline(3, static_cast<double>(j) - 3, x);
        }
    Matrix left(coefficients, coefficients);
    Matrix right(coefficients, rows); // becomes the inverse times B^T W
    for (std::int64_t j = 0; j < coefficients; ++j)
        for (std::int64_t i = 0; i < rows; ++i) {
            right(j, i) = b(i, j) * weights[static_cast<std::size_t>(i)];
            for (std::int64_t l = 0; l < coefficients; ++l)
                left(j, l) += right(j, i) * b(i, l);
        }
    const double second[] = {1, -2, 1};
    for (std::int64_t r = 0; r + 2 < coefficients; ++r)
        for (std::int64_t p = 0; p < 3; ++p)
            for (std::int64_t q = 0; q < 3; ++q)
                left(r + p, r + q) += lambda * second[p] * second[q];
    for (std::int64_t j = 0; j < coefficients; ++j) {
        const double pivot = left(j, j);
        for (std::int64_t c = 0; c < coefficients; ++c)
            left(j, c) /= pivot;
        for (std::int64_t c = 0; c < rows; ++c)
            right(j, c) /= pivot;
        for (std::int64_t r = 0; r < coefficients; ++r) {
            const double part = r == j ? 0 : left(r, j);
            for (std::int64_t c = 0; c < coefficients; ++c)
                left(r, c) -= part * left(j, c);
            for (std::int64_t c = 0; c < rows; ++c)
                right(r, c) -= part * right(j, c);
        }
    }
    Matrix smoother(rows, rows);
    for (std::int64_t i = 0; i < rows; ++i)
        for (std::int64_t j = 0; j < coefficients; ++j)
            for (std::int64_t c = 0; c < rows; ++c)
                smoother(i, c) += b(i, j) * right(j, c);
    return smoother;
}

void same_as_the_dense_solution(void**) {
    struct Case {
        std::int64_t rows;
        double step;
    };
    for (const Case c : {Case{8, 4}, {8, 100}, {30, 3.3}, {41, 4}, {57, 1}, {60, 11}}) {
        const Values values = noisy_wave(static_cast<std::size_t>(c.rows), 0.3);
        for (const bool weighted : {false, true}) {
            Values weights(values.size(), 1.0);
            for (std::size_t i = 0; weighted && i < weights.size(); i += 3)
                weights[i] = i % 2 == 0 ? 0.0 : 0.4;
            SplineSystem system(c.rows, c.step);
            system.set_data(values, weights);
            for (const double lambda : {1e-3, 0.1, 1.0, 100.0, 1e5}) {
                const SplineSystem::Fit fit = system.fit(lambda);
                const Matrix smoother = dense_smoother(c.rows, system.knot_step(),
                                                       system.coefficients(), weights, lambda);
                Values expected(values.size());
                double trace = 0;
                for (std::int64_t i = 0; i < c.rows; ++i) {
                    trace += smoother(i, i);
                    for (std::int64_t j = 0; j < c.rows; ++j)
                        expected[static_cast<std::size_t>(i)] +=
                            smoother(i, j) * values[static_cast<std::size_t>(j)];
                }
                ASSERT_NEAR(largest_difference(fit.curve, expected), 0, 1e-8);
                ASSERT_NEAR(fit.degrees_of_freedom, trace, 1e-7);
            }
        }
    }
}

void knots_lie_on_both_ends(void**) {
    const SplineSystem system(101, 7);
    ASSERT_NEAR(system.knot_step() * static_cast<double>(system.coefficients() - 3), 100, 1e-12);
    assert_int_equal(SplineSystem(10, 1e9).coefficients(), 4);
    assert_int_equal(SplineSystem(10, 0.01).coefficients(), 12);
}

void degrees_of_freedom_go_from_all_coefficients_to_a_line(void**) {
    const Values values = noisy_wave(200, 0.1);
    const Values weights(values.size(), 1.0);
    SplineSystem system(200, 5);
    system.set_data(values, weights);
    double before = static_cast<double>(system.coefficients()) + 1e-9;
    for (double lambda = 1e-6; lambda < 1e9; lambda *= 10) {
        const double degrees_of_freedom = system.fit(lambda).degrees_of_freedom;
        assert_true(degrees_of_freedom < before);
        before = degrees_of_freedom;
    }
    ASSERT_NEAR(system.fit(1e-9).degrees_of_freedom, static_cast<double>(system.coefficients()),
                1e-4);
    ASSERT_NEAR(before, 2, 1e-2);
}

void lines_and_constants_are_reproduced(void**) {
    for (const std::size_t rows : {8u, 100u, 5000u})
        for (const bool robust : {false, true}) {
            Values line;
            for (std::size_t i = 0; i < rows; ++i)
                line.push_back(1000.7 - 0.3 * static_cast<double>(i));
            const Spline of_line = fit_spline(line, {4, robust});
            ASSERT_NEAR(largest_difference(of_line.curve, line), 0, 1e-11);
            ASSERT_NEAR(of_line.degrees_of_freedom, 2, 0);
            const Values level(rows, 0.1);
            assert_true(fit_spline(level, {4, robust}).curve == level);
        }
}

/// A smooth, noiseless coordinate is followed: the penalty vanishes.
void smooth_values_are_followed(void**) {
    const Values wave = noisy_wave(200, 0);
    const Spline spline = fit_spline(wave, {3.3, false});
    ASSERT_NEAR(largest_difference(spline.curve, wave), 0, 2e-3);
}

void pure_noise_becomes_nearly_a_line(void**) {
    Values noise = noisy_wave(1000, 1);
    const Values wave = noisy_wave(1000, 0);
    for (std::size_t i = 0; i < noise.size(); ++i)
        noise[i] -= wave[i];
    assert_true(fit_spline(noise, {4, false}).degrees_of_freedom < 30);
}

/// The chosen lambda is almost as good as the best one, which is known here.
void cross_validation_is_near_the_best(void**) {
    const Values truth = noisy_wave(300, 0);
    for (const double noise : {0.03, 0.1, 0.3})
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const Values values = noisy_wave(300, noise, seed);
            SplineSystem system(300, 3.3);
            system.set_data(values, Values(300, 1.0));
            double best = 1;
            for (double lambda = 1e-4; lambda < 1e4; lambda *= 1.5)
                best = std::min(best, rms_difference(system.fit(lambda).curve, truth));
            const Spline spline = fit_spline(values, {3.3, false});
            assert_true(rms_difference(spline.curve, truth) < 1.25 * best);
            assert_true(best < 0.6 * noise);
        }
}

void spikes_do_not_distort_the_robust_curve(void**) {
    const Values truth = noisy_wave(300, 0);
    Values values = noisy_wave(300, 0.03);
    const double without = rms_difference(fit_spline(values, {3.3, true}).curve, truth);
    for (std::size_t i = 11; i < values.size(); i += 37)
        values[i] += i % 2 == 0 ? 3 : -3;
    assert_true(rms_difference(fit_spline(values, {3.3, true}).curve, truth) < 1.3 * without);
    assert_true(rms_difference(fit_spline(values, {3.3, false}).curve, truth) > 5 * without);

    Values level(100, 5.0);
    level[50] = 6;
    const Spline spline = fit_spline(level, {4, true});
    level[50] = 5;
    ASSERT_NEAR(largest_difference(spline.curve, level), 0, 1e-6);
}

/// Large spikes hide small ones until they have lost their weight.
void spikes_of_all_sizes_do_not_distort_the_robust_curve(void**) {
    const Values truth = noisy_wave(300, 0);
    Values values = noisy_wave(300, 0.03);
    const double without = rms_difference(fit_spline(values, {3.3, true}).curve, truth);
    const double heights[] = {30, 0.3, 10, -0.4, 3, 0.5, -1};
    for (std::size_t i = 4, spike = 0; i < values.size(); i += 9, ++spike)
        values[i] += heights[spike % std::size(heights)];
    assert_true(rms_difference(fit_spline(values, {3.3, true}).curve, truth) < 1.5 * without);
}

/// Standing is quieter than walking, but walking is not noise.
void a_movement_after_long_standing_is_not_a_spike(void**) {
    Values values = noisy_wave(1000, 0.05, 7);
    const Values wave = noisy_wave(1000, 0);
    Values truth(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool walks = i >= 700;
        truth[i] = walks ? std::sin(turn * static_cast<double>(i - 700) / 33) : 0;
        values[i] = walks ? truth[i] + values[i] - wave[i] : 0.001 * (values[i] - wave[i]);
    }
    const Spline spline = fit_spline(values, {3.3, true});
    double worst = 0;
    for (std::size_t i = 710; i < 1000; ++i)
        worst = std::max(worst, std::abs(spline.curve[i] - truth[i]));
    assert_true(worst < 0.15);
}

void scale_changes_no_digit(void**) {
    const Values values = noisy_wave(100, 0.1);
    for (const bool robust : {false, true})
        for (const double scale : {0x1p-960, 0x1p-30, 0x1p+960}) {
            Values scaled = values;
            Values expected = fit_spline(values, {4, robust}).curve;
            for (std::size_t i = 0; i < values.size(); ++i) {
                scaled[i] *= scale;
                expected[i] *= scale;
            }
            assert_true(fit_spline(scaled, {4, robust}).curve == expected);
        }
}

void always_finite(void**) {
    constexpr double most = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    Values alternating;
    for (int i = 0; i < 50; ++i)
        alternating.push_back(i % 2 == 0 ? most : -most);
    Values still_then_jump(60, 0.0);
    still_then_jump.back() = 1;
    Values half(40, 0.0);
    std::fill(half.begin() + 20, half.end(), 1.0);
    for (const Values& values :
         {alternating, still_then_jump, half, Values(8, 0.0), Values{0, 0, 0, 1, 0, 0, 0, 0},
          Values{least, 0, 0, -least, 0, 0, least, 0}, Values{1, 2}, Values(9, most)})
        for (const bool robust : {false, true})
            for (const double step : {0.5, 4.0, 1e6}) {
                const Spline spline = fit_spline(values, {step, robust});
                for (const double value : spline.curve)
                    assert_true(std::isfinite(value));
                assert_true(std::isfinite(spline.degrees_of_freedom));
            }
}

void binary_exponents_and_deviations(void**) {
    assert_int_equal(binary_exponent(Values{0.75, -0.5}), 0);
    assert_int_equal(binary_exponent(Values{1}), 1);
    assert_int_equal(binary_exponent(Values{-1000, 3}), 10);
    assert_int_equal(binary_exponent(Values{0, 0}), 0);
    ASSERT_NEAR(robust_deviation(Values{-1, 2, -3, 4, 1000}), 3 * 1.4826, 1e-12);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(same_as_the_dense_solution),
        cmocka_unit_test(knots_lie_on_both_ends),
        cmocka_unit_test(degrees_of_freedom_go_from_all_coefficients_to_a_line),
        cmocka_unit_test(lines_and_constants_are_reproduced),
        cmocka_unit_test(smooth_values_are_followed),
        cmocka_unit_test(pure_noise_becomes_nearly_a_line),
        cmocka_unit_test(cross_validation_is_near_the_best),
        cmocka_unit_test(spikes_do_not_distort_the_robust_curve),
        cmocka_unit_test(spikes_of_all_sizes_do_not_distort_the_robust_curve),
        cmocka_unit_test(a_movement_after_long_standing_is_not_a_spike),
        cmocka_unit_test(scale_changes_no_digit),
        cmocka_unit_test(always_finite),
        cmocka_unit_test(binary_exponents_and_deviations),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
