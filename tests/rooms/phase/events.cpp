// SPDX-License-Identifier: BSD-3-Clause
// src/phase: events whose true places are known, in cycles of uneven tempo and in repetitions.
#include "phase/events.hpp"

#include "../motion/testing.hpp"
#include "motion/curve/statistics.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::phase;

constexpr double rate = 30;

/// Turns; the tempo changes by a third.
double phase_at(double row) {
    return row / 36 + 0.15 * std::sin(turn * row / 180);
}

/// The row at which that is `phase`.
double row_at(double phase) {
    double low = 0, high = 1000;
    while (high - low > 1e-9) {
        const double middle = (low + high) / 2;
        (phase_at(middle) < phase ? low : high) = middle;
    }
    return low;
}

Matrix motion(double noise, unsigned seed) {
    Matrix samples = sampled(
        500, 10, 1, [](double row, std::int64_t c) { return cyclic_pose(phase_at(row), c); });
    add_noise(samples, noise, seed);
    return samples;
}

Searched cyclic(const Matrix& samples) {
    Borders given;
    for (int i = 1; i <= 11; ++i)
        given.push_back(row_at(i) + std::sin(3.1 * i)); // a frame off
    const Phases phases = find_phases(samples.view(), rate, {&given, 1}, {});
    const Matrix both = stltsa::motion::pose_and_velocity(samples.view(), rate, phases.mean.period);
    return searched(samples.view(), both.view(), rate, phases,
                    {grown(both.view(), phases.mean, phases.runs[0], {0, 500})});
}

/// Events at the one place of the marks.
std::vector<Event> events_of(const Searched& from, std::initializer_list<double> rows,
                             const Searched* in = nullptr) {
    std::vector<Mark> marks;
    for (const double row : rows)
        marks.push_back(mark_at(from, row).value());
    const auto places = places_of(from, marks);
    assert_int_equal(places.size(), 1);
    return in == nullptr ? find_events(from, places[0]) : find_events(from, places[0], *in);
}

/// Largest distance of an event from the true place, in rows; events nearer than 10 rows to the
/// ends do not count.
double worst(const std::vector<Event>& events, double phase) {
    double off = 0;
    for (const Event& event : events)
        if (event.row > 10 && event.row < 490)
            off = std::max(
                off, std::abs(event.row - row_at(std::round(phase_at(event.row) - phase) + phase)));
    return off;
}

void one_mark_finds_all(void**) {
    const Matrix samples = motion(0.02, 1);
    const Searched in = cyclic(samples);
    for (const double phase : {0.1, 0.35, 0.8}) {
        const double mark = row_at(5 + phase);
        const auto events = events_of(in, {mark});
        assert_true(events.size() >= 12);
        assert_true(worst(events, phase) < 0.5);
    }
}

void several_marks_average_their_errors(void**) {
    const Matrix samples = motion(0.02, 2);
    const Searched in = cyclic(samples);
    // Two rows late, early and right: the median is right.
    const double wrong = row_at(3.2) + 2;
    assert_true(worst(events_of(in, {wrong, row_at(5.2) - 2, row_at(7.2)}), 0.2) < 0.7);
    assert_true(worst(events_of(in, {wrong}), 0.2) > 1.5);
}

void another_recording_has_them_too(void**) {
    const Matrix samples = motion(0.02, 3);
    // The same motion with other amplitudes, as of another body.
    Matrix other = motion(0.02, 4);
    for (std::int64_t i = 0; i < other.rows(); ++i)
        for (std::int64_t c = 0; c < other.cols(); ++c)
            other(i, c) *= 1 + 0.1 * std::sin(static_cast<double>(3 * c));
    const Searched from = cyclic(samples), in = cyclic(other);
    const double mark = row_at(5.35);
    assert_true(likeness(from, in) > 0.95);
    const auto events = events_of(from, {mark}, &in);
    assert_true(events.size() >= 12);
    assert_true(worst(events, 0.35) < 1);
}

/// Adds a jerk of one part of the body at a phase; templates follow it.
Matrix jerking(double at, unsigned seed) {
    Matrix samples = motion(0.005, seed);
    for (std::int64_t i = 0; i < samples.rows(); ++i) {
        const double phase = phase_at(static_cast<double>(i)) - at;
        const double off = (phase - std::round(phase)) / 0.03;
        samples(i, 0) += 0.2 * std::exp(-off * off / 2);
    }
    return samples;
}

