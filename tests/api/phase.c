/* SPDX-License-Identifier: BSD-3-Clause */
/* Phases of a clip's frames, and signals on 0 to 100 % of its cycles, through the public API. */
#include "support.h"

TEST(every_frame_of_a_cycle_has_a_phase) {
    struct walk w = walk_of(opened());
    double *values = array_of(w.phase, STLTSA_INFO_PHASE),
           *residual = array_of(w.phase, STLTSA_INFO_PHASE_RESIDUAL);
    int64_t* cycle = whole_of(w.phase, STLTSA_INFO_PHASE_CYCLE);
    int64_t inside = 0, next = 0;
    for (int64_t c = 0; c < count_of(w.found, STLTSA_INFO_CYCLE); ++c) {
        const stltsa_part part = cycle_at(w.found, c);
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
    assert_true(isnan(values[stltsa_clip_frames(w.clip) - 1]));
    assert_int_equal(count_of(w.phase, STLTSA_INFO_WARNING), 0);
}

/* A ramp shows the frame of each sample; a second signal is missing at one frame. */
TEST(signals_are_resampled_by_phase) {
    enum { samples = 101 };
    struct walk w = walk_of(opened());
    const int64_t frames = stltsa_clip_frames(w.clip);
    double* signals = new_matrix(frames, 2);
    for (int64_t i = 0; i < frames; ++i) {
        signals[2 * i] = (double)i;
        signals[2 * i + 1] = 1;
    }
    signals[2 * (frames / 2) + 1] = NAN;
    const stltsa_in in = packed_in(signals, frames, 2);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_resample(w.phase, 0, &in, samples, NULL, &cycles));
    const int64_t count = count_of(cycles, STLTSA_INFO_VALUES);
    assert_int_equal(count, count_of(w.found, STLTSA_INFO_CYCLE));
    const stltsa_info* info = stltsa_cycles_info(cycles);
    double *places = get_array(info, STLTSA_INFO_SAMPLE_FRAMES, 0),
           *warp = get_array(info, STLTSA_INFO_WARP, 0),
           *mean = get_array(info, STLTSA_INFO_MEAN, 0),
           *deviation = get_array(info, STLTSA_INFO_DEVIATION, 0),
           *total = get_array(info, STLTSA_INFO_DISTANCE, 0),
           *columns = get_array(info, STLTSA_INFO_COLUMN_DISTANCE, 0);
    for (int64_t c = 0; c < count; ++c) {
        double* values = get_array(info, STLTSA_INFO_VALUES, c);
        for (int s = 0; s < samples; ++s) {
            const double frame = places[c * samples + s];
            assert_below(fabs(values[(ptrdiff_t)2 * s] - frame), 1e-9, "value - frame");
            assert_true(s == 0 || frame > places[c * samples + s - 1]);
            assert_below(fabs(warp[c * samples + s]), 0.1, "warp");
        }
        /* A cycle ends where the next one begins. */
        if (c + 1 < count)
            assert_below(fabs(places[c * samples + 100] - places[(c + 1) * samples]), 1e-9, "gap");
        assert_below(fabs(columns[2 * c + 1]), 1e-12, "distance of a constant");
        assert_true(total[c] > 0);
    }
    assert_true(mean[1] == 1 && deviation[1] == 0);
    stltsa_cycles_free(cycles);
}

/* Plain linear time normalization, computed here. */
TEST(between_borders_time_is_linear) {
    enum { rows = 90, samples = 33, count = 3 };
    const double at[count + 1] = {3.25, 30, 51.5, 88.75};
    double* x = new_motion(rows, 2, 3);
    const stltsa_in in = packed_in(x, rows, 2), borders = packed_in(at, count + 1, 1);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_between(&borders, &in, samples, NULL, &cycles));
    assert_int_equal(count_of(cycles, STLTSA_INFO_VALUES), count);
    double mean[2 * samples] = {0};
    for (int c = 0; c < count; ++c) {
        double* each = get_array(stltsa_cycles_info(cycles), STLTSA_INFO_VALUES, c);
        for (int s = 0; s < samples; ++s) {
            const double place = at[c] + (at[c + 1] - at[c]) * s / (samples - 1);
            const int i = (int)place;
            for (int k = 0; k < 2; ++k) {
                const double before = x[2 * i + k], after = x[2 * (i + 1) + k];
                assert_below(fabs(each[2 * s + k] - (before + (place - i) * (after - before))),
                             1e-12, "linear time");
                mean[2 * s + k] += each[2 * s + k] / count;
            }
        }
    }
    double *found = array_of(cycles, STLTSA_INFO_MEAN), *warp = array_of(cycles, STLTSA_INFO_WARP);
    assert_below(largest_difference(found, mean, (int64_t)2 * samples), 1e-12, "mean");
    for (int i = 0; i < count * samples; ++i)
        assert_below(fabs(warp[i]), 1e-12, "warp of linear time");
    stltsa_cycles_free(cycles);
}

