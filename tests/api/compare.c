/* SPDX-License-Identifier: BSD-3-Clause */
/* Comparison of two motions by phase, through the public API. */
#include <string.h>

#include "support.h"

static const char* walker_path;

static const double turn = 6.283185307179586;

enum { columns = 6, samples = 101 };

/* A motion that repeats once per period; columns 0 and 3 have the same shape, and so do 1 and 4,
 * and 2 and 5. */
struct motion {
    double fps, period, seconds;
    double late;  /* share of the cycle: column 0 comes later, column 3 earlier */
    double gain;  /* of column 1 */
    double raise; /* of column 2 */
    double vary;  /* relative change of the amplitudes from cycle to cycle */
    int twice;    /* 1: everything has two like halves */
};

static const struct motion usual = {100, 1.1, 12, 0, 1, 0, 0.05, 0};

/* A different value for each cycle and column, from -1 to 1, that does not repeat. */
static double change(int cycle, int column) {
    return sin(12.9898 * (cycle + 1) + 78.233 * (column + 1));
}

static double value(const struct motion* of, double cycles, int column) {
    static const double first[] = {10, 8, 6}, second[] = {3, -2, 4}, quarter[] = {0, 0.3, 0.6};
    const int shape = column % 3;
    const double gain =
        (column == 1 ? of->gain : 1) * (1 + of->vary * change((int)floor(cycles), column));
    const double late = column == 0 ? of->late : column == 3 ? -of->late : 0;
    const double at = turn * (cycles - late + quarter[shape]) * (of->twice ? 2 : 1);
    const double high = of->twice ? 0.02 * cos(at / 2) : second[shape] * cos(2 * at);
    return 5.0 * column + (column == 2 ? of->raise : 0) + gain * (first[shape] * sin(at) + high);
}

static stltsa_phase* phase_of(const stltsa_clip* clip, const stltsa_options* options) {
    stltsa_decomposition* found = NULL;
    stltsa_phase* phase = NULL;
    must(stltsa_decompose(clip, options, &found));
    must(stltsa_phase_find(found, options, &phase));
    stltsa_decomposition_free(found);
    return phase;
}

static stltsa_phase* phase_of_motion(struct motion of) {
    const int64_t frames = (int64_t)(of.seconds * of.fps);
    double* values = new_matrix(frames, columns);
    for (int64_t i = 0; i < frames; ++i)
        for (int c = 0; c < columns; ++c)
            values[i * columns + c] = value(&of, (double)i / of.fps / of.period, c);
    const stltsa_in in = packed_in(values, frames, columns);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_matrix(&in, of.fps, &clip));
    stltsa_phase* phase = phase_of(clip, NULL);
    stltsa_clip_free(clip);
    free(values);
    return phase;
}

static stltsa_phase* phase_of_file(const char* stretch) {
    char path[4096];
    snprintf(path, sizeof path, "%s%s", walker_path, stretch);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(path, NULL, &clip));
    stltsa_phase* phase = phase_of(clip, NULL);
    stltsa_clip_free(clip);
    return phase;
}

static stltsa_comparison* compared(struct motion first, struct motion second) {
    stltsa_phase *one = phase_of_motion(first), *other = phase_of_motion(second);
    stltsa_comparison* comparison = NULL;
    must(stltsa_compare(one, -1, other, -1, samples, &comparison));
    stltsa_phase_free(one);
    stltsa_phase_free(other);
    return comparison;
}

static void comparing_can_be_cancelled(void** state) {
    (void)state;
    stltsa_phase* phase = phase_of_motion(usual);
    stltsa_options* options = NULL;
    stltsa_comparison* comparison = NULL;
    int32_t left = 0;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_progress(options, cancel_after, &left));
    assert_int_equal(stltsa_compare_with(phase, -1, phase, -1, samples, options, &comparison),
                     STLTSA_E_CANCELLED);
    assert_null(comparison);
    left = 1000;
    must(stltsa_compare_with(phase, -1, phase, -1, samples, options, &comparison));
    assert_in_range(left, 0, 999);
    stltsa_comparison_free(comparison);
    stltsa_options_free(options);
    stltsa_phase_free(phase);
}

