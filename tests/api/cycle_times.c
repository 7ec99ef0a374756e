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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(sines_have_equal_cycles)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
