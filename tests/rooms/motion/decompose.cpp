// SPDX-License-Identifier: BSD-3-Clause
// From samples to units: known borders, invariances, and clips without cycles.
#include "motion/testing.hpp"

#include <algorithm>
#include <numeric>

#include "motion/curve/smoothing.hpp"
#include "motion/decompose.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;
using stltsa::Progress;
using stltsa::Status;

Decomposition decomposed(const Matrix& samples, double fps, const DecomposeOptions& options = {}) {
    return decompose(samples.view(), fps, options, Progress{});
}

Status failure_of(const Matrix& samples, double fps, const DecomposeOptions& options = {}) {
    try {
        decomposed(samples, fps, options);
    } catch (const stltsa::Error& error) {
        assert_true(*error.what() != '\0');
        return error.status();
    }
    return Status::ok;
}

/// Every result is complete and consistent.
void check_shape(const Decomposition& d, std::int64_t samples) {
    assert_true(!d.units.empty());
    assert_true(d.units.front().begin == 0);
    assert_true(d.units.back().end == static_cast<double>(samples));
    for (std::size_t i = 1; i < d.units.size(); ++i)
        assert_true(d.units[i].begin == d.units[i - 1].end);
    assert_int_equal(d.coords.rows(), samples);
    assert_int_equal(d.loop.rows(), samples);
    assert_int_equal(d.loop.cols(), 2);
    assert_int_equal(d.curve.size(), samples);
    const bool cyclic = std::any_of(d.units.begin(), d.units.end(),
                                    [](const Unit& u) { return u.kind == UnitKind::cyclic; });
    assert_true(cyclic == d.reason.empty());
    assert_true(cyclic == (d.period > 0));
    assert_true(cyclic == !d.cycles.empty());
    assert_true(cyclic == (d.representative == 0 && d.best >= 0));
}

void finds_five_units(void**) {
    const Exercise exercise;
    for (const double fps : {15.0, 30.0, 120.0}) {
        const Decomposition d = decomposed(exercise.samples(fps), fps);
        check_shape(d, static_cast<std::int64_t>(d.curve.size()));
        assert_string_equal(d.reason.c_str(), "");
        assert_int_equal(d.units.size(), 5);
        ASSERT_NEAR(d.period / fps, exercise.period, 0.01 * exercise.period);
        ASSERT_NEAR(d.units[0].end / fps, exercise.stands, 0.12);
        ASSERT_NEAR(d.units[4].begin / fps, exercise.moves_until(), 0.12);
        assert_in_range(d.cycles.size(), 4, 6);
        for (const Cycle& cycle : d.cycles)
            ASSERT_NEAR((cycle.end - cycle.begin) / fps, exercise.period, 0.12);
        assert_true(d.cyclicity > 0.8 && d.lag_quality > 0.8);
        // 1.2 periods of the whole clip, whose end swings are slower than the rest.
        ASSERT_NEAR(static_cast<double>(d.parameters.neighbors), 1.2 * d.period, 0.06 * d.period);
    }
}

/// The curve is the coordinate smoothed by a Gaussian with a sigma of 0.06 cycles, which leaves
/// exp(-(2 pi 0.06)^2 / 2) of a swing, and so takes most of the noise away.
void the_curve_is_smoothed_by_a_share_of_the_cycle(void**) {
    const Matrix circle = sampled(600, 2, 60, [](double t, std::int64_t c) {
        return std::sin(turn * (t + 0.25 * static_cast<double>(c)));
    });
    const Decomposition d = decomposed(circle, 60);
    assert_in_range(d.coordinate, 1, d.coords.cols());
    double product = 0;
    double square = 0;
    for (std::int64_t i = 60; i < 540; ++i) {
        const double value = d.coords(i, d.coordinate - 1);
        product += value * d.curve[static_cast<std::size_t>(i)];
        square += value * value;
    }
    const double sigma = turn * 0.06;
    ASSERT_NEAR(product / square, std::exp(-sigma * sigma / 2), 0.01);
}