/* Cancelled at the first call of the progress callback, the second, ... until it ends. */
static void comparing_left_and_right_can_be_cancelled(void** state) {
    (void)state;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    stltsa_phase* phase = phase_of(clip, NULL);
    stltsa_options* options = NULL;
    must(stltsa_options_new(&options));
    stltsa_comparison* comparison = NULL;
    int32_t cancelled = 0;
    for (;; ++cancelled) {
        int32_t left = cancelled;
        must(stltsa_options_set_progress(options, cancel_after, &left));
        const stltsa_status status =
            stltsa_compare_left_right(clip, phase, -1, samples, options, &comparison);
        if (status == STLTSA_OK)
            break;
        assert_int_equal(status, STLTSA_E_CANCELLED);
        assert_null(comparison);
        assert_true(cancelled < 1000);
    }
    assert_true(cancelled > 2);
    stltsa_comparison_free(comparison);
    stltsa_options_free(options);
    stltsa_phase_free(phase);
    stltsa_clip_free(clip);
}

static stltsa_compared_cycles cycles_of(const stltsa_comparison* comparison) {
    stltsa_compared_cycles cycles = {.size = sizeof cycles};
    must(stltsa_comparison_cycles(comparison, &cycles));
    return cycles;
}

static stltsa_compared_part part_of(const stltsa_comparison* comparison, int64_t index) {
    stltsa_compared_part part = {.size = sizeof part};
    must(stltsa_comparison_part(comparison, index, &part));
    return part;
}

static void a_motion_does_not_differ_from_itself(void** state) {
    (void)state;
    stltsa_comparison* same = compared(usual, usual);
    const stltsa_compared_cycles cycles = cycles_of(same);
    assert_true(cycles.first_count >= 8 && cycles.first_count == cycles.second_count);
    assert_int_equal(cycles.significant, 0);
    assert_int_equal(cycles.judged, 2 * columns);
    assert_int_equal(cycles.samples, samples);
    assert_true(cycles.sides == 0 && cycles.turn == 0 && isnan(cycles.size_ratio));
    assert_below(fabs(cycles.shift), 1e-9, "shift");
    assert_below(1 - cycles.likeness, 1e-9, "1 - likeness");
    assert_below(fabs(cycles.cycle_time.first - usual.period), 0.01, "cycle time");
    assert_below(fabs(cycles.first_per_minute - 60 / usual.period), 0.6, "per minute");
    assert_int_equal(stltsa_comparison_part_count(same), columns);
    assert_int_equal(stltsa_comparison_channel_count(same), columns);
    for (int p = 0; p < columns; ++p) {
        const stltsa_compared_part part = part_of(same, p);
        assert_below(part.rms, 1e-9, "rms");
        assert_true(part.chance > 1e-3);
        assert_below(fabs(part.lag.difference), 1e-9, "lag");
        assert_below(fabs(part.ratio - 1), 1e-9, "ratio");
        assert_true(part.lag.low < 0 && part.lag.high > 0);
        assert_true(part.ratio_low < 1 && part.ratio_high > 1);
    }
    stltsa_comparison_free(same);
}

/* Different tempo, frame rate and length; each change is found where it is, and nowhere else. */
static void known_differences_are_found(void** state) {
    (void)state;
    const struct motion second = {60, 1.4, 15, 0.02, 1.25, 2, 0.05, 0};
    stltsa_comparison* of = compared(usual, second);
    const stltsa_compared_cycles cycles = cycles_of(of);
    assert_below(fabs(cycles.cycle_time.difference - 0.3), 0.01, "cycle time");
    assert_int_equal(cycles.cycle_time.significant, 1);
    const double late[columns] = {0.02, 0, 0, -0.02, 0, 0}, gain[columns] = {1, 1.25, 1, 1, 1, 1};
    for (int p = 0; p < columns; ++p) {
        const stltsa_compared_part part = part_of(of, p);
        assert_int_equal(part.part, p);
        assert_below(fabs(part.lag.difference - late[p]), 0.004, "lag");
        assert_below(fabs(part.ratio - gain[p]), 0.05, "ratio");
        assert_true(part.lag.low <= part.lag.difference && part.lag.difference <= part.lag.high);
        assert_true(part.ratio_low <= gain[p] && gain[p] <= part.ratio_high);
        assert_true(part.lag.difference == part.lag.second - part.lag.first);
        const double cycle = (cycles.cycle_time.first + cycles.cycle_time.second) / 2;
        assert_below(fabs(part.lag_s - cycle * part.lag.difference), 1e-12, "lag in seconds");
        assert_true(part.lag_low_s <= part.lag_s && part.lag_s <= part.lag_high_s);
        assert_true(part.correlation > 0.99);
    }
    assert_true(part_of(of, 0).lag.significant && part_of(of, 3).lag.significant);
    assert_true(part_of(of, 1).amplitude.significant);
    assert_true(part_of(of, 2).mean.significant && part_of(of, 2).mean.low < 2 &&
                part_of(of, 2).mean.high > 2);
    stltsa_comparison_free(of);
}