static stltsa_status resample(void* user, const stltsa_options* options) {
    const struct walk* w = user;
    const double at[] = {3, 30};
    double* signal = new_matrix(stltsa_clip_frames(w->clip), 1);
    const stltsa_in in = packed_in(signal, stltsa_clip_frames(w->clip), 1),
                    borders = packed_in(at, 2, 1);
    stltsa_cycles* cycles = NULL;
    stltsa_status status = stltsa_cycles_resample(w->phase, 0, &in, 5, options, &cycles);
    assert_true((cycles == NULL) == (status != STLTSA_OK));
    stltsa_cycles_free(cycles);
    if (status == STLTSA_OK) {
        status = stltsa_cycles_between(&borders, &in, 5, options, &cycles);
        assert_true((cycles == NULL) == (status != STLTSA_OK));
        stltsa_cycles_free(cycles);
    }
    return status;
}

TEST(resampling_can_be_cancelled) {
    struct walk w = walk_of(opened());
    assert_in_range(cancelled_calls(resample, &w), 2, 1000);
}

/* The distance of a group is the root of the sum of squares of its columns. */
TEST(groups_of_columns_have_distances) {
    struct walk w = walk_of(opened());
    const int64_t frames = stltsa_clip_frames(w.clip);
    enum { cols = 4 };
    double* signals = new_motion(frames, cols, 4);
    const stltsa_in in = packed_in(signals, frames, cols);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_resample(w.phase, 0, &in, 21, NULL, &cycles));
    const int64_t count = count_of(cycles, STLTSA_INFO_VALUES);
    double groups[8 * 2];
    const int64_t of[cols] = {1, 0, -1, 1}, bad[cols] = {0, -2, 0, 0},
                  none[cols] = {-1, -1, -1, -1};
    const stltsa_in of_column = list_in(of, cols), wrong = list_in(bad, cols),
                    empty = list_in(none, cols), few = list_in(of, cols - 1);
    const stltsa_out to_groups = packed_out(groups, count, 2);
    double* columns = array_of(cycles, STLTSA_INFO_COLUMN_DISTANCE);
    must(stltsa_cycles_group_distance(cycles, &of_column, &to_groups));
    for (int64_t k = 0; k < count; ++k) {
        const double* c = columns + cols * k;
        assert_below(fabs(groups[2 * k] - c[1]), 1e-12, "group of one column");
        assert_below(fabs(groups[2 * k + 1] - sqrt(c[0] * c[0] + c[3] * c[3])), 1e-12, "group");
    }
    assert_int_equal(stltsa_cycles_group_distance(cycles, &wrong, &to_groups), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_group_distance(cycles, &empty, &to_groups), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_group_distance(cycles, &few, &to_groups), STLTSA_E_SHAPE);
    assert_true(count_of(w.phase, STLTSA_INFO_OWNER) > 9);
    assert_string_not_equal(get_text(stltsa_phase_info(w.phase), STLTSA_INFO_OWNER, 3), "");
    stltsa_cycles_free(cycles);
}

/* A cycle may end with the last frame: what comes after the begin of that frame is unknown. */
TEST(the_last_border_may_be_the_end) {
    const double x[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, at[] = {0, 5, 10};
    const stltsa_in in = packed_in(x, 10, 1), borders = packed_in(at, 3, 1);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_between(&borders, &in, 6, NULL, &cycles));
    double *second = get_array(stltsa_cycles_info(cycles), STLTSA_INFO_VALUES, 1),
           *mean = array_of(cycles, STLTSA_INFO_MEAN);
    for (int s = 0; s < 5; ++s)
        assert_below(fabs(second[s] - (5 + s)), 1e-12, "second cycle");
    assert_true(isnan(second[5]));
    assert_below(fabs(mean[5] - 5), 1e-12, "mean of the first cycle alone");
    stltsa_cycles_free(cycles);
}

