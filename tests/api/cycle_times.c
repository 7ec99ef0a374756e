/* SPDX-License-Identifier: BSD-3-Clause */
/* Lengths of cycles. */
#include "support.h"

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
        must(stltsa_phase_find(clip, d, NULL, &phase));
        stltsa_phase_free(phase);
        stltsa_decomposition_free(d);
        stltsa_clip_free(clip);
        free(x);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(sines_have_equal_cycles),
                                       cmocka_unit_test(cycles_end_with_the_clip)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