/* If the second is compared with the first, every difference has the opposite sign. */
static void differences_change_sign(void** state) {
    (void)state;
    struct motion second = usual;
    second.late = 0.03;
    second.gain = 1.3;
    second.period = 1.3;
    stltsa_comparison *there = compared(usual, second), *back = compared(second, usual);
    assert_below(fabs(cycles_of(there).shift + cycles_of(back).shift), 2e-3, "shifts");
    for (int p = 0; p < columns; ++p) {
        const stltsa_compared_part a = part_of(there, p), b = part_of(back, p);
        assert_below(fabs(a.lag.difference + b.lag.difference), 1e-3, "lags");
        assert_below(fabs(a.ratio * b.ratio - 1), 1e-2, "ratios");
        assert_below(fabs(a.lag.standard_error / b.lag.standard_error - 1), 0.1, "errors");
    }
    stltsa_comparison_free(there);
    stltsa_comparison_free(back);
}

static void curves_are_given(void** state) {
    (void)state;
    struct motion second = usual;
    second.raise = 3;
    stltsa_comparison* of = compared(usual, second);
    enum { size = samples * columns };
    static double mean[2][size], sd[size], difference[size], error[size], margin[size];
    const stltsa_out to_mean[2] = {packed_out(mean[0], samples, columns),
                                   packed_out(mean[1], samples, columns)},
                     to_sd = packed_out(sd, samples, columns),
                     to_difference = packed_out(difference, samples, columns),
                     to_error = packed_out(error, samples, columns),
                     to_margin = packed_out(margin, samples, columns),
                     wrong = packed_out(sd, samples, columns - 1);
    must(stltsa_comparison_curves(of, 0, &to_mean[0], &to_sd));
    must(stltsa_comparison_curves(of, 1, &to_mean[1], NULL));
    must(stltsa_comparison_difference(of, &to_difference, &to_error, &to_margin));
    must(stltsa_comparison_difference(of, NULL, NULL, NULL));
    double raised = 0;
    for (int i = 0; i < size; ++i) {
        assert_true(difference[i] == mean[1][i] - mean[0][i]);
        assert_true(sd[i] > 0 && error[i] > 0 && margin[i] > 1.9 * error[i]);
        raised += i % columns == 2 ? difference[i] / samples : 0;
    }
    /* The lag is 0 but for rounding, so a sample at a border may be that of the other border. */
    assert_below(fabs(raised - 3), 1e-3, "mean difference");
    assert_int_equal(stltsa_comparison_curves(of, 2, &to_mean[0], NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_comparison_curves(of, 0, &wrong, NULL), STLTSA_E_SHAPE);
    stltsa_compared_part channel = {.size = sizeof channel};
    must(stltsa_comparison_channel(of, 2, &channel));
    assert_int_equal(channel.part, 2);
    assert_true(channel.mean.difference == part_of(of, 2).mean.difference);
    assert_string_equal(stltsa_comparison_channel_axis(of, 2), "");
    assert_int_equal(stltsa_comparison_channel(of, columns, &channel), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_comparison_part(of, -1, &channel), STLTSA_E_ARGUMENT);
    char* json = NULL;
    must(stltsa_comparison_json(of, &json));
    assert_non_null(strstr(json, "\"format\":\"stltsa-comparison/1\""));
    stltsa_free(json);
    stltsa_comparison_free(of);
}

/* Two halves that are nearly alike: either may be the first. */
static void a_doubtful_shift_is_said(void** state) {
    (void)state;
    stltsa_phase* phase = phase_of_motion(usual);
    struct motion twice = usual;
    twice.twice = 1;
    twice.vary = 0;
    twice.period = 2.2;
    stltsa_phase* other = phase_of_motion(twice);
    stltsa_comparison* of = NULL;
    must(stltsa_compare(other, 0, other, 0, samples, &of));
    const stltsa_compared_cycles cycles = cycles_of(of);
    if (cycles.cycle_time.first > 2) { /* else its halves were taken as the cycles */
        assert_true(cycles.runner_up > cycles.likeness - 0.1);
        assert_true(stltsa_comparison_warning_count(of) > 0);
    }
    stltsa_comparison_free(of);
    must(stltsa_compare(phase, 0, phase, 0, samples, &of));
    assert_int_equal(stltsa_comparison_warning_count(of), 0);
    assert_string_equal(stltsa_comparison_warning(of, 0), "");
    stltsa_comparison_free(of);
    stltsa_phase_free(phase);
    stltsa_phase_free(other);
}

/* f is where a is: the heading is that of the same points. */
static stltsa_phase* phase_of_points(const char* const* names, int64_t count, double scale,
                                     int up) {
    enum { frames = 900 };
    double* values = new_matrix(frames, 3 * count);
    for (int i = 0; i < frames; ++i)
        for (int64_t p = 0; p < count; ++p) {
            const double at = turn * i / 110.0;
            const double where = names[p][0] == 'f' ? 0 : (double)(names[p][0] - 'a');
            const double x = 0.1 * where + 0.3 * sin(at + where),
                         y = 0.2 * cos(where * 2) + 0.1 * cos(at + 2 * where),
                         z = 1 + 0.3 * where + 0.02 * sin(2 * at);
            const double xyz[3] = {x, y, z};
            for (int axis = 0; axis < 3; ++axis)
                values[(i * count + p) * 3 + (axis + up + 1) % 3] = scale * xyz[axis];
        }
    const stltsa_points points = {.size = sizeof points,
                                  .space = 3,
                                  .positions = packed_in(values, frames, 3 * count),
                                  .names = names,
                                  .fps = 100};
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_points(&points, NULL, &clip));
    stltsa_options* options = NULL;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_int(options, STLTSA_OPT_UP_AXIS, up + 1));
    stltsa_phase* phase = phase_of(clip, options);
    stltsa_options_free(options);
    stltsa_clip_free(clip);
    free(values);
    return phase;
}

