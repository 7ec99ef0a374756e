// SPDX-License-Identifier: BSD-3-Clause
// Points as combinations of rows, and the reach of a model.
#include "ltsa/mapping/mapping.hpp"
#include "linalg/simd.hpp"
#include "motion/testing.hpp"

namespace {

using namespace motion_testing;
using stltsa::ltsa::MapParameters;
using stltsa::ltsa::Mapping;
using stltsa::ltsa::Mode;
using stltsa::ltsa::Model;
using stltsa::ltsa::no_hint;
using stltsa::ltsa::Placement;

/// Frames with given instead of fitted coordinates; one component per clip.
struct Given {
    Matrix frames;
    Model model;

    Given(Matrix x, Matrix y, std::vector<std::int64_t> lengths, Mode mode = Mode::temporal)
        : frames(std::move(x)) {
        model.coords = std::move(y);
        model.lengths = std::move(lengths);
        model.parameters.dimension = static_cast<int>(model.coords.cols());
        model.parameters.mode = mode;
        model.components.resize(model.lengths.size());
        for (std::size_t clip = 0; clip < model.lengths.size(); ++clip)
            model.component_of.insert(model.component_of.end(),
                                      static_cast<std::size_t>(model.lengths[clip]),
                                      static_cast<std::int64_t>(clip));
    }
    Mapping mapping(double period = 0) const { return {frames.view(), model, period}; }
};

/// Rows on a line in three dimensions; row i has coordinate 2 i.
Given line(std::int64_t rows, std::vector<std::int64_t> lengths) {
    Matrix x(rows, 3);
    Matrix y(rows, 1);
    for (std::int64_t i = 0; i < rows; ++i) {
        x(i, 0) = static_cast<double>(i);
        x(i, 1) = 5 - 2 * static_cast<double>(i);
        x(i, 2) = 7;
        y(i, 0) = 2 * static_cast<double>(i);
    }
    return {std::move(x), std::move(y), std::move(lengths)};
}

double coordinate(const Given& given, const Placement& placement) {
    double y = 0;
    placement.apply(given.model.coords.view(), &y);
    return y;
}

void lines_are_extrapolated(void**) {
    const Given given = line(30, {30});
    const Mapping mapping = given.mapping();
    for (const double at : {-3.0, 0.25, 11.5, 28.9, 35.0}) {
        const double frame[] = {at, 5 - 2 * at, 7};
        const Placement placement = mapping.find_frame(frame, no_hint, {});
        ASSERT_NEAR(coordinate(given, placement), 2 * at, 1e-12);
        // The rows are sqrt(5) apart, the unit of distances.
        const double nearest = std::min(std::max(std::round(at), 0.0), 29.0);
        ASSERT_NEAR(placement.distance, std::abs(at - nearest), 1e-12);
        // Constant columns carry no information.
        const double beside[] = {at, 5 - 2 * at, 9};
        ASSERT_NEAR(coordinate(given, mapping.find_frame(beside, no_hint, {})), 2 * at, 1e-12);
    }
    ASSERT_NEAR(mapping.reach(), std::sqrt(5.0), 1e-12);
}

void weights_fade_out_with_the_blend(void**) {
    // Frames on a circle with unrelated coordinates and local maps of one row: the result is the
    // blend alone.
    Matrix x(5, 2);
    Matrix y(5, 1);
    for (std::int64_t i = 0; i < 5; ++i) {
        x(i, 0) = std::cos(turn * static_cast<double>(i) / 5);
        x(i, 1) = std::sin(turn * static_cast<double>(i) / 5);
        y(i, 0) = i == 2 ? 1 : 0;
    }
    const Given given(std::move(x), std::move(y), {5}, Mode::spatial);
    const Mapping mapping = given.mapping();
    const MapParameters p{1, 2, 1};
    const auto value = [&](double a, double b) {
        const double frame[] = {a, b};
        return coordinate(given, mapping.find_frame(frame, no_hint, p));
    };
    const double* row = given.frames.row(2);
    ASSERT_NEAR(value(row[0], row[1]), 1, 0);
    ASSERT_NEAR(value(row[0] + 1e-9, row[1]), 1, 1e-8);
    // Rows 2 and 3 lie symmetrically about the axis, and the others are farther.
    ASSERT_NEAR(value(-0.7, 0), 0.5, 1e-12);
    // Rows 1 and 3 are symmetric about row 2: one leaves the blend as the other enters.
    const double before = value(0.5 * row[0] + 1e-9, 0.5 * row[1]);
    const double after = value(0.5 * row[0] - 1e-9, 0.5 * row[1]);
    ASSERT_NEAR(before, 1, 1e-7);
    ASSERT_NEAR(after, 1, 1e-7);
}

/// A curve that crosses itself halfway between two rows of one branch, near a row of the other.
void point_belongs_to_the_segment_it_is_on(void**) {
    // Coordinates move right along one line and, 40 rows later, up along another one that crosses
    // it halfway between two rows; the frames distinguish the two.
    Matrix x(80, 2);
    Matrix y(80, 2);
    for (std::int64_t i = 0; i < 80; ++i) {
        const bool up = i >= 40;
        const auto along = static_cast<double>(up ? i - 60 : i - 20);
        y(i, 0) = up ? 0.45 : along;
        y(i, 1) = up ? along + 0.1 : 0;
        x(i, 0) = static_cast<double>(i);
        x(i, 1) = up ? 1000 : 0;
    }
    const Given given(std::move(x), std::move(y), {80});
    const Mapping mapping = given.mapping();
    const double point[] = {0.55, 0.001};
    ASSERT_NEAR(std::hypot(point[0] - 0.45, point[1] - 0.1), 0.14, 0.01); // row 60
    ASSERT_NEAR(std::hypot(point[0] - 1, point[1]), 0.45, 0.01);          // row 21
    const Placement placement = mapping.find_point(point, 0, no_hint, {10, 1, 2});
    assert_int_equal(placement.nearest, 21);
    double frame[2];
    placement.apply(given.frames.view(), frame);
    ASSERT_NEAR(frame[0], 20.55, 0.01);
    ASSERT_NEAR(frame[1], 0, 1e-9);
    // If the order of rows is arbitrary, there are no segments.
    Given spatial = given;
    spatial.model.parameters.mode = Mode::spatial;
    assert_int_equal(spatial.mapping().find_point(point, 0, no_hint, {10, 1, 2}).nearest, 60);
}

void equidistant_rows_have_equal_weights(void**) {
    Matrix x(4, 2);
    Matrix y(4, 1);
    for (std::int64_t i = 0; i < 4; ++i) {
        x(i, 0) = i % 2 == 0 ? 1 : -1;
        x(i, 1) = i < 2 ? 1 : -1;
        y(i, 0) = std::pow(10, static_cast<double>(i));
    }
    const Given given(std::move(x), std::move(y), {4}, Mode::spatial);
    const double middle[] = {0, 0};
    const Placement placement = given.mapping().find_frame(middle, no_hint, {1, 2, 1});
    ASSERT_NEAR(coordinate(given, placement), 5.5, 1e-12);
    assert_int_equal(placement.nearest, 0);
}

void hint_may_be_a_repeat(void**) {
    Given given = line(30, {30});
    for (std::int64_t i = 11; i < 20; ++i) { // a hold
        std::copy_n(given.frames.row(10), 3, given.frames.row(i));
        given.model.coords(i, 0) = given.model.coords(10, 0);
    }
    const Mapping mapping = given.mapping();
    const MapParameters p{10, 3, 1};
    assert_int_equal(mapping.find_frame(given.frames.row(15), no_hint, p).nearest, 10);
    // From within the hold, the next motion is one row away, however many rows are held.
    const Placement next = mapping.find_frame(given.frames.row(20), 12, p);
    assert_int_equal(next.nearest, 20);
    assert_true(next.distance == 0 && next.terms.empty());
    // Far outside the window.
    assert_int_equal(mapping.find_frame(given.frames.row(25), 12, p).nearest, 20);
}

void the_hint_selects_among_equal_rows(void**) {
    Given given = line(30, {20, 10});
    std::copy_n(given.frames.row(4), 3, given.frames.row(12));
    std::copy_n(given.frames.row(4), 3, given.frames.row(25));
    const Mapping mapping = given.mapping();
    for (const std::int64_t row : {4, 12, 25})
        assert_int_equal(mapping.find_frame(given.frames.row(4), row, {}).nearest, row);
    assert_int_equal(mapping.find_frame(given.frames.row(4), no_hint, {}).nearest, 4);
    // Component 1 has different coordinates than component 0.
    const double y = given.model.coords(25, 0);
    assert_int_equal(mapping.find_point(&y, 1, 25, {}).nearest, 25);
    bool refused = false;
    try {
        mapping.find_point(&y, 0, 25, {});
    } catch (const stltsa::Error& error) {
        refused = error.status() == stltsa::Status::argument;
    }
    assert_true(refused);
}

void neighborhoods_stay_in_their_component(void**) {
    // Two clips of the same frames; the second has reversed coordinates.
    Given given = line(40, {20, 20});
    for (std::int64_t i = 0; i < 20; ++i) {
        std::copy_n(given.frames.row(i), 3, given.frames.row(20 + i));
        given.frames(20 + i, 2) = 7.5;
        given.model.coords(20 + i, 0) = -2 * static_cast<double>(i);
    }
    const Mapping mapping = given.mapping();
    const double first[] = {7.3, 5 - 2 * 7.3, 7.1};
    const double second[] = {7.3, 5 - 2 * 7.3, 7.4};
    ASSERT_NEAR(coordinate(given, mapping.find_frame(first, no_hint, {})), 14.6, 1e-9);
    ASSERT_NEAR(coordinate(given, mapping.find_frame(second, no_hint, {})), -14.6, 1e-9);
}

/// The given number of cycles of 20 rows, each slightly different.
Given cycles(std::int64_t count, double off) {
    Matrix x = sampled(20 * count, 10, 20, cyclic_pose);
    add_noise(x, off, 4);
    Matrix y(x.rows(), 1);
    for (std::int64_t i = 0; i < x.rows(); ++i)
        y(i, 0) = std::sin(turn * static_cast<double>(i) / 20);
    return {std::move(x), std::move(y), {20 * count}};
}

double step_of(const Given& given, std::int64_t row) {
    return std::sqrt(
        stltsa::squared_distance(given.frames.row(row), given.frames.row(row + 1), 10));
}

void reach_is_the_step_if_cycles_are_equal(void**) {
    const Given given = cycles(6, 0);
    double largest = 0;
    for (std::int64_t i = 0; i < 20; ++i)
        largest = std::max(largest, step_of(given, i));
    // Exact repetitions do not reduce the reach.
    for (const double period : {0.0, 20.0}) {
        ASSERT_NEAR(given.mapping(period).reach(), largest, 0.05 * largest);
    }
}

void reach_grows_with_the_difference_of_repetitions(void**) {
    // 100 times as many rows as distinct phases, so that the step is small.
    const Given fine = [] {
        Matrix x = sampled(1200, 10, 200, [](double t, std::int64_t c) {
            return cyclic_pose(t, c) + (c == 3 ? 0.5 * std::floor(t + 1e-9) : 0);
        });
        Matrix y(1200, 1);
        return Given(std::move(x), std::move(y), {1200});
    }();
    const double without = fine.mapping(0).reach();
    const double with = fine.mapping(200).reach();
    assert_true(without < 0.1);
    ASSERT_NEAR(with, 0.5, 0.02); // from one repetition to the next
}

void reach_of_unordered_rows_is_their_spacing(void**) {
    // Rows of a grid in random order.
    Matrix x(400, 2);
    for (std::int64_t i = 0; i < 400; ++i) {
        const std::int64_t place = i * 149 % 400;
        x(i, 0) = static_cast<double>(place % 20);
        x(i, 1) = static_cast<double>(place / 20);
    }
    Matrix y = x;
    const Given given(std::move(x), std::move(y), {400}, Mode::spatial);
    ASSERT_NEAR(given.mapping().reach(), 1, 1e-12);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(lines_are_extrapolated),
        cmocka_unit_test(weights_fade_out_with_the_blend),
        cmocka_unit_test(point_belongs_to_the_segment_it_is_on),
        cmocka_unit_test(equidistant_rows_have_equal_weights),
        cmocka_unit_test(hint_may_be_a_repeat),
        cmocka_unit_test(the_hint_selects_among_equal_rows),
        cmocka_unit_test(neighborhoods_stay_in_their_component),
        cmocka_unit_test(reach_is_the_step_if_cycles_are_equal),
        cmocka_unit_test(reach_grows_with_the_difference_of_repetitions),
        cmocka_unit_test(reach_of_unordered_rows_is_their_spacing),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