TEST(wrong_arguments_are_named) {
    struct walk w = walk_of(opened());
    const int64_t frames = stltsa_clip_frames(w.clip);
    double* signals = new_matrix(frames, 1);
    const stltsa_in in = packed_in(signals, frames, 1), few = packed_in(signals, 9, 1);
    stltsa_cycles* cycles = NULL;
    must_fail(stltsa_cycles_resample(w.phase, 5, &in, 101, NULL, &cycles), STLTSA_E_ARGUMENT,
              "label F has neither cycles nor repetitions");
    must_fail(stltsa_cycles_resample(w.phase, 0, &few, 101, NULL, &cycles), STLTSA_E_SHAPE,
              "signals has 9 rows");
    assert_int_equal(stltsa_cycles_resample(w.phase, 0, &in, 1, NULL, &cycles), STLTSA_E_ARGUMENT);
    const double falling[] = {3, 8, 8}, beyond[] = {3, 10}, unknown[] = {NAN, 3};
    const stltsa_in one = packed_in(falling, 1, 1), bad = packed_in(falling, 3, 1),
                    far = packed_in(beyond, 2, 1), none = packed_in(unknown, 2, 1);
    assert_int_equal(stltsa_cycles_between(&one, &few, 101, NULL, &cycles), STLTSA_E_ARGUMENT);
    must_fail(stltsa_cycles_between(&bad, &few, 101, NULL, &cycles), STLTSA_E_ARGUMENT, "border 2");
    assert_int_equal(stltsa_cycles_between(&far, &few, 101, NULL, &cycles), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_between(&none, &few, 101, NULL, &cycles), STLTSA_E_ARGUMENT);
    const stltsa_in wide = packed_in(beyond, 1, 2);
    must_fail(stltsa_cycles_between(&wide, &few, 101, NULL, &cycles), STLTSA_E_SHAPE,
              "borders has 2 columns");
    assert_null(cycles);
    stltsa_clip* part = NULL;
    must(stltsa_clip_stretch(w.clip, "10-200", NULL, &part));
    stltsa_comparison* sides = NULL;
    must_fail(stltsa_compare_left_right(part, w.phase, 0, 101, NULL, &sides), STLTSA_E_ARGUMENT,
              "the result belongs to another clip");
    assert_null(sides);
    stltsa_phase_free(NULL);
    stltsa_cycles_free(NULL);
    stltsa_clip_free(part);
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
    return keep_clip(clip);
}

/* Repetitions are compared at equal phases, as cycles are; but only frames of cycles have a phase.
 */
TEST(repetitions_are_resampled_by_phase) {
    enum { samples = 11 };
    struct walk w = walk_of(new_reaches());
    const int64_t frames = stltsa_clip_frames(w.clip),
                  count = count_of(w.found, STLTSA_INFO_REPETITION);
    assert_int_equal(count, 3);
    assert_int_equal(count_of(w.found, STLTSA_INFO_CYCLE), 0);
    double *values = array_of(w.phase, STLTSA_INFO_PHASE), *ramp = new_matrix(frames, 1);
    for (int64_t i = 0; i < frames; ++i) {
        ramp[i] = (double)i;
        assert_true(isnan(values[i]));
    }
    stltsa_cycles* cycles = NULL;
    const stltsa_in in = packed_in(ramp, frames, 1);
    must(stltsa_cycles_resample(w.phase, 0, &in, samples, NULL, &cycles));
    assert_int_equal(count_of(cycles, STLTSA_INFO_VALUES), count);
    double* resampled = array_of(cycles, STLTSA_INFO_SAMPLE_FRAMES);
    for (int64_t r = 0; r < count; ++r) {
        const stltsa_part part = repetition_at(w.found, r);
        /* Samples 3, 5 and 7: on the way, away, and on the way back, whatever the speed. */
        static const double away[] = {75, 180, 295}, length[] = {60, 60, 80};
        for (int s = 3; s <= 7; s += 2)
            assert_below(fabs(resampled[r * samples + s] - away[r] - (s - 5) / 10.0 * length[r]), 4,
                         "frame of a sample");
        assert_below(fabs(resampled[r * samples] - (double)part.begin), 8, "first frame");
    }
    stltsa_model* model = fitted_clip(w.clip, NULL);
    must_fail(stltsa_model_keep_cycle(model, w.phase, NULL), STLTSA_E_ARGUMENT,
              "the clip has no cycles");
    stltsa_cycles_free(cycles);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_frame_of_a_cycle_has_a_phase),
        cmocka_unit_test(signals_are_resampled_by_phase),
        cmocka_unit_test(resampling_can_be_cancelled),
        cmocka_unit_test(between_borders_time_is_linear),
        cmocka_unit_test(the_last_border_may_be_the_end),
        cmocka_unit_test(groups_of_columns_have_distances),
        cmocka_unit_test(repetitions_are_resampled_by_phase),
        cmocka_unit_test(wrong_arguments_are_named),
    };
    return run_on_walker(tests, argc, argv);
}
