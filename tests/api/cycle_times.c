/* SPDX-License-Identifier: BSD-3-Clause */
/* Lengths of cycles. */
#include "support.h"

static const double unit = 6.283185307179586;

/* The first and the last, too, though the clip begins and ends in motion. */
TEST(sines_have_equal_cycles) {
    enum { rows = 600, cols = 4, fps = 60 };
    double* x = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i)
        for (int c = 0; c < cols; ++c)
            x[cols * i + c] =
                sin(6.283185307179586 * (1 + c / 2) * i / fps + c % 2 * 1.5707963267948966);
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_matrix(&in, fps, &clip));
    stltsa_decomposition* d = decomposed(clip, NULL);
    assert_true(count_of(d, STLTSA_INFO_CYCLE) >= 8);
    for (int i = 0; i < count_of(d, STLTSA_INFO_CYCLE); ++i) {
        const stltsa_part cycle = cycle_at(d, i);
        assert_below(fabs(cycle.end_s - cycle.begin_s - 1), 2e-4, "cycle");
    }
    assert_below(fabs(real_of(d, STLTSA_INFO_PERIOD) - 1), 1e-4, "period");
    stltsa_clip_free(clip);
}

/* One cycle that was cut to be played in a loop. Samples are every fourth frame, and their number
 * times four is not the number of frames. */
TEST(cycles_end_with_the_clip) {
    for (int rows = 133; rows <= 140; ++rows) {
        double* x = new_matrix(rows, 3);
        for (int i = 0; i < rows; ++i) {
            const double turn = 6.283185307179586 * i / rows;
            x[3 * i] = sin(turn);
            x[3 * i + 1] = cos(turn);
            x[3 * i + 2] = 0.3 * sin(2 * turn + 1);
        }
        const stltsa_in in = packed_in(x, rows, 3);
        stltsa_clip* clip = NULL;
        stltsa_decomposition* d = NULL;
        stltsa_phase* phase = NULL;
        must(stltsa_clip_from_matrix(&in, 120, &clip));
        must(stltsa_decompose(clip, NULL, &d));
        assert_int_equal(count_of(d, STLTSA_INFO_CYCLE), 1);
        const stltsa_part cycle = cycle_at(d, 0);
        assert_int_equal(cycle.begin, 0);
        assert_int_equal(cycle.end, rows);
        assert_below(fabs(cycle.end_s - rows / 120.0), 1e-12, "end");
        must(stltsa_phase_find(d, NULL, &phase));
        stltsa_phase_free(phase);
        stltsa_decomposition_free(d);
        stltsa_clip_free(clip);
    }
}

/* A motion with noise whose cycles have other lengths, with a pause between two stretches of them.
 */
static stltsa_clip* noisy_cycles(void) {
    enum { rows = 2400, cols = 6, fps = 100 };
    double* x = new_matrix(rows, cols);
    uint64_t seed = 7;
    for (int i = 0; i < rows; ++i) {
        const double t = (double)i / fps;
        const double moved = t < 11 ? t : t < 13 ? 11 : t - 2;
        const double phase = unit * (moved / 1.07 + 0.03 * sin(0.4 * moved));
        for (int c = 0; c < cols; ++c) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            x[cols * i + c] = sin(phase + c) + 0.4 * cos(2 * phase + c * c) +
                              0.1 * ((double)(seed >> 11) / 9007199254740992.0 - 0.5);
        }
    }
    stltsa_clip* clip = matrix_clip(x, rows, cols, fps);
    return clip;
}