/// Starts and stops are at the same share of a cycle at any tempo.
void tempo_does_not_move_borders(void**) {
    const auto error = [](double period) {
        const Exercise exercise{period, period, 5, period / 2, period};
        const Decomposition d = decomposed(exercise.samples(60), 60);
        assert_int_equal(d.units.size(), 5);
        return std::pair{(d.units[0].end / 60 - exercise.stands) / period,
                         (d.units[4].begin / 60 - exercise.moves_until()) / period};
    };
    const auto [start, stop] = error(1);
    assert_true(std::abs(start) < 0.1 && std::abs(stop) < 0.1);
    for (const double period : {0.7, 1.4}) {
        const auto [other_start, other_stop] = error(period);
        ASSERT_NEAR(other_start, start, 0.015);
        ASSERT_NEAR(other_stop, stop, 0.015);
    }
}

/// Noise that moves the whole body, like noise on the root's rotation: its speed varies a lot.
void noise_does_not_move_borders(void**) {
    const Matrix clean = Exercise{}.samples(15);
    const auto expected = decomposed(clean, 15).units;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Matrix samples = clean;
        Matrix noise(samples.rows(), 2);
        add_noise(noise, 0.25, seed);
        for (std::int64_t i = 0; i < samples.rows(); ++i)
            for (std::int64_t c = 0; c < samples.cols(); ++c)
                samples(i, c) += noise(i, c % 2);
        const Decomposition d = decomposed(samples, 15);
        assert_int_equal(d.units.size(), 5);
        ASSERT_NEAR(d.units[0].end / 15, expected[0].end / 15, 0.2);
        ASSERT_NEAR(d.units[4].begin / 15, expected[4].begin / 15, 0.2);
    }
}

/// A clip that is cut at a turning point does not stand there.
void turning_points_are_not_rests(void**) {
    for (int start = 0; start < 20; ++start) {
        const Matrix squats = sampled(500, 8, 30, [&](double t, std::int64_t c) {
            return std::sin(turn * (t / 2 + start / 20.0)) * (0.5 + static_cast<double>(c) / 7);
        });
        for (const Unit& unit : decomposed(squats, 30).units)
            assert_true(unit.kind != UnitKind::preparing && unit.kind != UnitKind::wind_up);
    }
}

/// Two exercises with standing between them: cycles in the longer one, an action in the other, and
/// a warning.
void warns_about_other_motion(void**) {
    Exercise shorter;
    shorter.cycles = 2.5;
    for (const double period : {1.2, 0.7}) {
        shorter.period = period;
        const Matrix a = Exercise{}.samples(30);
        const Matrix b = shorter.samples(30);
        Matrix both(a.rows() + b.rows(), 10);
        std::copy_n(a.data(), a.rows() * 10, both.data());
        std::copy_n(b.data(), b.rows() * 10, both.row(a.rows()));
        DecomposeOptions options;
        options.first_s = 100;
        const Decomposition d = decomposed(both, 30, options);
        check_shape(d, both.rows());
        const auto last = std::find_if(d.units.rbegin(), d.units.rend(), [](const Unit& unit) {
            return unit.kind == UnitKind::action;
        });
        assert_true(last != d.units.rend());
        const double start = Exercise{}.seconds() + shorter.stands;
        ASSERT_NEAR(last->begin / 30, start, 0.2);
        ASSERT_NEAR(last->end / 30, Exercise{}.seconds() + shorter.moves_until(), 0.3);
        const auto said = stltsa::format_text("from {:.2f} s", 100 + last->begin / 30);
        assert_true(
            std::any_of(d.warnings.begin(), d.warnings.end(), [&](const stltsa::Warning& w) {
                return w.code == stltsa::WarningCode::separate_motion &&
                       w.text.find(said) != w.text.npos && w.begin_s == 100 + last->begin / 30 &&
                       w.end_s == 100 + last->end / 30;
            }));
        assert_true(d.cycles.size() >= 4 || !d.reason.empty());
    }
}

