/* SPDX-License-Identifier: BSD-3-Clause */
/* Lengths of cycles. */
#include "support.h"

static const double unit = 6.283185307179586;

/* The first and the last, too, though the clip begins and ends in motion. */
static void sines_have_equal_cycles(void** state) {
    (void)state;
    enum { rows = 600, cols = 4, fps = 60 };
    double* x = new_matrix(rows, cols);
    for (int i = 0; i < rows; ++i)
        for (int c = 0; c < cols; ++c)
            x[cols * i + c] =
                sin(6.283185307179586 * (1 + c / 2) * i / fps + c % 2 * 1.5707963267948966);
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_matrix(&in, fps, &clip));
    stltsa_decomposition* d = NULL;
    must(stltsa_decompose(clip, NULL, &d));
    assert_true(stltsa_decomposition_cycle_count(d) >= 8);
    for (int i = 0; i < stltsa_decomposition_cycle_count(d); ++i) {
        stltsa_interval cycle;
        must(stltsa_decomposition_cycle(d, i, &cycle));
        assert_below(fabs(cycle.end_s - cycle.begin_s - 1), 2e-4, "cycle");
    }
    double period = 0;
    must(stltsa_info_real(stltsa_decomposition_info(d), STLTSA_INFO_PERIOD, 0, &period));
    assert_below(fabs(period - 1), 1e-4, "period");
    stltsa_decomposition_free(d);
    stltsa_clip_free(clip);
    free(x);
}

/* One cycle that was cut to be played in a loop. Samples are every fourth frame, and their number
 * times four is not the number of frames. */
static void cycles_end_with_the_clip(void** state) {
    (void)state;
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
        stltsa_interval cycle;
        must(stltsa_clip_from_matrix(&in, 120, &clip));
        must(stltsa_decompose(clip, NULL, &d));
        assert_int_equal(stltsa_decomposition_cycle_count(d), 1);
        must(stltsa_decomposition_cycle(d, 0, &cycle));
        assert_int_equal(cycle.begin, 0);
        assert_int_equal(cycle.end, rows);
        assert_below(fabs(cycle.end_s - rows / 120.0), 1e-12, "end");
        must(stltsa_phase_find(d, NULL, &phase));
        stltsa_phase_free(phase);
        stltsa_decomposition_free(d);
        stltsa_clip_free(clip);
        free(x);
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
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_matrix(&in, fps, &clip));
    free(x);
    return clip;
}

