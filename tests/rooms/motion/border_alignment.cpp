// SPDX-License-Identifier: BSD-3-Clause
// Borders that are not at the same posture.
#include "motion/cycles/border_alignment.hpp"

#include <numeric>

#include "checkpoints.hpp"
#include "motion/recordings.hpp"

namespace {

using namespace motion_testing;

Signal cycles_of_a_second(double seconds) {
    return make_signal(Recorder().cycles(seconds, 1, 0).samples(0).view(), fps, 0, 0);
}

/// Borders at every cycle from the row `first` on, each moved by up to 0.08 of a cycle.
std::vector<double> moved_borders(double first, std::size_t count, double cycle = fps) {
    std::vector<double> borders;
    for (std::size_t i = 0; i < count; ++i)
        borders.push_back(first + cycle * static_cast<double>(i) +
                          0.08 * cycle * std::sin(2.5 * static_cast<double>(i)));
    return borders;
}

std::vector<double> aligned(const Signal& signal, Rows within, const std::vector<double>& borders) {
    return align_borders(signal, within, borders);
}

double mean_of(const std::vector<double>& borders) {
    return std::accumulate(borders.begin(), borders.end(), 0.0) /
           static_cast<double>(borders.size());
}

void check_cycles(const std::vector<double>& borders, double accuracy) {
    for (std::size_t i = 1; i < borders.size(); ++i)
        ASSERT_NEAR((borders[i] - borders[i - 1]) / fps, 1, accuracy);
}

void cycles_become_equal(void**) {
    const Signal signal = cycles_of_a_second(10);
    for (const std::size_t count : {3U, 4U, 8U}) {
        const std::vector<double> before = moved_borders(40, count);
        const std::vector<double> after = aligned(signal, {0, 291}, before);
        check_cycles(after, 1e-3);
        ASSERT_NEAR(mean_of(after), mean_of(before), 1e-9);
    }
}

void a_border_alone_stays(void**) {
    const std::vector<double> before{40};
    assert_true(aligned(cycles_of_a_second(10), {0, 291}, before) == before);
}

/// Where an aligned border would lie outside, all are shifted.
void borders_stay_inside(void**) {
    const Signal signal = cycles_of_a_second(10);
    std::vector<double> borders = moved_borders(40, 8);
    borders.front() = 43; // the others move forward, and this one back
    const std::vector<double> after = aligned(signal, {42, 291}, borders);
    ASSERT_NEAR(after.front(), 42, 1e-9);
    check_cycles(after, 1e-3);
}

/// Four cycles are 120 rows, one more than there are.
void a_clip_may_be_as_long_as_its_cycles(void**) {
    const Signal signal = cycles_of_a_second(4);
    std::vector<double> borders;
    for (int i = 0; i <= 4; ++i)
        borders.push_back(0.5 + 118.0 / 4 * i + (i == 2 ? 2 : 0));
    const std::vector<double> after = aligned(signal, {0, 120}, borders);
    ASSERT_NEAR(after[2] - after[1], fps, 0.1);
    ASSERT_NEAR(after[3] - after[2], fps, 0.1);
    assert_true(after.front() >= 0 && after.back() <= 119);
}

/// Borders of nothing that repeats are not drawn together.
void borders_stay_in_order(void**) {
    Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
        Matrix noise(200, 3);
        for (std::int64_t i = 0; i < noise.rows(); ++i)
            for (std::int64_t c = 0; c < noise.cols(); ++c)
                noise(i, c) = random.symmetric();
        const std::vector<double> before = moved_borders(30, 9, fps / 2);
        const auto after = aligned(make_signal(noise.view(), fps, 0, 0), {0, 200}, before);
        for (std::size_t i = 1; i < after.size(); ++i)
            assert_true(after[i] - after[i - 1] >= 0.4 * (before[i] - before[i - 1]));
    }
}

void still_bodies_keep_their_borders(void**) {
    const Signal signal = make_signal(Matrix(100, 3).view(), fps, 0, 0);
    const std::vector<double> before = moved_borders(20, 3);
    assert_true(aligned(signal, {0, 100}, before) == before);
}

/// No movement is compared around a border at the very start of the clip.
void the_others_are_aligned_without_it(void**) {
    const double period = 0.2, cycle = period * fps;
    const Signal signal = make_signal(Recorder().cycles(3, period, 0).samples(0).view(), fps, 0, 0);
    std::vector<double> borders;
    for (int i = 0; i < 12; ++i)
        borders.push_back(1 + cycle * i + 0.4 * std::sin(2.5 * i));
    const std::vector<double> after = aligned(signal, {0, 90}, borders);
    assert_true(after != borders);
    for (std::size_t i = 3; i + 1 < after.size(); ++i)
        ASSERT_NEAR(after[i] - after[i - 1], cycle, 0.02 * cycle);
}

void it_can_be_cancelled(void**) {
    const Signal signal = cycles_of_a_second(10);
    assert_true(testing::ends_at(1, [&] {
        align_borders(signal, {0, 291}, moved_borders(40, 8));
    }));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(cycles_become_equal),
        cmocka_unit_test(a_border_alone_stays),
        cmocka_unit_test(borders_stay_inside),
        cmocka_unit_test(a_clip_may_be_as_long_as_its_cycles),
        cmocka_unit_test(borders_stay_in_order),
        cmocka_unit_test(still_bodies_keep_their_borders),
        cmocka_unit_test(the_others_are_aligned_without_it),
        cmocka_unit_test(it_can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