/// Long standing must not add a dimension to the curve.
void long_standing_changes_nothing(void**) {
    Exercise exercise;
    exercise.cycles = 3;
    exercise.stands = 15;
    exercise.rests = 10;
    Matrix samples = exercise.samples(30);
    Matrix sway(samples.rows(), samples.cols());
    add_noise(sway, 1, 9);
    sway = smooth(sway.view(), 12); // leaves 0.15 of it
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (std::int64_t c = 0; c < samples.cols(); ++c)
            samples(i, c) += sway(i, c);
    const Decomposition d = decomposed(samples, 30);
    check_shape(d, samples.rows());
    assert_int_equal(d.units.size(), 5);
    assert_in_range(d.cycles.size(), 2, 4);
    ASSERT_NEAR(d.units[0].end / 30, exercise.stands, 0.2);
}

void permuting_channels_changes_nothing(void**) {
    Matrix samples = Exercise{}.samples(30);
    add_noise(samples, 0.05, 5);
    Matrix permuted(samples.rows(), samples.cols());
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (std::int64_t c = 0; c < samples.cols(); ++c)
            permuted(i, c) = samples(i, (3 * c + 4) % 10);
    const Decomposition a = decomposed(samples, 30);
    const Decomposition b = decomposed(permuted, 30);
    assert_int_equal(a.units.size(), b.units.size());
    for (std::size_t i = 0; i < a.units.size(); ++i)
        ASSERT_NEAR(a.units[i].end, b.units[i].end, 1e-6);
}

void moving_and_scaling_changes_nothing(void**) {
    Matrix samples = Exercise{}.samples(30);
    add_noise(samples, 0.02, 8); // frames that differ only by rounding would become equal
    Matrix moved = samples;
    Matrix small = samples;
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (std::int64_t c = 0; c < samples.cols(); ++c) {
            moved(i, c) += 1024;
            small(i, c) *= 0x1p-30;
        }
    const Decomposition a = decomposed(samples, 30);
    for (const Matrix& other : {moved, small}) {
        const Decomposition b = decomposed(other, 30);
        assert_int_equal(a.units.size(), b.units.size());
        for (std::size_t i = 0; i < a.units.size(); ++i)
            ASSERT_NEAR(a.units[i].end, b.units[i].end, 1e-6);
    }
}

void threads_change_no_bit(void**) {
    Matrix samples = Exercise{}.samples(30);
    add_noise(samples, 0.1, 6);
    DecomposeOptions two;
    two.threads = 2;
    const Decomposition a = decomposed(samples, 30);
    const Decomposition b = decomposed(samples, 30, two);
    assert_true(a.period == b.period && a.curve == b.curve);
    for (std::size_t i = 0; i < a.units.size(); ++i)
        assert_true(a.units[i].end == b.units[i].end);
}

void decomposes_bare_features(void**) {
    Matrix circle = sampled(300, 10, 30, [](double t, std::int64_t c) {
        return std::sin(turn * t / 1.2 + static_cast<double>(c));
    });
    add_noise(circle, 0.1, 1);
    Decomposition d = decomposed(circle, 30);
    check_shape(d, 300);
    ASSERT_NEAR(d.period / 30, 1.2, 0.01);
    assert_in_range(d.cycles.size(), 7, 8);
    assert_true(d.units.front().kind == UnitKind::initial);

    // One channel spans one dimension: the loop stays flat.
    const Matrix sine = sampled(300, 1, 30, [](double t, std::int64_t) { return std::sin(5 * t); });
    d = decomposed(sine, 30);
    check_shape(d, 300);
    ASSERT_NEAR(d.period / 30, turn / 5, 0.01);
}

void says_why_there_is_no_cycle(void**) {
    Matrix noise(300, 10);
    add_noise(noise, 1, 2);
    Decomposition d = decomposed(noise, 30);
    check_shape(d, 300);
    assert_true(!d.reason.empty());

    const Matrix line = sampled(
        300, 10, 30, [](double t, std::int64_t c) { return t * std::cos(1.0 * double(c)); });
    d = decomposed(line, 30);
    check_shape(d, 300);
    assert_true(d.reason.starts_with("no period"));
    assert_int_equal(d.parameters.neighbors, 36);

    d = decomposed(Matrix(300, 4), 30);
    check_shape(d, 300);
    assert_true(d.reason.find("nothing moves") != d.reason.npos);

    Matrix step(300, 4);
    for (std::int64_t i = 150; i < 300; ++i)
        step(i, 2) = 1;
    check_shape(decomposed(step, 30), 300);
}