/* Points with different names are left out; a different up axis, order or unit does no harm. */
static void common_points_are_compared(void** state) {
    (void)state;
    const char* const names[] = {"a", "b", "c", "d", "e"};
    const char* const fewer[] = {"e", "c", "f", "b", "d"};
    stltsa_phase *one = phase_of_points(names, 5, 1, 2), *other = phase_of_points(fewer, 5, 3, 1);
    stltsa_comparison* of = NULL;
    must(stltsa_compare(one, -1, other, -1, samples, &of));
    assert_int_equal(stltsa_comparison_part_count(of), 4);
    assert_int_equal(stltsa_comparison_left_out_count(of, 0), 1);
    assert_string_equal(stltsa_comparison_left_out(of, 0, 0), "a");
    assert_string_equal(stltsa_comparison_left_out(of, 1, 0), "f");
    assert_string_equal(stltsa_comparison_left_out(of, 1, 1), "");
    assert_int_equal(stltsa_comparison_left_out_count(of, 2), 0);
    assert_string_equal(stltsa_comparison_part_name(of, 0, 0), "b");
    assert_string_equal(stltsa_comparison_part_name(of, 1, 3), "e");
    assert_string_equal(stltsa_comparison_part_name(of, 2, 0), "");
    assert_string_equal(stltsa_comparison_channel_axis(of, 5), "z");
    const stltsa_compared_cycles cycles = cycles_of(of);
    assert_below(fabs(cycles.size_ratio - 3), 0.01, "size");
    assert_true(cycles.likeness > 0.99);
    for (int p = 0; p < 4; ++p) {
        assert_below(fabs(part_of(of, p).ratio - 3), 0.1, "ratio");
        assert_below(fabs(part_of(of, p).lag.difference), 0.01, "lag");
        double squares = 0;
        for (int axis = 0; axis < 3; ++axis) {
            stltsa_compared_part channel = {.size = sizeof channel};
            must(stltsa_comparison_channel(of, 3 * p + axis, &channel));
            assert_int_equal(channel.part, p);
            squares += channel.rms * channel.rms;
        }
        assert_below(fabs(sqrt(squares) / part_of(of, p).rms - 1), 1e-9, "rms of the channels");
    }
    assert_non_null(strstr(stltsa_comparison_warning(of, 0), "times as large"));
    stltsa_comparison_free(of);
    stltsa_phase_free(one);
    stltsa_phase_free(other);
}