void in_another_recording_the_phase_counts_most(void**) {
    // The other body jerks 0.04 of a cycle later.
    const Matrix samples = jerking(0.35, 10), other = jerking(0.39, 11);
    const Searched from = cyclic(samples), in = cyclic(other);
    std::vector<double> late;
    for (const Event& event : events_of(from, {row_at(5.35)}, &in)) {
        const double off = phase_at(event.row) - 0.35;
        late.push_back(off - std::round(off));
    }
    ASSERT_NEAR(stltsa::motion::median(late), 0, 0.01);
}

void guessed_errors_rise_with_the_distance(void**) {
    Matrix samples = motion(0.002, 5);
    const double bad = row_at(8.35);
    for (auto i = static_cast<std::int64_t>(bad) - 8; i < static_cast<std::int64_t>(bad) + 8; ++i)
        for (std::int64_t c = 0; c < samples.cols(); ++c)
            samples(i, c) += 0.3 * std::sin(0.3 * static_cast<double>(i + 3 * c));
    const Searched in = cyclic(samples);
    const double mark = row_at(5.35);
    double at_bad = 0;
    std::vector<double> elsewhere;
    for (const Event& event : events_of(in, {mark}))
        if (std::abs(event.row - bad) < 6)
            at_bad = event.error_ms;
        else
            elsewhere.push_back(event.error_ms);
    assert_true(at_bad > 1.5 * stltsa::motion::median(elsewhere));
}

void repetitions_have_one_each(void**) {
    // A bow of 40 rows every 100 rows.
    const Matrix samples = sampled(600, 6, 1, [](double row, std::int64_t c) {
        const double t = std::fmod(row, 100) - 30;
        const double shape = t > 0 && t < 40 ? (1 - std::cos(turn * t / 40)) / 2 : 0;
        const double later = t > 8 && t < 40 ? (1 - std::cos(turn * (t - 8) / 32)) / 2 : 0;
        return c % 2 == 0 ? shape * static_cast<double>(c + 1) : later * static_cast<double>(c);
    });
    std::vector<Borders> given;
    for (int i = 0; i < 6; ++i)
        given.push_back({100.0 * i + 28 + i % 2, 100.0 * i + 72 - i % 2});
    const Phases phases = find_phases_of_repetitions(samples.view(), rate, given);
    assert_false(phases.cyclic);
    const Matrix both = stltsa::motion::pose_and_velocity(samples.view(), rate, phases.mean.period);
    const Searched in = searched(samples.view(), both.view(), rate, phases, phases.runs);
    const double mark = 242;
    const auto events = events_of(in, {mark});
    assert_int_equal(events.size(), 6);
    for (std::size_t i = 0; i < events.size(); ++i)
        ASSERT_NEAR(events[i].row, 100.0 * static_cast<double>(i) + 42, 1);
    // In another recording as well, of which this one is a copy.
    for (const double at : {233.0, 242.0, 265.0})
        assert_int_equal(events_of(in, {at}, &in).size(), 6);
    // Also at the begin and the end, where runs that grow beyond them pass the phase twice.
    std::vector<Run> grew;
    for (const Run& run : phases.runs)
        grew.push_back(grown(both.view(), phases.mean, run,
                             {run.begin - 12, std::min<std::int64_t>(600, run.end() + 12)}));
    const Searched wide = searched(samples.view(), both.view(), rate, phases, grew);
    for (const double at : {227.0, 233.0, 268.0})
        assert_int_equal(events_of(wide, {at}).size(), 6);
}

void marks_far_apart_are_several_places(void**) {
    const Matrix samples = motion(0.02, 7);
    const Searched in = cyclic(samples);
    const auto marks_at = [&](std::initializer_list<double> phases) {
        std::vector<Mark> marks;
        for (const double phase : phases)
            marks.push_back(mark_at(in, row_at(phase)).value());
        return marks;
    };
    // Left and right feet, one of them across the border of the cycle.
    const auto places = places_of(in, marks_at({3.97, 5.48, 6.02, 7.52, 8.99}));
    assert_int_equal(places.size(), 2);
    assert_int_equal(places[0].size() + places[1].size(), 5);
    for (const Place& place : places)
        assert_true(place.back().phase - place.front().phase < 0.1);
    assert_int_equal(places_of(in, {}).size(), 0);
    std::vector<Mark> all_over;
    for (int i = 0; i < 20; ++i)
        all_over.push_back(mark_at(in, row_at(3 + 0.04 * i)).value());
    bool refused = false;
    try {
        places_of(in, all_over);
    } catch (const stltsa::Error& error) {
        refused = std::string(error.what()).find("spread over") != std::string::npos;
    }
    assert_true(refused);
}

