// SPDX-License-Identifier: BSD-3-Clause
// Where behaviors change, and which are one.
#include "recordings.hpp"

#include <functional>

#include "motion/behaviors/change_points.hpp"

namespace {

using namespace motion_testing;

constexpr double seconds = 30;

/// A recording of which row i is row_of(t), t in seconds, with a little noise.
Matrix recorded(double length, const std::function<std::vector<double>(double)>& row_of) {
    Random random(1);
    const auto rows = static_cast<std::int64_t>(length * fps);
    Matrix x(rows, static_cast<std::int64_t>(row_of(0).size()));
    for (std::int64_t i = 0; i < rows; ++i) {
        const std::vector<double> row = row_of(static_cast<double>(i) / fps);
        for (std::int64_t c = 0; c < x.cols(); ++c)
            x(i, c) = row[static_cast<std::size_t>(c)] + 0.003 * random.symmetric();
    }
    return x;
}

double turn(double t, double period) {
    return 2 * std::numbers::pi * t / period;
}

/// The borders between segments in seconds.
std::vector<double> borders(const Recording& found) {
    std::vector<double> at;
    for (std::size_t i = 1; i < found.segments.size(); ++i)
        at.push_back(found.segments[i].begin / fps);
    return at;
}

/// A wave with slopes and flat tops.
double trapezoid(double angle) {
    return std::clamp(1.5 * std::asin(std::sin(angle)), -1.0, 1.0);
}

void one_column_is_divided_by_its_shape(void**) {
    const auto first = [](double t) { return std::sin(turn(t, 1)); };
    const auto other = [](double t) {
        return 0.6 * trapezoid(turn(t, 1)) + 0.6 * std::sin(turn(t, 0.5));
    };
    const Matrix one = recorded(2 * seconds, [&](double t) { return std::vector{first(t)}; });
    assert_true(borders(answer(one)).empty());
    const Matrix two = recorded(
        2 * seconds, [&](double t) { return std::vector{t < seconds ? first(t) : other(t)}; });
    const std::vector<double> at = borders(answer(two));
    assert_int_equal(at.size(), 1);
    ASSERT_NEAR(at[0], seconds, 2);
    const Recording again = answer(recorded(3 * seconds, [&](double t) {
        return std::vector{t < seconds || t > 2 * seconds ? first(t) : other(t)};
    }));
    assert_int_equal(again.segments.size(), 3);
    assert_int_equal(again.segments[1].label, 1);
    assert_int_equal(again.segments[2].label, 0);
}

void noise_does_not_divide_one_column(void**) {
    for (const double period : {0.5, 1.0, 2.5})
        for (const double noise : {0.1, 0.3}) {
            Random random(2);
            Matrix x =
                recorded(100, [&](double t) { return std::vector{std::sin(turn(t, period))}; });
            for (std::int64_t i = 0; i < x.rows(); ++i)
                x(i, 0) += noise * random.symmetric();
            const KernelFeatures features(make_signal(x.view(), fps, 0, 0));
            assert_true(change_points(features, border_price(features)).empty());
        }
}

/// What repeats with pauses is not merged into one motion.
void one_column_keeps_its_repetitions(void**) {
    const Matrix x =
        recorded(100, [](double t) { return std::vector{std::fmod(t, 4) < 2 ? 0. : 1.}; });
    const Recording found = answer(x);
    assert_true(found.repetitions.size() >= 20);
}

void quiet_columns_count(void**) {
    const Matrix x = recorded(2 * seconds, [](double t) {
        const double quiet = t < seconds ? 0 : 0.25 * std::sin(turn(t, 2));
        return std::vector{std::sin(turn(t, 1)), std::cos(turn(t, 1)), std::sin(turn(t, 0.5)),
                           quiet};
    });
    const KernelFeatures features(make_signal(x.view(), fps, 0, 0));
    const auto moments = change_points(features, border_price(features));
    assert_int_equal(moments.size(), 1);
    ASSERT_NEAR(static_cast<double>(moments[0] * features.step()) / fps, seconds, 0.5);
}

void rotations_beside_the_samples_divide(void**) {
    const Matrix x = recorded(2 * seconds, [](double t) {
        return std::vector{std::sin(turn(t, 1)), std::cos(turn(t, 1)), std::sin(turn(t, 0.5))};
    });
    const Signal signal = make_signal(x.view(), fps, 0, 0);
    const Matrix rotations = recorded(2 * seconds, [](double t) {
        return std::vector{t < seconds ? 0 : 50 * std::sin(turn(t, 2)), 50 * std::sin(turn(t, 1))};
    });
    const KernelFeatures alone(signal), both(signal, rotations);
    assert_true(change_points(alone, border_price(alone)).empty());
    const auto moments = change_points(both, border_price(both));
    assert_int_equal(moments.size(), 1);
    ASSERT_NEAR(static_cast<double>(moments[0] * both.step()) / fps, seconds, 0.5);
}

/// Takes of two motions, with rests: sizes and tempos differ, the letters do not.
void labels_ignore_size_and_tempo(void**) {
    const double starts[] = {0, 10, 20, 30, 40, 50};
    const double sizes[] = {1, 1, 0.7, 0.7, 1.3, 0.5};
    const double periods[] = {1, 1.2, 1.15, 1.05, 0.95, 1.3};
    const Matrix x = recorded(60, [&](double t) {
        const auto take =
            static_cast<std::size_t>(std::ranges::upper_bound(starts, t) - starts - 1);
        std::vector<double> row(8);
        const double inside = t - starts[take];
        if (inside < 1 || inside > 9)
            return row;
        const std::size_t from = 4 * (take % 2);
        const double angle = turn(inside - 1, periods[take]);
        row[from] = sizes[take] * (1 - std::cos(angle));
        row[from + 1] = sizes[take] * std::sin(angle);
        row[from + 2] = sizes[take] * 0.4 * std::sin(2 * angle);
        return row;
    });
    const Recording found = answer(x);
    std::vector<int> labels;
    for (const Segment& segment : found.segments)
        if (segment.kind != SegmentKind::rest)
            labels.push_back(segment.label);
    assert_true((labels == std::vector<int>{0, 1, 0, 1, 0, 1}));
    assert_int_equal(found.label_likeness.rows(), 2);
    assert_true(found.label_likeness(0, 0) > 0.65);
    assert_true(found.label_likeness(0, 1) < 0.4);
    assert_true(found.label_likeness(0, 1) == found.label_likeness(1, 0));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(one_column_is_divided_by_its_shape),
        cmocka_unit_test(noise_does_not_divide_one_column),
        cmocka_unit_test(one_column_keeps_its_repetitions),
        cmocka_unit_test(quiet_columns_count),
        cmocka_unit_test(rotations_beside_the_samples_divide),
        cmocka_unit_test(labels_ignore_size_and_tempo),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
