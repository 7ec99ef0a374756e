// SPDX-License-Identifier: BSD-3-Clause
// The phase of a motion, grown from where its period is known.
#include "motion/cycles/growth.hpp"

#include "recordings.hpp"

namespace {

using namespace motion_testing;

Signal signal_of(const Matrix& samples) {
    return make_signal(samples.view(), fps, 0, 0);
}

/// The rows [begin, end), of which each has this period.
Stretch steady(std::int64_t begin, std::int64_t end, double period) {
    return {{begin, end}, std::vector<double>(static_cast<std::size_t>(end - begin), period), 1};
}

Growth grown(const Signal& signal, const Stretch& stretch) {
    return grow(signal, stretch, {0, signal.rows()});
}

void the_phase_follows_the_tempo(void**) {
    const double seconds = 20, period = 1.3, speed_up = 1.5;
    const Signal signal = signal_of(Recorder().cycles(seconds, period, 0, speed_up).samples(0));
    const PeriodTrack track = track_period(signal, {0, signal.rows()}, {});
    assert_int_equal(track.stretches.size(), 1);
    const Growth found = grown(signal, track.stretches[0]);
    const auto truth = [&](std::int64_t row) {
        const double t = static_cast<double>(row + 1) / fps;
        return (t + (speed_up - 1) * t * t / (2 * seconds)) / period;
    };
    const std::int64_t middle = signal.rows() / 2;
    const auto phase = [&](std::int64_t row) {
        return found.run.phase[static_cast<std::size_t>(row - found.run.begin)];
    };
    assert_true(found.run.begin <= 3 && found.run.end() >= signal.rows() - 3);
    for (std::int64_t row = found.run.begin; row < found.run.end(); ++row)
        ASSERT_NEAR(phase(row) - phase(middle), truth(row) - truth(middle), 0.04);
    ASSERT_NEAR(found.turns(), truth(signal.rows() - 1) - truth(0), 0.1);
}

void it_grows_to_the_end_of_the_motion(void**) {
    const Signal signal =
        signal_of(Recorder().cycles(10, 1.4, 3).cycles(12, 1, 0).cycles(10, 0.8, 6).samples(0.003));
    const Growth found = grown(signal, steady(390, 585, fps));
    ASSERT_NEAR(static_cast<double>(found.run.begin), 300, 8);
    ASSERT_NEAR(static_cast<double>(found.run.end()), 660, 8);
    // Never beyond the rows that are free.
    const Growth within = grow(signal, steady(390, 540, fps), {350, 600});
    assert_true(within.run.begin == 350 && within.run.end() == 600);
}

void units_and_signs_change_nothing(void**) {
    const Matrix samples = Recorder().cycles(8, 1.1, 0).samples(0.01);
    Matrix other = samples;
    for (std::int64_t i = 0; i < other.rows(); ++i)
        for (std::int64_t c = 0; c < other.cols(); ++c)
            other(i, c) *= c % 2 == 0 ? -1024 : 1024;
    const Stretch stretch = steady(60, 180, 33);
    const Growth a = grown(signal_of(samples), stretch), b = grown(signal_of(other), stretch);
    assert_true(a.run.begin == b.run.begin && a.run.rows() == b.run.rows());
    for (std::size_t i = 0; i < a.run.phase.size(); ++i)
        ASSERT_NEAR(a.run.phase[i] - a.run.phase[0], b.run.phase[i] - b.run.phase[0], 1e-6);
}

void rows_and_phases_are_inverse(void**) {
    const Growth found =
        grown(signal_of(Recorder().cycles(6, 1, 0).samples(0)), steady(30, 150, fps));
    for (std::int64_t i = 0; i < found.run.rows(); ++i)
        ASSERT_NEAR(found.row_of(found.run.phase[static_cast<std::size_t>(i)]),
                    static_cast<double>(found.run.begin + i), 1e-9);
    const double middle = (found.run.phase[10] + found.run.phase[11]) / 2;
    ASSERT_NEAR(found.row_of(middle), static_cast<double>(found.run.begin) + 10.5, 1e-9);
    // At most half a row beyond the ends.
    ASSERT_NEAR(found.row_of(1e9), static_cast<double>(found.run.end()) - 0.5, 1e-9);
    ASSERT_NEAR(found.row_of(-1e9), static_cast<double>(found.run.begin) - 0.5, 1e-9);
}

/// The cycle whose middle is another movement deviates; the others hardly do.
void what_is_unlike_the_mean_deviates(void**) {
    Matrix samples = Recorder().cycles(10, 1, 0).samples(0);
    for (std::int64_t i = 157; i < 168; ++i)
        samples(i, 0) +=
            0.5 * (1 - std::cos(2 * std::numbers::pi * (static_cast<double>(i) - 157) / 10));
    const Growth found = grown(signal_of(samples), steady(30, 270, fps));
    const auto deviation = [&](std::int64_t row) {
        return found.deviation[static_cast<std::size_t>(row - found.run.begin)];
    };
    assert_true(deviation(159) > 0.1 && deviation(164) > 0.1);
    for (const std::int64_t row : {60, 100, 220, 250})
        assert_true(deviation(row) < 0.02);
}

void too_few_rows_have_no_phase(void**) {
    const Signal signal = signal_of(Recorder().cycles(6, 1, 0).samples(0));
    const Growth found = grow(signal, steady(30, 34, fps), {30, 34});
    assert_int_equal(found.run.rows(), 0);
    assert_true(found.turns() == 0);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(the_phase_follows_the_tempo),
        cmocka_unit_test(it_grows_to_the_end_of_the_motion),
        cmocka_unit_test(units_and_signs_change_nothing),
        cmocka_unit_test(rows_and_phases_are_inverse),
        cmocka_unit_test(what_is_unlike_the_mean_deviates),
        cmocka_unit_test(too_few_rows_have_no_phase),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
