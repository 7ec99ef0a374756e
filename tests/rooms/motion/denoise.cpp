// SPDX-License-Identifier: BSD-3-Clause
// Checks equation (1) of the paper point by point against the fitted curve.
#include "motion/testing.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "motion/curve/denoise.hpp"
#include "motion/curve/spline.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;
using stltsa::Status;

Matrix noisy_columns(std::int64_t rows) {
    Matrix coords = sampled(rows, 2, 30, [](double t, std::int64_t c) {
        return (c == 0 ? 0.1 : 40) * std::sin(turn * t / 1.1 + static_cast<double>(c));
    });
    Matrix noise(rows, 2);
    add_noise(noise, 1, 3);
    for (std::int64_t i = 0; i < rows; ++i) {
        coords(i, 0) += 0.01 * noise(i, 0);
        coords(i, 1) += 4 * noise(i, 1);
    }
    return coords;
}

Denoised denoised(const Matrix& coords, const std::vector<std::int64_t>& lengths,
                  const DenoiseOptions& options = {}) {
    return denoise(coords.view(), lengths, options);
}

/// Checks equation (1), as in the paper, for one column.
void check_equation(const Matrix& coords, const Denoised& found, std::int64_t c, double gamma) {
    const DenoisedColumn& column = found.columns[static_cast<std::size_t>(c)];
    double sum = 0;
    std::int64_t count = 0;
    for (std::int64_t i = 0; i < coords.rows(); ++i)
        if (const double d = std::abs(found.curve(i, c) - coords(i, c)); d > gamma) {
            sum += d;
            ++count;
        }
    assert_int_equal(column.moved, count);
    const double shift = count > 0 ? sum / static_cast<double>(count) : 0;
    ASSERT_NEAR(column.shift, shift, 1e-12 * shift);
    for (std::int64_t i = 0; i < coords.rows(); ++i) {
        const double y = coords(i, c);
        const double f = found.curve(i, c);
        const double d = std::abs(f - y);
        double expected = y;
        if (d > gamma)
            expected = d <= shift ? f : (y >= f ? y - shift : y + shift);
        ASSERT_NEAR(found.cleaned(i, c), expected, 1e-12 * std::abs(expected));
        ASSERT_NEAR(found.moves(i, c), expected - y, 1e-12 * std::abs(y));
        if (d <= gamma) { // to the bit
            assert_true(found.cleaned(i, c) == y);
            assert_true(found.moves(i, c) == 0);
        }
        assert_true((found.cleaned(i, c) - f) * (y - f) >= 0); // not across the curve
    }
}

void moves_points_by_equation_1(void**) {
    const Matrix coords = noisy_columns(200);
    const Denoised found = denoised(coords, {200});
    for (std::int64_t c = 0; c < 2; ++c) {
        const DenoisedColumn& column = found.columns[static_cast<std::size_t>(c)];
        assert_true(column.gamma == column.noise);
        assert_true(column.moved > 20 && column.moved < 120);
        check_equation(coords, found, c, column.gamma);
    }
    ASSERT_NEAR(found.columns[0].noise, 0.01, 0.003);
    ASSERT_NEAR(found.columns[1].noise, 4, 1.2);
}

void gamma_can_be_given(void**) {
    const Matrix coords = noisy_columns(200);
    for (const double gamma : {0.0, 0.015, 1e6}) {
        const Denoised found = denoised(coords, {200}, {gamma, 4, true});
        assert_true(found.columns[0].gamma == gamma);
        check_equation(coords, found, 0, gamma);
    }
    const Denoised untouched = denoised(coords, {200}, {1e6, 4, true});
    assert_int_equal(untouched.columns[1].moved, 0);
    assert_true(untouched.columns[1].shift == 0);
}

/// Three points are outliers of a line: their distances are 0.5, 1 and 1.5 times the mean.
void moves_a_few_points_by_hand(void**) {
    Matrix coords(60, 1);
    for (std::int64_t i = 0; i < 60; ++i)
        coords(i, 0) = 2;
    coords(15, 0) = 2.5;
    coords(30, 0) = 1;
    coords(45, 0) = 3.5;
    const Denoised found = denoised(coords, {60}, {0.25, 4, true});
    assert_int_equal(found.columns[0].moved, 3);
    ASSERT_NEAR(found.columns[0].shift, 1, 1e-6);
    ASSERT_NEAR(found.cleaned(15, 0), 2, 1e-6); // would cross
    ASSERT_NEAR(found.cleaned(30, 0), 2, 1e-6);
    ASSERT_NEAR(found.cleaned(45, 0), 2.5, 1e-6);
    assert_true(found.cleaned(0, 0) == 2);
}