/* Cycles, their borders and their mean time are the same wherever they are shown. */
TEST(all_results_have_the_same_cycles) {
    stltsa_clip* clip = noisy_cycles();
    stltsa_decomposition* d = NULL;
    stltsa_phase* phase = NULL;
    stltsa_cycles* cycles = NULL;
    stltsa_comparison* comparison = NULL;
    must(stltsa_decompose(clip, NULL, &d));
    must(stltsa_phase_find(d, NULL, &phase));
    const int64_t count = count_of(d, STLTSA_INFO_CYCLE), frames = stltsa_clip_frames(clip);
    const double fps = stltsa_clip_fps(clip);
    assert_true(count > 10 && count < 50);

    double* signal = new_matrix(frames, 1);
    for (int64_t i = 0; i < frames; ++i)
        signal[i] = (double)i;
    const stltsa_in in = packed_in(signal, frames, 1);
    must(stltsa_cycles_resample(phase, 0, &in, 11, NULL, &cycles));
    assert_int_equal(count_of(cycles, STLTSA_INFO_VALUES), count);
    double* times = array_of(cycles, STLTSA_INFO_SAMPLE_FRAMES);
    double mean = 0;
    for (int64_t i = 0; i < count; ++i) {
        const stltsa_part part = cycle_at(d, i);
        assert_below(fabs(times[11 * i] / fps - part.begin_s), 1e-12, "begin");
        assert_below(fabs(times[11 * i + 10] / fps - part.end_s), 1e-12, "end");
        mean += (part.end_s - part.begin_s) / (double)count;
    }

    stltsa_statistics statistics = {0};
    must(stltsa_decomposition_statistics(d, STLTSA_INFO_CYCLE, 0, -1, STLTSA_QUANTITY_TIME,
                                         &statistics));
    const stltsa_summary summary = summary_at(d, 0);
    must(stltsa_compare(phase, 0, phase, 0, 101, NULL, &comparison));
    const stltsa_compared compared = compared_of(comparison);
    const stltsa_compared_motion first = motion_at(comparison, 0);
    assert_int_equal(statistics.count, count);
    assert_int_equal(summary.count, count);
    assert_int_equal(first.cycles, count);
    assert_below(fabs(statistics.mean - mean), 1e-12, "mean of the statistics");
    assert_below(fabs(summary.cycle_time_s.mean - mean), 1e-12, "mean of the summary");
    assert_below(fabs(compared.cycle_time_s.first - mean), 1e-12, "mean of the comparison");
    assert_below(fabs(compared.cycle_time_s.first_sd - statistics.sd), 1e-12, "SD");
    assert_below(fabs(summary.cycles_per_min - 60 / mean), 1e-9, "per minute");
    assert_below(fabs(first.cycles_per_min - 60 / mean), 1e-9, "per minute");

    /* Frames of cycle k have index k, and phases from about 0 to about 1. */
    double* values = array_of(phase, STLTSA_INFO_PHASE);
    int64_t* index = whole_of(phase, STLTSA_INFO_PHASE_CYCLE);
    for (int64_t i = 0; i < count; ++i) {
        const stltsa_part part = cycle_at(d, i);
        for (int64_t f = part.begin; f < part.end; ++f) {
            assert_int_equal(index[f], i);
            const double time = ((double)f / fps - part.begin_s) / (part.end_s - part.begin_s);
            const double off = values[f] - time;
            assert_below(fabs(off - floor(off + 0.5)), 0.2, "phase beside linear time");
        }
    }

    /* An event in the middle of a cycle has its index. */
    stltsa_events* events = NULL;
    const double mark = floor(times[11 * 3 + 5]);
    const stltsa_in marks = packed_in(&mark, 1, 1);
    must(stltsa_events_find(phase, &marks, NULL, NULL, &events));
    int64_t with_cycle = 0;
    for (int64_t i = 0; i < count_of(events, STLTSA_INFO_EVENT); ++i) {
        const stltsa_event event = event_at(events, i);
        if (event.cycle < 0)
            continue;
        ++with_cycle;
        assert_true(event.frame >= times[11 * event.cycle] - 0.5);
        assert_true(event.frame <= times[11 * event.cycle + 10] + 0.5);
    }
    assert_int_equal(with_cycle, count);

    stltsa_events_free(events);
    stltsa_comparison_free(comparison);
    stltsa_cycles_free(cycles);
    stltsa_phase_free(phase);
    stltsa_decomposition_free(d);
}

/* The phase outlives its decomposition, which finds it once. */
TEST(the_phase_is_found_once) {
    stltsa_clip* clip = noisy_cycles();
    stltsa_decomposition* d = NULL;
    stltsa_phase *one = NULL, *other = NULL;
    stltsa_options* options = NULL;
    int32_t left = 0;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_progress(options, cancel_after, &left));
    must(stltsa_decompose(clip, NULL, &d));
    assert_int_equal(stltsa_phase_find(d, options, &one), STLTSA_E_CANCELLED);
    assert_null(one);
    must(stltsa_phase_find(d, NULL, &one));
    must(stltsa_phase_find(d, options, &other)); /* nothing is left to do */
    stltsa_decomposition_free(d);
    const double first = real_of(one, STLTSA_INFO_PHASE_ZERO);
    stltsa_phase_free(one);
    assert_true(first == real_of(other, STLTSA_INFO_PHASE_ZERO) && first >= 0 && first < 1);
    assert_int_equal(count_of(other, STLTSA_INFO_PHASE_ZERO), 1);
    stltsa_phase_free(other);
    stltsa_options_free(options);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_results_have_the_same_cycles),
                                       cmocka_unit_test(the_phase_is_found_once),
                                       cmocka_unit_test(sines_have_equal_cycles),
                                       cmocka_unit_test(cycles_end_with_the_clip)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