/// A single repetition whose second half is a different motion.
void claims_no_cycle_of_uneven_strides(void**) {
    // Strides of 0.8 s to 1.6 s, each with its own shape.
    Matrix samples(360, 10);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> even(0, 1);
    double phase = 0, seconds = 1;
    std::vector<double> shape(10);
    for (std::int64_t i = 0; i < samples.rows(); ++i) {
        if (i == 0 || phase >= 1) {
            phase = 0;
            seconds = 0.8 + 0.8 * even(random);
            std::generate(shape.begin(), shape.end(), [&] { return turn * even(random); });
        }
        phase += 1 / (30 * seconds);
        for (std::int64_t c = 0; c < 10; ++c)
            samples(i, c) = std::sin(turn * phase) *
                            std::cos(shape[static_cast<std::size_t>(c)] + turn * phase);
    }
    const Decomposition d = decomposed(samples, 30);
    check_shape(d, samples.rows());
    assert_true(d.cycles.empty());
}

void short_clips_get_an_answer(void**) {
    const Matrix motion =
        sampled(40, 10, 30, [](double t, std::int64_t c) { return cyclic_pose(t, c); });
    for (std::int64_t samples = 1; samples < 40; ++samples) {
        Matrix cut(samples, 10);
        std::copy_n(motion.data(), samples * 10, cut.data());
        if (samples < 4)
            assert_true(failure_of(cut, 30) == Status::too_few_frames);
        else
            check_shape(decomposed(cut, 30), samples);
    }
}

void takes_the_callers_parameters(void**) {
    const Matrix samples = Exercise{}.samples(30);
    DecomposeOptions options;
    options.neighbors = 20;
    options.window = 30;
    for (const int dimension : {1, 2, 3, 4}) {
        options.dimension = dimension;
        const Decomposition d = decomposed(samples, 30, options);
        check_shape(d, samples.rows());
        assert_int_equal(d.parameters.neighbors, 20);
        assert_int_equal(d.parameters.window, 30);
        assert_int_equal(d.parameters.dimension, dimension);
        assert_int_equal(d.coords.cols(), dimension);
    }
    options = {};
    options.longest_period = 1;
    assert_true(decomposed(samples, 30, options).period == 0);
    options = {};
    options.neighbors = 100000;
    assert_true(failure_of(samples, 30, options) == Status::too_few_frames);
}

void refuses_invalid_samples(void**) {
    Matrix samples = Exercise{}.samples(30);
    assert_true(failure_of(samples, 0) == Status::argument);
    assert_true(failure_of(samples, std::nan("")) == Status::argument);
    samples(17, 3) = std::nan("");
    assert_true(failure_of(samples, 30) == Status::not_finite);
    assert_true(failure_of(Matrix(0, 3), 30) == Status::shape);
    assert_true(failure_of(Matrix(30, 0), 30) == Status::shape);
}

void can_be_cancelled(void**) {
    const auto stop = [](void*, std::int32_t, double) { return std::int32_t{1}; };
    const Matrix samples = Exercise{}.samples(30);
    Status status = Status::ok;
    try {
        decompose(samples.view(), 30, {}, Progress(stop, nullptr));
    } catch (const stltsa::Error& error) {
        status = error.status();
    }
    assert_true(status == Status::cancelled);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(finds_five_units),
        cmocka_unit_test(the_curve_is_smoothed_by_a_share_of_the_cycle),
        cmocka_unit_test(tempo_does_not_move_borders),
        cmocka_unit_test(noise_does_not_move_borders),
        cmocka_unit_test(turning_points_are_not_rests),
        cmocka_unit_test(warns_about_other_motion),
        cmocka_unit_test(long_standing_changes_nothing),
        cmocka_unit_test(permuting_channels_changes_nothing),
        cmocka_unit_test(moving_and_scaling_changes_nothing),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(decomposes_bare_features),
        cmocka_unit_test(says_why_there_is_no_cycle),
        cmocka_unit_test(claims_no_cycle_of_uneven_strides),
        cmocka_unit_test(short_clips_get_an_answer),
        cmocka_unit_test(takes_the_callers_parameters),
        cmocka_unit_test(refuses_invalid_samples),
        cmocka_unit_test(can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
