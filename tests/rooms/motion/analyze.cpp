// SPDX-License-Identifier: BSD-3-Clause
// Whole recordings: what is found of cycles, repetitions, actions and rests that were put in.
#include "../checkpoints.hpp"
#include "recordings.hpp"

#include <algorithm>
#include <string>

namespace {

using namespace motion_testing;

void kinds_labels_and_counts_are_found(void**) {
    const Matrix samples = Recorder()
                               .cycles(20, 1.1, 0)
                               .rest(2)
                               .action(1.5, 4)
                               .rest(1.2)
                               .action(1.5, 4)
                               .rest(0.8)
                               .action(1.5, 4)
                               .rest(2)
                               .cycles(15, 1.1, 0)
                               .rest(2)
                               .cycles(12, 0.7, 6)
                               .samples();
    const Recording found = answer(samples);
    check_cover(found, samples);
    using enum SegmentKind;
    const std::vector<SegmentKind> expected{cyclic, repetitions, cyclic, cyclic};
    assert_true(moving_kinds(found) == expected);
    std::vector<int> labels;
    std::vector<std::int64_t> counts;
    for (const Segment& segment : found.segments)
        if (segment.kind != rest) {
            labels.push_back(segment.label);
            counts.push_back(segment.count);
        }
    assert_true((labels == std::vector<int>{0, 1, 0, 2}));
    assert_true(counts[0] >= 17 && counts[0] <= 18);
    assert_int_equal(counts[1], 3);
    assert_int_equal(found.repetitions.size(), 3);
    assert_true(counts[2] >= 12 && counts[2] <= 13);
    assert_true(counts[3] >= 15 && counts[3] <= 17);
    ASSERT_NEAR(found.segments[0].period, 1.1 * fps, 0.5);
    assert_true(found.segments.back().open_end);
    for (const Cycle& cycle : found.cycles)
        assert_true(cycle.confidence > 0.5 && cycle.likeness > 0.9);
}

/// 2000 strides: every one is found, at the same phase from the first to the last.
void nothing_is_lost_because_a_recording_is_long(void**) {
    const Matrix samples = Recorder().cycles(2000, 1, 0).samples();
    const Recording found = answer(samples);
    check_cover(found, samples);
    assert_int_equal(found.segments.size(), 1);
    assert_true(found.cycles.size() >= 1999);
    const double first = found.cycles.front().begin / fps;
    for (std::size_t i = 0; i < found.cycles.size(); ++i) {
        const double phase = found.cycles[i].begin / fps - first;
        ASSERT_NEAR(phase, std::round(phase), 0.02);
        ASSERT_NEAR(found.cycles[i].end - found.cycles[i].begin, fps, 1);
    }
}

void the_period_is_followed(void**) {
    const Matrix samples = Recorder().cycles(60, 1.6, 0, 2).samples();
    const Recording found = answer(samples);
    assert_int_equal(moving_kinds(found).size(), 1);
    // The phase is the integral of 1 / 1.6 (1 + t / 60).
    const double whole = std::floor(60 / 1.6 * 1.5);
    assert_true(static_cast<double>(found.cycles.size()) >= whole - 2);
    assert_true(found.cycles.front().end - found.cycles.front().begin > 1.45 * fps);
    assert_true(found.cycles.back().end - found.cycles.back().begin < 0.9 * fps);
}

void noise_and_single_actions_have_no_cycles(void**) {
    Random random(7);
    Matrix noise(9000, 12);
    for (std::int64_t i = 0; i < noise.rows() * noise.cols(); ++i)
        noise.data()[i] = random.symmetric();
    assert_true(answer(noise).cycles.empty());
    const Matrix samples = Recorder().rest(20).action(2, 0).rest(20).action(1, 3).rest(5).samples();
    const Recording found = answer(samples);
    check_cover(found, samples);
    assert_true(found.cycles.empty() && found.repetitions.empty());
    assert_int_equal(moving_kinds(found).size(), 2);
    assert_true(!found.reason.empty());
    assert_true(found.segments[1].label != found.segments[3].label);
}

/// A small wave counts beside a large run.
void a_small_motion_beside_a_large_one_is_found(void**) {
    Matrix samples = Recorder().cycles(20, 0.8, 0).rest(3).cycles(20, 0.6, 4).samples();
    for (std::int64_t i = 0; i < 20 * static_cast<std::int64_t>(fps); ++i)
        for (std::int64_t c = 0; c < 3; ++c)
            samples(i, c) *= 5;
    const Recording found = answer(samples);
    assert_int_equal(moving_kinds(found).size(), 2);
    const Segment& last = found.segments.back();
    assert_true(last.kind == SegmentKind::cyclic && last.count >= 30);
    const auto most = std::ranges::max_element(last.energy) - last.energy.begin();
    assert_true(most >= 4 && most <= 6);
}

/// The coordinate drifts, and its steepest points with it: without alignment, lengths differ by 3 %
/// and their mean is 2 % too short; in the clip of few cycles, one is 5 % too short.
void equal_cycles_are_equally_long(void**) {
    for (const double period : {0.6, 1.0, 1.7})
        for (const double count : {3.2, 4.6, 10.0}) {
            const Matrix samples = Recorder().cycles(count * period, period, 0).samples(0);
            const Recording found = answer(samples);
            assert_true(static_cast<double>(found.cycles.size()) >= count - 2);
            for (const Cycle& cycle : found.cycles)
                ASSERT_NEAR((cycle.end - cycle.begin) / (period * fps), 1, 3e-4);
        }
}

/// A clip that is cut off at both ends has as many cycles as it has whole turns.
void a_clip_of_one_motion_is_one_segment(void**) {
    for (const double seconds : {3.0, 5.6, 8.0}) {
        const Matrix samples = Recorder().cycles(seconds, 1.1, 0).samples();
        const Recording found = answer(samples);
        check_cover(found, samples);
        assert_int_equal(found.segments.size(), 1);
        assert_true(found.segments[0].open_begin && found.segments[0].open_end);
        assert_int_equal(found.cycles.size(), static_cast<int>(seconds / 1.1));
    }
}

/// One stride that was cut to be played in a loop.
void a_closed_clip_is_one_cycle(void**) {
    const Matrix samples = Recorder().cycles(1.1 - 0.5 / fps, 1.1, 0).samples(0);
    const Recording found = answer(samples);
    assert_int_equal(found.cycles.size(), 1);
    ASSERT_NEAR(found.cycles[0].end, static_cast<double>(samples.rows()), 0);
    assert_true(answer(Recorder().action(1.1, 0).samples(0)).cycles.empty());
}

/// Strides in a walk around a circle, of which there is little more than one turn.
void strides_count_if_the_longest_lag_gives_no_cycle(void**) {
    const auto rows = static_cast<std::int64_t>(6.4 * fps);
    Matrix samples(rows, 6);
    Random random(1);
    for (std::int64_t i = 0; i < rows; ++i) {
        const double t = 2 * std::numbers::pi * static_cast<double>(i) / fps;
        const double stride = t / 1.6, circle = t / 5;
        const double row[] = {std::sin(stride),           std::cos(stride),
                              0.4 * std::sin(2 * stride), 1.75 * std::sin(circle),
                              1.75 * std::cos(circle),    0.5 * std::sin(3 * circle + 1)};
        for (std::int64_t c = 0; c < 6; ++c)
            samples(i, c) = row[c] + 0.003 * random.symmetric();
    }
    const Recording found = answer(samples);
    assert_int_equal(found.segments.size(), 1);
    assert_int_equal(found.cycles.size(), 3);
    ASSERT_NEAR(found.segments[0].period / fps, 1.6, 0.02);
}

/// As many segments as asked for, or an error that says how many there can be.
void the_number_of_segments_may_be_given(void**) {
    const Matrix samples = Recorder()
                               .cycles(15, 1.1, 0)
                               .rest(2)
                               .cycles(15, 0.7, 3)
                               .rest(2)
                               .cycles(15, 0.9, 6)
                               .samples();
    Options options;
    const auto count = [&](std::int64_t wanted) {
        options.segments = wanted;
        const Recording found = analyze(samples.view(), fps, options);
        check_cover(found, samples);
        return static_cast<std::int64_t>(moving_kinds(found).size());
    };
    for (std::int64_t wanted = 1; wanted <= 3; ++wanted)
        assert_int_equal(count(wanted), wanted);
    try {
        count(200);
        assert_true(false);
    } catch (const stltsa::Error& error) {
        assert_true(error.status() == stltsa::Status::argument);
        assert_true(std::string(error.what()).find("ask for at most") != std::string::npos);
    }
}

/// Borders within rests make no segments in motion, so that more are added than are missing.
void many_segments_are_found_between_rests(void**) {
    Random random(11);
    Matrix samples(static_cast<std::int64_t>(80 * fps), 4);
    double place[4] = {}, speed[4] = {};
    for (std::int64_t i = 0; i < samples.rows(); ++i) {
        const double t = static_cast<double>(i) / fps;
        const double size = std::fmod(t, 20) < 10 ? 4 : 1;
        for (std::int64_t c = 0; c < 4; ++c) {
            speed[c] += 0.3 * random.symmetric() - 0.03 * speed[c] - 0.002 * place[c];
            if (std::fmod(t, 8) < 2)
                speed[c] = 0;
            place[c] += size * speed[c] / fps;
            samples(i, c) = place[c] + 0.001 * random.symmetric();
        }
    }
    Options options;
    for (const std::int64_t wanted : {43, 46, 49, 52}) {
        options.segments = wanted;
        assert_int_equal(moving_kinds(analyze(samples.view(), fps, options)).size(), wanted);
    }
}

/// White noise is measured, so that standing stays standing.
void rests_are_found_in_noise(void**) {
    const Recorder recorder =
        Recorder().cycles(15, 1.1, 0).rest(3).cycles(15, 0.7, 4).rest(3).cycles(15, 1.1, 0);
    const auto rests = [&](double noise) {
        const Recording found = answer(recorder.samples(noise));
        return std::ranges::count(found.segments, SegmentKind::rest, &Segment::kind);
    };
    assert_int_equal(rests(0.003), 2);
    assert_int_equal(rests(0.15), 2);
}

/// Two repetitions with a pause too short to be a rest are two.
void repetitions_with_a_short_pause_are_counted(void**) {
    Recorder recorder;
    recorder.rest(1);
    for (const double pause : {0.8, 0.6, 0.1, 0.7, 0.8, 0.1, 0.6, 0.8})
        recorder.action(1.2, 4).rest(pause);
    const Recording found = answer(recorder.samples());
    assert_int_equal(found.repetitions.size(), 8);
    assert_int_equal(moving_kinds(found).size(), 1);
    for (const Repetition& repetition : found.repetitions)
        ASSERT_NEAR((repetition.end - repetition.begin) / fps, 1.2, 0.4);
}

/// A body that only sways stands, if its size is known.
void a_swaying_body_rests(void**) {
    const Matrix samples = Recorder()
                               .action(9, 0, 0.005)
                               .action(6, 4, 0.004)
                               .action(14, 2, 0.005)
                               .action(8, 6, 0.003)
                               .samples(0);
    Options options;
    assert_false(moving_kinds(analyze(samples.view(), fps, options)).empty());
    options.size = 1;
    const Recording found = analyze(samples.view(), fps, options);
    assert_true(moving_kinds(found).empty());
    check_cover(found, samples);
}

/// A crop has the cycles of the whole recording, though its curve may have the other sign. If the
/// choice of the place would cost a cycle, they begin elsewhere: 39 turns and 0.36 of one leave
/// this much room, and half of what is left is the farthest from the margin.
void cycles_of_a_crop_begin_at_the_same_half(void**) {
    Matrix samples = Recorder().cycles(60, 1.1, 0).samples();
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        samples(i, 1) *= 0.4; // on a circle, any direction would do
    const Recording whole = answer(samples);
    for (const std::int64_t first : {7, 16, 24}) {
        const Recording crop = analyze(samples.view().block(first, 1300), fps, {});
        assert_int_equal(crop.cycles.size(), 39);
        for (const Cycle& cycle : crop.cycles) {
            const double begin = cycle.begin + static_cast<double>(first);
            const auto distance = [&](const Cycle& other) { return std::abs(other.begin - begin); };
            const auto same = std::ranges::min_element(whole.cycles, {}, distance);
            ASSERT_NEAR(same->begin, begin, first == 7 ? 1 : 0.33 * 1.1 * fps);
        }
    }
}

void few_cycles_between_others_have_a_curve(void**) {
    const Matrix samples = Recorder()
                               .cycles(20, 1.1, 0)
                               .action(5, 7)
                               .cycles(3.4, 1.6, 3)
                               .action(4, 7)
                               .cycles(15, 0.9, 0)
                               .samples();
    const Recording found = answer(samples);
    check_cover(found, samples);
    check_curves(found);
    assert_int_equal(std::ranges::count(moving_kinds(found), SegmentKind::cyclic), 3);
}

/// Cycles that begin and end with the recording are whole.
void no_cycle_is_lost_at_the_ends(void**) {
    for (const double seconds : {0.0, 0.25, 0.5, 0.75}) {
        const auto lead = static_cast<std::int64_t>(std::lround(seconds * fps));
        const Matrix samples = Recorder().cycles(41, 1, 0).samples(0);
        const Recording found = analyze(samples.view().block(lead, 1200), fps, {});
        assert_true(found.cycles.size() >= 39);
    }
}

/// Cycles before and after a hole are kept.
void a_hole_takes_no_cycle_beside_it(void**) {
    const Matrix samples = Recorder().rest(1).cycles(15, 1.1, 0).rest(1).samples();
    const Recording whole = answer(samples);
    const auto length = static_cast<std::int64_t>(fps);
    for (std::int64_t begin = 3 * length; begin < 13 * length; begin += 16) {
        Matrix bridged = samples;
        Options options;
        options.holes = {{static_cast<double>(begin), static_cast<double>(begin + length)}};
        for (std::int64_t i = 0; i < length; ++i)
            for (std::int64_t c = 0; c < samples.cols(); ++c)
                bridged(begin + i, c) =
                    std::lerp(samples(begin - 1, c), samples(begin + length, c),
                              static_cast<double>(i + 1) / static_cast<double>(length + 1));
        const Recording found = analyze(bridged.view(), fps, options);
        // The hole touches two cycles; one more is lost if the cycles after it begin half a cycle
        // later.
        assert_true(found.cycles.size() + 3 >= whole.cycles.size());
        for (const Cycle& cycle : found.cycles)
            assert_true(cycle.end <= options.holes[0].begin + 1 ||
                        cycle.begin >= options.holes[0].end - 1);
    }
}

/// At 1e300 sums of squares overflow.
void numbers_too_large_are_refused(void**) {
    Matrix samples = Recorder().cycles(200, 1, 0).samples();
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (std::int64_t c = 0; c < samples.cols(); ++c)
            samples(i, c) *= 1e300;
    try {
        analyze(samples.view(), fps, {});
        assert_true(false);
    } catch (const stltsa::Error& error) {
        assert_true(error.status() == stltsa::Status::not_finite);
    }
}

/// At 2^-520, squares vanish.
void tiny_numbers_are_as_good_as_others(void**) {
    const Matrix samples = Recorder().cycles(20, 1, 0).rest(5).cycles(20, 0.7, 1).samples();
    Matrix tiny = samples;
    for (std::int64_t i = 0; i < tiny.rows(); ++i)
        for (std::int64_t c = 0; c < tiny.cols(); ++c)
            tiny(i, c) = std::ldexp(tiny(i, c), -520);
    const Recording want = analyze(samples.view(), fps, {});
    const Recording got = analyze(tiny.view(), fps, {});
    assert_true(want.cycles.size() > 3);
    assert_int_equal(got.cycles.size(), want.cycles.size());
    for (std::size_t i = 0; i < got.cycles.size(); ++i)
        ASSERT_NEAR(got.cycles[i].begin, want.cycles[i].begin, 1e-9);
    assert_int_equal(got.segments.size(), want.segments.size());
}

void it_can_be_cancelled(void**) {
    const Matrix samples = Recorder().cycles(200, 1, 0).samples();
    assert_true(testing::ends_at(10, [&] { analyze(samples.view(), fps, {}); }));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(kinds_labels_and_counts_are_found),
        cmocka_unit_test(nothing_is_lost_because_a_recording_is_long),
        cmocka_unit_test(the_period_is_followed),
        cmocka_unit_test(noise_and_single_actions_have_no_cycles),
        cmocka_unit_test(a_small_motion_beside_a_large_one_is_found),
        cmocka_unit_test(equal_cycles_are_equally_long),
        cmocka_unit_test(a_clip_of_one_motion_is_one_segment),
        cmocka_unit_test(a_closed_clip_is_one_cycle),
        cmocka_unit_test(strides_count_if_the_longest_lag_gives_no_cycle),
        cmocka_unit_test(the_number_of_segments_may_be_given),
        cmocka_unit_test(many_segments_are_found_between_rests),
        cmocka_unit_test(rests_are_found_in_noise),
        cmocka_unit_test(repetitions_with_a_short_pause_are_counted),
        cmocka_unit_test(a_swaying_body_rests),
        cmocka_unit_test(cycles_of_a_crop_begin_at_the_same_half),
        cmocka_unit_test(few_cycles_between_others_have_a_curve),
        cmocka_unit_test(no_cycle_is_lost_at_the_ends),
        cmocka_unit_test(a_hole_takes_no_cycle_beside_it),
        cmocka_unit_test(numbers_too_large_are_refused),
        cmocka_unit_test(tiny_numbers_are_as_good_as_others),
        cmocka_unit_test(it_can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