void marks_in_another_motion_are_doubted(void**) {
    Matrix samples = motion(0.002, 8);
    for (std::int64_t i = 0; i < 80; ++i) // the first steps differ
        for (std::int64_t c = 0; c < samples.cols(); ++c)
            samples(i, c) += 0.5 * std::sin(0.2 * static_cast<double>(i + 3 * c));
    Searched in = cyclic(samples);
    const auto error_by = [&](double mark) {
        std::vector<double> errors;
        for (const Event& event : events_of(in, {mark}))
            if (event.row > 150)
                errors.push_back(event.error_ms);
        return stltsa::motion::median(errors);
    };
    assert_true(error_by(40) > 1.5 * error_by(240));
}

/// Cycles begin at the fourth turn. Before it, the motion is slower and some columns are late, like
/// the arms in the first step of a walk.
void first_steps_follow_the_parts_that_move(void**) {
    const auto phase_of_row = [](double row) {
        return row < 108 ? 3 + (row - 108) / 48 : row / 36;
    };
    Matrix samples = sampled(500, 10, 1, [&](double row, std::int64_t c) {
        const double late = row < 96 && c < 4 ? 0.15 : 0;
        return cyclic_pose(phase_of_row(row) - late, c);
    });
    add_noise(samples, 0.01, 9);
    Borders given;
    for (int i = 3; i <= 12; ++i)
        given.push_back(36.0 * i);
    const Phases phases = find_phases(samples.view(), rate, {&given, 1}, {});
    const Matrix both = stltsa::motion::pose_and_velocity(samples.view(), rate, phases.mean.period);
    const Searched in = searched(samples.view(), both.view(), rate, phases,
                                 {grown(both.view(), phases.mean, phases.runs[0], {24, 500})});
    double worst_off = 0;
    int before = 0;
    for (const double phase : {0.1, 0.35, 0.6, 0.85})
        for (const Event& event : events_of(in, {36 * (6 + phase)}))
            if (event.row > 40 && event.row < 90) {
                ++before;
                const double at = phase_of_row(event.row) - phase;
                worst_off = std::max(worst_off, 48 * std::abs(at - std::round(at)));
            }
    assert_true(before >= 4);
    assert_true(worst_off < 1);
}

void events_outside_of_cycles_are_doubted(void**) {
    const Matrix samples = motion(0.02, 12);
    Searched in = cyclic(samples);
    const auto usual = events_of(in, {row_at(5.35)});
    const Range cycles = in.known[0];
    const double end = row_at(6.85); // between two events
    in.known[0].end = static_cast<std::int64_t>(end);
    const auto doubted = events_of(in, {row_at(5.35)});
    assert_int_equal(doubted.size(), usual.size());
    for (std::size_t i = 0; i < usual.size(); ++i)
        if (usual[i].row > end && rows_beyond(cycles, usual[i].row) == 0) // no templates either
            assert_true(doubted[i].error_ms > 1.999 * usual[i].error_ms);
        else
            ASSERT_NEAR(doubted[i].error_ms, usual[i].error_ms, 1e-9);
}

void another_motion_has_no_events(void**) {
    const Matrix samples = motion(0.02, 13);
    const Searched in = cyclic(samples);
    const auto events_at = [&](double distance) {
        Searched changed = in;
        for (std::size_t i = 0; i < 12; ++i)
            changed.distance[0][static_cast<std::size_t>(row_at(8.35)) - 6 + i -
                                static_cast<std::size_t>(in.runs[0].begin)] = distance;
        return events_of(changed, {row_at(5.35)}).size();
    };
    const auto all = events_of(in, {row_at(5.35)}).size();
    assert_int_equal(events_at(0.99 * other_motion), all);
    assert_int_equal(events_at(1.01 * other_motion), all - 1);
}

void a_mark_outside_of_runs_is_in_no_motion(void**) {
    const Matrix samples = motion(0.02, 6);
    Searched in = cyclic(samples);
    in.runs[0].phase.resize(300);
    in.distance[0].resize(300);
    assert_true(mark_at(in, 299).has_value());
    assert_false(mark_at(in, 400).has_value());
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(one_mark_finds_all),
        cmocka_unit_test(several_marks_average_their_errors),
        cmocka_unit_test(another_recording_has_them_too),
        cmocka_unit_test(in_another_recording_the_phase_counts_most),
        cmocka_unit_test(guessed_errors_rise_with_the_distance),
        cmocka_unit_test(repetitions_have_one_each),
        cmocka_unit_test(marks_far_apart_are_several_places),
        cmocka_unit_test(marks_in_another_motion_are_doubted),
        cmocka_unit_test(first_steps_follow_the_parts_that_move),
        cmocka_unit_test(events_outside_of_cycles_are_doubted),
        cmocka_unit_test(another_motion_has_no_events),
        cmocka_unit_test(a_mark_outside_of_runs_is_in_no_motion),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
