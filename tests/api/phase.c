/* SPDX-License-Identifier: BSD-3-Clause */
/* Phases of a clip's frames, and signals on 0 to 100 % of its cycles, through the public API. */
#include "support.h"

static const char* walker_path;

typedef struct {
    stltsa_clip* clip;
    stltsa_decomposition* found;
    stltsa_phase* phase;
    int64_t frames;
} walk;

static walk opened(void) {
    walk w = {NULL, NULL, NULL, 0};
    must(stltsa_clip_open(walker_path, NULL, &w.clip));
    must(stltsa_decompose(w.clip, NULL, &w.found));
    must(stltsa_phase_find(w.found, NULL, &w.phase));
    w.frames = stltsa_clip_frames(w.clip);
    return w;
}

static void closed(walk w) {
    stltsa_phase_free(w.phase);
    stltsa_decomposition_free(w.found);
    stltsa_clip_free(w.clip);
}

static void every_frame_of_a_cycle_has_a_phase(void** state) {
    (void)state;
    walk w = opened();
    double *values = new_matrix(w.frames, 1), *residual = new_matrix(w.frames, 1);
    int64_t* cycle = malloc((size_t)w.frames * sizeof *cycle);
    const stltsa_out of_values = packed_out(values, w.frames, 1),
                     of_residual = packed_out(residual, w.frames, 1),
                     of_cycle = list_out(cycle, w.frames);
    must(stltsa_phase_values(w.phase, &of_values, &of_residual, &of_cycle));
    int64_t inside = 0, next = 0;
    for (int64_t c = 0; c < stltsa_decomposition_part_count(w.found, STLTSA_PART_CYCLE); ++c) {
        stltsa_part part;
        must(stltsa_decomposition_part(w.found, STLTSA_PART_CYCLE, c, &part));
        for (; next < part.begin; ++next)
            assert_true(isnan(values[next]) && isnan(residual[next]) && cycle[next] == -1);
        for (; next < part.end; ++next, ++inside) {
            assert_int_equal(cycle[next], c);
            assert_true(values[next] >= 0 && values[next] < 1);
            assert_below(residual[next], 0.5, "residual");
            if (next > part.begin) {
                const double step = values[next] - values[next - 1];
                assert_true(step - floor(step) > 0 && step - floor(step) < 0.1);
            }
        }
        /* Phase 0 is near the border. */
        const double off = fabs(values[part.begin] - nearbyint(values[part.begin]));
        assert_below(off, 0.15, "phase at a border");
    }
    assert_true(inside > 100);
    assert_true(isnan(values[w.frames - 1]));
    assert_int_equal(stltsa_phase_warning_count(w.phase), 0);
    assert_string_equal(stltsa_phase_warning(w.phase, 0), "");
    free(values);
    free(residual);
    free(cycle);
    closed(w);
}

static void an_array_of_another_size_is_left_alone(void** state) {
    (void)state;
    walk w = opened();
    double *values = new_matrix(w.frames, 1), *few = new_matrix(w.frames - 1, 1);
    const stltsa_out right = packed_out(values, w.frames, 1),
                     wrong = packed_out(few, w.frames - 1, 1);
    values[0] = 7;
    assert_int_equal(stltsa_phase_values(w.phase, &right, &wrong, NULL), STLTSA_E_SHAPE);
    assert_true(values[0] == 7);
    must(stltsa_phase_values(w.phase, NULL, NULL, NULL));
    assert_int_equal(stltsa_phase_values(NULL, NULL, NULL, NULL), STLTSA_E_ARGUMENT);
    free(values);
    free(few);
    closed(w);
}