static void left_and_right_are_compared(void** state) {
    (void)state;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    stltsa_phase* phase = phase_of(clip, NULL);
    stltsa_comparison* of = NULL;
    must(stltsa_compare_left_right(clip, phase, -1, samples, NULL, &of));
    const stltsa_compared_cycles cycles = cycles_of(of);
    assert_true(cycles.sides == 1 && cycles.shift == 0.5 && isnan(cycles.shift_error));
    assert_int_equal(cycles.first_count, cycles.second_count);
    for (int64_t p = 0; p < stltsa_comparison_part_count(of); ++p) {
        assert_memory_equal(stltsa_comparison_part_name(of, 0, p), "Left", 4);
        assert_memory_equal(stltsa_comparison_part_name(of, 1, p), "Right", 5);
        const stltsa_compared_part part = part_of(of, p);
        assert_below(part.rms, 0.1, "rms in cm");
        assert_below(fabs(part.lag.difference), 5e-3, "lag");
    }
    stltsa_comparison_free(of);

    stltsa_phase* matrix = phase_of_motion(usual);
    assert_int_equal(stltsa_compare_left_right(clip, matrix, 0, samples, NULL, &of),
                     STLTSA_E_ARGUMENT);
    assert_null(of);
    stltsa_phase_free(matrix);
    stltsa_phase_free(phase);
    stltsa_clip_free(clip);
}

static void errors_say_what_is_wrong(void** state) {
    (void)state;
    stltsa_phase *walk = phase_of_file(""), *standing = phase_of_file(":0-100"),
                 *matrix = phase_of_motion(usual);
    stltsa_comparison* of = NULL;
    assert_int_equal(stltsa_compare(walk, -1, standing, -1, samples, &of), STLTSA_E_NO_SUCH_PART);
    assert_non_null(strstr(stltsa_last_error(), "no cycles"));
    assert_int_equal(stltsa_compare(walk, 7, walk, -1, samples, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(walk, -1, walk, -2, samples, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(walk, -1, matrix, -1, samples, &of), STLTSA_E_SHAPE);
    assert_int_equal(stltsa_compare(walk, -1, walk, -1, 4, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(walk, -1, walk, -1, 1002, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(NULL, -1, walk, -1, samples, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(walk, -1, walk, -1, samples, NULL), STLTSA_E_ARGUMENT);
    assert_null(of);
    const char *const ours[] = {"a", "b", "c"}, *const theirs[] = {"u", "v", "w"};
    stltsa_phase *one = phase_of_points(ours, 3, 1, 2), *other = phase_of_points(theirs, 3, 1, 2);
    assert_int_equal(stltsa_compare(one, -1, other, -1, samples, &of), STLTSA_E_SHAPE);
    assert_non_null(strstr(stltsa_last_error(), "the first has a, b, c, the second u, v, w"));
    stltsa_compared_cycles cycles = {.size = sizeof cycles};
    assert_int_equal(stltsa_comparison_cycles(NULL, &cycles), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_comparison_part_count(NULL), 0);
    stltsa_comparison_free(NULL);
    stltsa_phase_free(one);
    stltsa_phase_free(other);
    stltsa_phase_free(walk);
    stltsa_phase_free(standing);
    stltsa_phase_free(matrix);
}

int main(int argc, char** argv) {
    if (argc != 2) {
        print_error("usage: %s WALK.BVH\n", argv[0]);
        return 2;
    }
    walker_path = argv[1];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_motion_does_not_differ_from_itself),
        cmocka_unit_test(known_differences_are_found),
        cmocka_unit_test(differences_change_sign),
        cmocka_unit_test(curves_are_given),
        cmocka_unit_test(a_doubtful_shift_is_said),
        cmocka_unit_test(common_points_are_compared),
        cmocka_unit_test(left_and_right_are_compared),
        cmocka_unit_test(comparing_can_be_cancelled),
        cmocka_unit_test(comparing_left_and_right_can_be_cancelled),
        cmocka_unit_test(errors_say_what_is_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