/* Cycles, their borders and their mean time are the same wherever they are shown. */
static void all_results_have_the_same_cycles(void** state) {
    (void)state;
    stltsa_clip* clip = noisy_cycles();
    stltsa_decomposition* d = NULL;
    stltsa_phase* phase = NULL;
    stltsa_cycles* cycles = NULL;
    stltsa_comparison* comparison = NULL;
    must(stltsa_decompose(clip, NULL, &d));
    must(stltsa_phase_find(d, NULL, &phase));
    const int64_t count = stltsa_decomposition_cycle_count(d), frames = stltsa_clip_frames(clip);
    const double fps = stltsa_clip_fps(clip);
    assert_true(count > 10 && count < 50);

    double* signal = new_matrix(frames, 1);
    for (int64_t i = 0; i < frames; ++i)
        signal[i] = (double)i;
    const stltsa_in in = packed_in(signal, frames, 1);
    double times[50 * 11];
    must(stltsa_cycles_resample(phase, 0, &in, 11, &cycles));
    assert_int_equal(stltsa_cycles_count(cycles), count);
    const stltsa_out to_times = packed_out(times, count, 11);
    must(stltsa_cycles_times(cycles, &to_times, NULL));
    double mean = 0;
    for (int64_t i = 0; i < count; ++i) {
        stltsa_part part = {0};
        must(stltsa_decomposition_part(d, STLTSA_PART_CYCLE, i, &part));
        assert_below(fabs(times[11 * i] / fps - part.begin_s), 1e-12, "begin");
        assert_below(fabs(times[11 * i + 10] / fps - part.end_s), 1e-12, "end");
        mean += (part.end_s - part.begin_s) / (double)count;
    }

    stltsa_statistics statistics = {0};
    must(stltsa_decomposition_statistics(d, STLTSA_PART_CYCLE, 0, -1, STLTSA_QUANTITY_TIME,
                                         &statistics));
    stltsa_summary summary = {0};
    must(stltsa_decomposition_summary(d, 0, &summary));
    must(stltsa_compare(phase, 0, phase, 0, 101, &comparison));
    stltsa_compared_cycles compared = {.size = sizeof compared};
    must(stltsa_comparison_cycles(comparison, &compared));
    assert_int_equal(statistics.count, count);
    assert_int_equal(summary.count, count);
    assert_int_equal(compared.first_count, count);
    assert_below(fabs(statistics.mean - mean), 1e-12, "mean of the statistics");
    assert_below(fabs(summary.mean_s - mean), 1e-12, "mean of the summary");
    assert_below(fabs(compared.cycle_time.first - mean), 1e-12, "mean of the comparison");
    assert_below(fabs(compared.cycle_time.first_sd - statistics.sd), 1e-12, "SD");
    assert_below(fabs(summary.per_minute - 60 / mean), 1e-9, "per minute");
    assert_below(fabs(compared.first_per_minute - 60 / mean), 1e-9, "per minute");

    /* Frames of cycle k have index k, and phases from about 0 to about 1. */
    double* values = new_matrix(frames, 1);
    int64_t* index = malloc((size_t)frames * sizeof *index);
    const stltsa_out to_values = packed_out(values, frames, 1),
                     to_index = {index, frames, 1, 0, 0, STLTSA_I64, 0};
    must(stltsa_phase_values(phase, &to_values, NULL, &to_index));
    for (int64_t i = 0; i < count; ++i) {
        stltsa_part part = {0};
        must(stltsa_decomposition_part(d, STLTSA_PART_CYCLE, i, &part));
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
    must(stltsa_events_find(phase, &marks, NULL, &events));
    int64_t with_cycle = 0;
    for (int64_t i = 0; i < stltsa_events_count(events); ++i) {
        stltsa_event event = {.size = sizeof event};
        must(stltsa_events_event(events, i, &event));
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
    stltsa_clip_free(clip);
    free(index);
    free(values);
    free(signal);
}

/* The phase outlives its decomposition, which finds it once. */
static void the_phase_is_found_once(void** state) {
    (void)state;
    stltsa_clip* clip = noisy_cycles();
    stltsa_decomposition* d = NULL;
    stltsa_phase *one = NULL, *other = NULL;
    stltsa_options* options = NULL;
    int32_t left = 3;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_progress(options, cancel_after, &left));
    must(stltsa_decompose(clip, NULL, &d));
    assert_int_equal(stltsa_phase_find(d, options, &one), STLTSA_E_CANCELLED);
    assert_null(one);
    must(stltsa_phase_find(d, NULL, &one));
    left = 0;
    must(stltsa_phase_find(d, options, &other)); /* nothing is left to do */
    stltsa_decomposition_free(d);
    double first = 0, second = 1;
    must(stltsa_phase_zero(one, 0, &first));
    stltsa_phase_free(one);
    must(stltsa_phase_zero(other, 0, &second));
    assert_true(first == second && first >= 0 && first < 1);
    assert_int_equal(stltsa_phase_zero(other, 9, &second), STLTSA_E_ARGUMENT);
    stltsa_phase_free(other);
    stltsa_options_free(options);
    stltsa_clip_free(clip);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_results_have_the_same_cycles),
                                       cmocka_unit_test(the_phase_is_found_once),
                                       cmocka_unit_test(sines_have_equal_cycles),
                                       cmocka_unit_test(cycles_end_with_the_clip)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