/* A ramp shows the frame of each sample; a second signal is missing at one frame. */
static void signals_are_resampled_by_phase(void** state) {
    (void)state;
    enum { samples = 101 };
    walk w = opened();
    double* signals = new_matrix(w.frames, 2);
    for (int64_t i = 0; i < w.frames; ++i) {
        signals[2 * i] = (double)i;
        signals[2 * i + 1] = 1;
    }
    signals[2 * (w.frames / 2) + 1] = NAN;
    const stltsa_in in = packed_in(signals, w.frames, 2);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_resample(w.phase, 0, &in, samples, &cycles));
    const int64_t count = stltsa_cycles_count(cycles);
    assert_int_equal(count, stltsa_decomposition_part_count(w.found, STLTSA_PART_CYCLE));
    double *frames = new_matrix(count, samples), *warp = new_matrix(count, samples),
           *values = new_matrix(samples, 2), *mean = new_matrix(samples, 2),
           *deviation = new_matrix(samples, 2), *total = new_matrix(count, 1),
           *columns = new_matrix(count, 2);
    const stltsa_out to_frames = packed_out(frames, count, samples),
                     to_warp = packed_out(warp, count, samples),
                     to_values = packed_out(values, samples, 2),
                     to_mean = packed_out(mean, samples, 2),
                     to_deviation = packed_out(deviation, samples, 2),
                     to_total = packed_out(total, count, 1),
                     to_columns = packed_out(columns, count, 2);
    must(stltsa_cycles_times(cycles, &to_frames, &to_warp));
    must(stltsa_cycles_mean(cycles, &to_mean, &to_deviation));
    must(stltsa_cycles_distance(cycles, &to_total, &to_columns));
    for (int64_t c = 0; c < count; ++c) {
        must(stltsa_cycles_cycle(cycles, c, &to_values));
        for (int s = 0; s < samples; ++s) {
            const double frame = frames[c * samples + s];
            assert_below(fabs(values[(ptrdiff_t)2 * s] - frame), 1e-9, "value - frame");
            assert_true(s == 0 || frame > frames[c * samples + s - 1]);
            assert_below(fabs(warp[c * samples + s]), 0.1, "warp");
        }
        /* A cycle ends where the next one begins. */
        if (c + 1 < count)
            assert_below(fabs(frames[c * samples + 100] - frames[(c + 1) * samples]), 1e-9, "gap");
        assert_below(fabs(columns[2 * c + 1]), 1e-12, "distance of a constant");
        assert_true(total[c] > 0);
    }
    assert_true(mean[1] == 1 && deviation[1] == 0);
    assert_int_equal(stltsa_cycles_cycle(cycles, count, &to_values), STLTSA_E_ARGUMENT);
    stltsa_cycles_free(cycles);
    free(signals);
    free(frames);
    free(warp);
    free(values);
    free(mean);
    free(deviation);
    free(total);
    free(columns);
    closed(w);
}

/* Plain linear time normalization, computed here. */
static void between_borders_time_is_linear(void** state) {
    (void)state;
    enum { rows = 90, samples = 33, count = 3 };
    const double at[count + 1] = {3.25, 30, 51.5, 88.75};
    double* x = new_motion(rows, 2, 3);
    const stltsa_in in = packed_in(x, rows, 2), borders = packed_in(at, count + 1, 1);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_between(&borders, &in, samples, &cycles));
    assert_int_equal(stltsa_cycles_count(cycles), count);
    double mean[samples][2] = {{0}}, each[count][samples][2];
    for (int c = 0; c < count; ++c) {
        const stltsa_out to = packed_out(&each[c][0][0], samples, 2);
        must(stltsa_cycles_cycle(cycles, c, &to));
        for (int s = 0; s < samples; ++s) {
            const double place = at[c] + (at[c + 1] - at[c]) * s / (samples - 1);
            const int i = (int)place;
            for (int k = 0; k < 2; ++k) {
                const double before = x[2 * i + k], after = x[2 * (i + 1) + k];
                assert_below(fabs(each[c][s][k] - (before + (place - i) * (after - before))), 1e-12,
                             "linear time");
                mean[s][k] += each[c][s][k] / count;
            }
        }
    }
    double found[samples][2], warp[count][samples];
    const stltsa_out to_mean = packed_out(&found[0][0], samples, 2),
                     to_warp = packed_out(&warp[0][0], count, samples);
    must(stltsa_cycles_mean(cycles, &to_mean, NULL));
    must(stltsa_cycles_times(cycles, NULL, &to_warp));
    assert_below(largest_difference(&found[0][0], &mean[0][0], (int64_t)2 * samples), 1e-12,
                 "mean");
    for (int c = 0; c < count; ++c)
        for (int s = 0; s < samples; ++s)
            assert_below(fabs(warp[c][s]), 1e-12, "warp of linear time");
    stltsa_cycles_free(cycles);
    free(x);
}