void nothing_is_noisy_without_noise(void**) {
    Matrix coords(50, 2);
    for (std::int64_t i = 0; i < 50; ++i) {
        coords(i, 0) = 0.1;
        coords(i, 1) = 0.1 + 0.7 * static_cast<double>(i);
    }
    const Denoised found = denoised(coords, {50});
    for (std::int64_t c = 0; c < 2; ++c) {
        assert_int_equal(found.columns[static_cast<std::size_t>(c)].moved, 0);
        for (std::int64_t i = 0; i < 50; ++i)
            assert_true(found.cleaned(i, c) == coords(i, c));
    }
}

/// Two clips, the second far away: no curve connects them.
void each_clip_has_its_own_curve(void**) {
    Matrix coords = noisy_columns(160);
    for (std::int64_t i = 100; i < 160; ++i)
        coords(i, 0) += 1000;
    const Denoised found = denoised(coords, {100, 60});
    for (std::int64_t i = 0; i < 160; ++i)
        assert_true(std::abs(found.curve(i, 0) - coords(i, 0)) < 0.1);
    const std::vector<double> first = [&] {
        std::vector<double> column;
        for (std::int64_t i = 0; i < 100; ++i)
            column.push_back(coords(i, 0));
        return column;
    }();
    const Spline alone = fit_spline(first, {4, true});
    for (std::int64_t i = 0; i < 100; ++i)
        ASSERT_NEAR(found.curve(i, 0), alone.curve[static_cast<std::size_t>(i)], 1e-9);
    assert_true(found.columns[0].degrees_of_freedom > alone.degrees_of_freedom);
}

/// Standing, a movement, standing: a sum of sines would ring.
void standing_survives(void**) {
    const Exercise exercise;
    Matrix coords = exercise.samples(30);
    Matrix truth = coords;
    add_noise(coords, 0.05, 11);
    const Denoised found = denoised(coords, {coords.rows()}, {-1, knot_step_for(36), true});
    for (std::int64_t c = 0; c < 2; ++c)
        for (std::int64_t i = 0; i < coords.rows(); ++i)
            assert_true(std::abs(found.curve(i, c) - truth(i, c)) < 0.2);
    for (std::int64_t i = 0; i < 25; ++i) // well within the first standing
        assert_true(std::abs(found.curve(i, 0)) < 0.06);
}

template <class Call>
void refuses(Status status, Call call) {
    try {
        call();
    } catch (const stltsa::Error& error) {
        assert_int_equal(static_cast<int>(error.status()), static_cast<int>(status));
        return;
    }
    print_error("nothing was refused\n");
    _fail(__FILE__, __LINE__);
}

void refuses_invalid_input(void**) {
    refuses(Status::too_few_frames, [] { denoised(noisy_columns(7), {7}); });
    refuses(Status::too_few_frames, [] { denoised(noisy_columns(20), {13, 7}); });
    refuses(Status::shape, [] { denoised(noisy_columns(20), {8, 8}); });
    Matrix gap = noisy_columns(20);
    gap(3, 1) = std::nan("");
    refuses(Status::not_finite, [&] { denoised(gap, {20}); });
    denoised(noisy_columns(8), {8});
}

void steps_follow_the_period(void**) {
    ASSERT_NEAR(knot_step_for(33), 3.3, 1e-12);
    ASSERT_NEAR(knot_step_for(0), 2, 0);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(moves_points_by_equation_1),
        cmocka_unit_test(gamma_can_be_given),
        cmocka_unit_test(moves_a_few_points_by_hand),
        cmocka_unit_test(nothing_is_noisy_without_noise),
        cmocka_unit_test(each_clip_has_its_own_curve),
        cmocka_unit_test(standing_survives),
        cmocka_unit_test(refuses_invalid_input),
        cmocka_unit_test(steps_follow_the_period),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