/* The distance of a group is the root of the sum of squares of its columns. */
static void groups_of_columns_have_distances(void** state) {
    (void)state;
    walk w = opened();
    enum { cols = 4 };
    double* signals = new_motion(w.frames, cols, 4);
    const stltsa_in in = packed_in(signals, w.frames, cols);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_resample(w.phase, 0, &in, 21, &cycles));
    const int64_t count = stltsa_cycles_count(cycles);
    double columns[8 * cols], groups[8 * 2];
    const int64_t of[cols] = {1, 0, -1, 1}, bad[cols] = {0, -2, 0, 0},
                  none[cols] = {-1, -1, -1, -1};
    const stltsa_in of_column = list_in(of, cols), wrong = list_in(bad, cols),
                    empty = list_in(none, cols), few = list_in(of, cols - 1);
    const stltsa_out to_columns = packed_out(columns, count, cols),
                     to_groups = packed_out(groups, count, 2);
    must(stltsa_cycles_distance(cycles, NULL, &to_columns));
    must(stltsa_cycles_group_distance(cycles, &of_column, &to_groups));
    for (int64_t k = 0; k < count; ++k) {
        const double* c = columns + cols * k;
        assert_below(fabs(groups[2 * k] - c[1]), 1e-12, "group of one column");
        assert_below(fabs(groups[2 * k + 1] - sqrt(c[0] * c[0] + c[3] * c[3])), 1e-12, "group");
    }
    assert_int_equal(stltsa_cycles_group_distance(cycles, &wrong, &to_groups), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_group_distance(cycles, &empty, &to_groups), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_group_distance(cycles, &few, &to_groups), STLTSA_E_SHAPE);
    assert_true(stltsa_phase_column_count(w.phase) > 9);
    assert_string_not_equal(stltsa_phase_column_owner(w.phase, 3), "");
    assert_string_equal(stltsa_phase_column_owner(w.phase, -1), "");
    assert_int_equal(stltsa_phase_column_count(NULL), 0);
    stltsa_cycles_free(cycles);
    free(signals);
    closed(w);
}

/* A cycle may end with the last frame: what comes after the begin of that frame is unknown. */
static void the_last_border_may_be_the_end(void** state) {
    (void)state;
    const double x[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, at[] = {0, 5, 10};
    const stltsa_in in = packed_in(x, 10, 1), borders = packed_in(at, 3, 1);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_between(&borders, &in, 6, &cycles));
    double second[6], mean[6];
    const stltsa_out to_second = packed_out(second, 6, 1), to_mean = packed_out(mean, 6, 1);
    must(stltsa_cycles_cycle(cycles, 1, &to_second));
    must(stltsa_cycles_mean(cycles, &to_mean, NULL));
    for (int s = 0; s < 5; ++s)
        assert_below(fabs(second[s] - (5 + s)), 1e-12, "second cycle");
    assert_true(isnan(second[5]));
    assert_below(fabs(mean[5] - 5), 1e-12, "mean of the first cycle alone");
    stltsa_cycles_free(cycles);
}

static void wrong_arguments_are_named(void** state) {
    (void)state;
    walk w = opened();
    double* signals = new_matrix(w.frames, 1);
    const stltsa_in in = packed_in(signals, w.frames, 1), few = packed_in(signals, 9, 1);
    stltsa_cycles* cycles = NULL;
    assert_int_equal(stltsa_cycles_resample(w.phase, 5, &in, 101, &cycles), STLTSA_E_ARGUMENT);
    assert_non_null(strstr(stltsa_last_error(), "label F has neither cycles nor repetitions"));
    assert_int_equal(stltsa_cycles_resample(w.phase, 0, &few, 101, &cycles), STLTSA_E_SHAPE);
    assert_non_null(strstr(stltsa_last_error(), "signals has 9 rows"));
    assert_int_equal(stltsa_cycles_resample(w.phase, 0, &in, 1, &cycles), STLTSA_E_ARGUMENT);
    const double falling[] = {3, 8, 8}, beyond[] = {3, 10}, unknown[] = {NAN, 3};
    const stltsa_in one = packed_in(falling, 1, 1), bad = packed_in(falling, 3, 1),
                    far = packed_in(beyond, 2, 1), none = packed_in(unknown, 2, 1);
    assert_int_equal(stltsa_cycles_between(&one, &few, 101, &cycles), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_between(&bad, &few, 101, &cycles), STLTSA_E_ARGUMENT);
    assert_non_null(strstr(stltsa_last_error(), "border 2"));
    assert_int_equal(stltsa_cycles_between(&far, &few, 101, &cycles), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_between(&none, &few, 101, &cycles), STLTSA_E_ARGUMENT);
    const stltsa_in wide = packed_in(beyond, 1, 2);
    assert_int_equal(stltsa_cycles_between(&wide, &few, 101, &cycles), STLTSA_E_SHAPE);
    assert_non_null(strstr(stltsa_last_error(), "borders has 2 columns"));
    assert_null(cycles);
    stltsa_clip* part = NULL;
    char* name = malloc(strlen(walker_path) + 16);
    strcat(strcpy(name, walker_path), ":10-200");
    must(stltsa_clip_open(name, NULL, &part));
    stltsa_comparison* sides = NULL;
    assert_int_equal(stltsa_compare_left_right(part, w.phase, 0, 101, NULL, &sides),
                     STLTSA_E_ARGUMENT);
    assert_non_null(strstr(stltsa_last_error(), "the result belongs to another clip"));
    assert_null(sides);
    stltsa_phase_free(NULL);
    stltsa_cycles_free(NULL);
    assert_int_equal(stltsa_cycles_count(NULL), 0);
    free(name);
    free(signals);
    stltsa_clip_free(part);
    closed(w);
}

/* A hand that goes away and back three times, at two speeds, with rests; three markers. */
static stltsa_clip* new_reaches(void) {
    enum { fps = 30, cols = 9 };
    static const int lengths[] = {60, 60, 80}, rest = 45;
    const int64_t frames = 60 + 60 + 80 + 4 * rest;
    double* values = new_matrix(frames, cols);
    int64_t at = rest;
    for (int r = 0; r < 3; ++r, at += rest)
        for (int i = 0; i < lengths[r]; ++i, ++at) {
            const double turn = 2 * pi * i / lengths[r], away = (1 - cos(turn)) / 2;
            values[at * cols] = 0.6 * away;
            values[at * cols + 1] = 0.3 * away * sin(turn);
            values[at * cols + 3] = 0.2 * away * away;
        }
    uint64_t seed = 1;
    for (int64_t i = 0; i < frames; ++i) {
        values[i * cols + 4] += 1; /* markers 1 and 2 are elsewhere */
        values[i * cols + 8] += 2;
        for (int c = 0; c < cols; ++c)
            values[i * cols + c] += 0.0005 * (uniform(&seed) - 0.5);
    }
    const char* const names[] = {"hand", "elbow", "head"};
    stltsa_points points = {.size = sizeof points, .space = 3, .names = names, .fps = fps};
    points.positions = packed_in(values, frames, cols);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_points(&points, NULL, &clip));
    free(values);
    return clip;
}

/* Repetitions are compared at equal phases, as cycles are; but only frames of cycles have a phase.
 */
static void repetitions_are_resampled_by_phase(void** state) {
    (void)state;
    enum { samples = 11 };
    walk w = {new_reaches(), NULL, NULL, 0};
    must(stltsa_decompose(w.clip, NULL, &w.found));
    must(stltsa_phase_find(w.found, NULL, &w.phase));
    w.frames = stltsa_clip_frames(w.clip);
    const int64_t count = stltsa_decomposition_part_count(w.found, STLTSA_PART_REPETITION);
    assert_int_equal(count, 3);
    assert_int_equal(stltsa_decomposition_cycle_count(w.found), 0);
    double *values = new_matrix(w.frames, 1), *ramp = new_matrix(w.frames, 1);
    const stltsa_out of_values = packed_out(values, w.frames, 1);
    must(stltsa_phase_values(w.phase, &of_values, NULL, NULL));
    for (int64_t i = 0; i < w.frames; ++i) {
        ramp[i] = (double)i;
        assert_true(isnan(values[i]));
    }
    stltsa_cycles* cycles = NULL;
    const stltsa_in in = packed_in(ramp, w.frames, 1);
    must(stltsa_cycles_resample(w.phase, 0, &in, samples, &cycles));
    assert_int_equal(stltsa_cycles_count(cycles), count);
    double* resampled = new_matrix(count, samples);
    const stltsa_out out = packed_out(resampled, count, samples);
    must(stltsa_cycles_times(cycles, &out, NULL));
    for (int64_t r = 0; r < count; ++r) {
        stltsa_part part;
        must(stltsa_decomposition_part(w.found, STLTSA_PART_REPETITION, r, &part));
        /* Samples 3, 5 and 7: on the way, away, and on the way back, whatever the speed. */
        static const double away[] = {75, 180, 295}, length[] = {60, 60, 80};
        for (int s = 3; s <= 7; s += 2)
            assert_below(fabs(resampled[r * samples + s] - away[r] - (s - 5) / 10.0 * length[r]), 4,
                         "frame of a sample");
        assert_below(fabs(resampled[r * samples] - (double)part.begin), 8, "first frame");
    }
    stltsa_model* model = NULL;
    must(stltsa_fit_clip(w.clip, NULL, &model));
    assert_int_equal(stltsa_model_keep_cycle(model, w.phase), STLTSA_E_ARGUMENT);
    assert_non_null(strstr(stltsa_last_error(), "the clip has no cycles"));
    stltsa_model_free(model);
    stltsa_cycles_free(cycles);
    free(resampled);
    free(ramp);
    free(values);
    closed(w);
}

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    walker_path = argv[1];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_frame_of_a_cycle_has_a_phase),
        cmocka_unit_test(an_array_of_another_size_is_left_alone),
        cmocka_unit_test(signals_are_resampled_by_phase),
        cmocka_unit_test(between_borders_time_is_linear),
        cmocka_unit_test(the_last_border_may_be_the_end),
        cmocka_unit_test(groups_of_columns_have_distances),
        cmocka_unit_test(repetitions_are_resampled_by_phase),
        cmocka_unit_test(wrong_arguments_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
