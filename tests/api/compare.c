/* SPDX-License-Identifier: BSD-3-Clause */
/* Comparison of two motions by phase, through the public API. */
#include <string.h>

#include "support.h"

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

static stltsa_phase* phase_of_motion(struct motion of) {
    const int64_t frames = (int64_t)(of.seconds * of.fps);
    double* values = new_matrix(frames, columns);
    for (int64_t i = 0; i < frames; ++i)
        for (int c = 0; c < columns; ++c)
            values[i * columns + c] = value(&of, (double)i / of.fps / of.period, c);
    stltsa_clip* clip = matrix_clip(values, frames, columns, of.fps);
    stltsa_phase* phase = phase_of(clip, NULL);
    return phase;
}

static stltsa_comparison* compared(struct motion first, struct motion second) {
    stltsa_phase *one = phase_of_motion(first), *other = phase_of_motion(second);
    stltsa_comparison* comparison = NULL;
    must(stltsa_compare(one, -1, other, -1, samples, NULL, &comparison));
    return keep_comparison(comparison);
}

static stltsa_status compare(void* phase, const stltsa_options* options) {
    stltsa_comparison* comparison = NULL;
    const stltsa_status status =
        stltsa_compare(phase, -1, phase, -1, samples, options, &comparison);
    assert_true((comparison == NULL) == (status != STLTSA_OK));
    stltsa_comparison_free(comparison);
    return status;
}

struct sides {
    stltsa_clip* clip;
    stltsa_phase* phase;
};

static stltsa_status compare_sides(void* user, const stltsa_options* options) {
    const struct sides* of = user;
    stltsa_comparison* comparison = NULL;
    const stltsa_status status =
        stltsa_compare_left_right(of->clip, of->phase, -1, samples, options, &comparison);
    assert_true((comparison == NULL) == (status != STLTSA_OK));
    stltsa_comparison_free(comparison);
    return status;
}

TEST(comparing_can_be_cancelled) {
    stltsa_phase* phase = phase_of_motion(usual);
    assert_in_range(cancelled_calls(compare, phase), 1, 1000);
    struct sides of = {opened(), NULL};
    of.phase = phase_of(of.clip, NULL);
    assert_in_range(cancelled_calls(compare_sides, &of), 3, 1000);
}

TEST(a_motion_does_not_differ_from_itself) {
    stltsa_comparison* same = compared(usual, usual);
    const stltsa_compared cycles = compared_of(same);
    assert_true(motion_at(same, 0).cycles >= 8 &&
                motion_at(same, 0).cycles == motion_at(same, 1).cycles);
    assert_int_equal(cycles.significant, 0);
    assert_int_equal(cycles.judged, 2 * columns);
    assert_int_equal(cycles.samples, samples);
    assert_true(cycles.sides == 0 && cycles.turn_deg == 0 && isnan(cycles.size_ratio));
    assert_below(fabs(cycles.shift), 1e-9, "shift");
    assert_below(1 - cycles.likeness, 1e-9, "1 - likeness");
    assert_below(fabs(cycles.cycle_time_s.first - usual.period), 0.01, "cycle time");
    assert_below(fabs(motion_at(same, 0).cycles_per_min - 60 / usual.period), 0.6, "per minute");
    assert_int_equal(count_of(same, STLTSA_INFO_PART), columns);
    assert_int_equal(count_of(same, STLTSA_INFO_PART_CHANNEL), columns);
    for (int p = 0; p < columns; ++p) {
        const stltsa_compared_part part = part_at(same, p);
        assert_below(part.rms_difference, 1e-9, "rms");
        assert_true(part.rms_by_chance > 1e-3);
        assert_below(fabs(part.lag.difference), 1e-9, "lag");
        assert_below(fabs(part.amplitude_ratio.value - 1), 1e-9, "ratio");
        assert_true(part.lag.low < 0 && part.lag.high > 0);
        assert_true(part.amplitude_ratio.low < 1 && part.amplitude_ratio.high > 1);
    }
}

/* Different tempo, frame rate and length; each change is found where it is, and nowhere else. */
TEST(known_differences_are_found) {
    const struct motion second = {60, 1.4, 15, 0.02, 1.25, 2, 0.05, 0};
    stltsa_comparison* of = compared(usual, second);
    const stltsa_compared cycles = compared_of(of);
    assert_below(fabs(cycles.cycle_time_s.difference - 0.3), 0.01, "cycle time");
    assert_int_equal(cycles.cycle_time_s.significant, 1);
    const double late[columns] = {0.02, 0, 0, -0.02, 0, 0}, gain[columns] = {1, 1.25, 1, 1, 1, 1};
    for (int p = 0; p < columns; ++p) {
        const stltsa_compared_part part = part_at(of, p);
        assert_int_equal(part.part, p);
        assert_below(fabs(part.lag.difference - late[p]), 0.004, "lag");
        assert_below(fabs(part.amplitude_ratio.value - gain[p]), 0.05, "ratio");
        assert_true(part.lag.low <= part.lag.difference && part.lag.difference <= part.lag.high);
        assert_true(part.amplitude_ratio.low <= gain[p] && gain[p] <= part.amplitude_ratio.high);
        assert_true(part.lag.difference == part.lag.second - part.lag.first);
        const double cycle = (cycles.cycle_time_s.first + cycles.cycle_time_s.second) / 2;
        assert_below(fabs(part.lag_s.value - cycle * part.lag.difference), 1e-12, "lag in seconds");
        assert_true(part.lag_s.low <= part.lag_s.value && part.lag_s.value <= part.lag_s.high);
        assert_true(part.correlation > 0.99);
    }
    assert_true(part_at(of, 0).lag.significant && part_at(of, 3).lag.significant);
    assert_true(part_at(of, 1).amplitude.significant);
    assert_true(part_at(of, 2).mean.significant && part_at(of, 2).mean.low < 2 &&
                part_at(of, 2).mean.high > 2);
}

/* If the second is compared with the first, every difference has the opposite sign. */
TEST(differences_change_sign) {
    struct motion second = usual;
    second.late = 0.03;
    second.gain = 1.3;
    second.period = 1.3;
    stltsa_comparison *there = compared(usual, second), *back = compared(second, usual);
    assert_below(fabs(compared_of(there).shift + compared_of(back).shift), 2e-3, "shifts");
    for (int p = 0; p < columns; ++p) {
        const stltsa_compared_part a = part_at(there, p), b = part_at(back, p);
        assert_below(fabs(a.lag.difference + b.lag.difference), 1e-3, "lags");
        assert_below(fabs(a.amplitude_ratio.value * b.amplitude_ratio.value - 1), 1e-2, "ratios");
        assert_below(fabs(a.lag.standard_error / b.lag.standard_error - 1), 0.1, "errors");
    }
}

TEST(curves_are_given) {
    struct motion second = usual;
    second.raise = 3;
    stltsa_comparison* of = compared(usual, second);
    const stltsa_info* info = stltsa_comparison_info(of);
    double *mean[2] = {get_array(info, STLTSA_INFO_MEAN, 0), get_array(info, STLTSA_INFO_MEAN, 1)},
           *sd = get_array(info, STLTSA_INFO_DEVIATION, 1),
           *difference = get_array(info, STLTSA_INFO_DIFFERENCE, 0),
           *error = get_array(info, STLTSA_INFO_STANDARD_ERROR, 0),
           *margin = get_array(info, STLTSA_INFO_MARGIN, 0);
    double raised = 0;
    for (int i = 0; i < samples * columns; ++i) {
        assert_true(difference[i] == mean[1][i] - mean[0][i]);
        assert_true(sd[i] > 0 && error[i] > 0 && margin[i] > 1.9 * error[i]);
        raised += i % columns == 2 ? difference[i] / samples : 0;
    }
    /* The lag is 0 but for rounding, so a sample at a border may be that of the other border. */
    assert_below(fabs(raised - 3), 1e-3, "mean difference");
    const stltsa_compared_part channel = channel_at(of, 2);
    assert_int_equal(channel.part, 2);
    assert_true(channel.mean.difference == part_at(of, 2).mean.difference);
    assert_string_equal(channel.axis, "");
}

/* Two halves that are nearly alike: either may be the first. */
TEST(a_doubtful_shift_is_said) {
    stltsa_phase* phase = phase_of_motion(usual);
    struct motion twice = usual;
    twice.twice = 1;
    twice.vary = 0;
    twice.period = 2.2;
    stltsa_phase* other = phase_of_motion(twice);
    stltsa_comparison* of = NULL;
    must(stltsa_compare(other, 0, other, 0, samples, NULL, &of));
    const stltsa_compared cycles = compared_of(of);
    if (cycles.cycle_time_s.first > 2) { /* else its halves were taken as the cycles */
        assert_true(cycles.runner_up > cycles.likeness - 0.1);
        assert_true(count_of(of, STLTSA_INFO_WARNING) > 0);
    }
    stltsa_comparison_free(of);
    must(stltsa_compare(phase, 0, phase, 0, samples, NULL, &of));
    assert_int_equal(count_of(of, STLTSA_INFO_WARNING), 0);
    stltsa_comparison_free(of);
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
    stltsa_options* options = with_int(STLTSA_OPT_UP_AXIS, up + 1);
    stltsa_phase* phase = phase_of(clip, options);
    stltsa_clip_free(clip);
    return phase;
}

/* Points with different names are left out; a different up axis, order or unit does no harm. */
TEST(common_points_are_compared) {
    const char* const names[] = {"a", "b", "c", "d", "e"};
    const char* const fewer[] = {"e", "c", "f", "b", "d"};
    stltsa_phase *one = phase_of_points(names, 5, 1, 2), *other = phase_of_points(fewer, 5, 3, 1);
    stltsa_comparison* of = NULL;
    must(stltsa_compare(one, -1, other, -1, samples, NULL, &of));
    assert_int_equal(count_of(of, STLTSA_INFO_PART), 4);
    const stltsa_compared_motion first = motion_at(of, 0), second = motion_at(of, 1);
    assert_string_equal(first.left_out[0], "a");
    assert_string_equal(second.left_out[0], "f");
    assert_null(first.left_out[1]);
    assert_null(second.left_out[1]);
    assert_string_equal(part_at(of, 0).first, "b");
    assert_string_equal(part_at(of, 3).second, "e");
    assert_string_equal(part_at(of, 0).axis, "");
    assert_string_equal(channel_at(of, 5).axis, "z");
    const stltsa_compared cycles = compared_of(of);
    assert_below(fabs(cycles.size_ratio - 3), 0.01, "size");
    assert_true(cycles.likeness > 0.99);
    for (int p = 0; p < 4; ++p) {
        assert_below(fabs(part_at(of, p).amplitude_ratio.value - 3), 0.1, "ratio");
        assert_below(fabs(part_at(of, p).lag.difference), 0.01, "lag");
        double squares = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const stltsa_compared_part channel = channel_at(of, 3 * p + axis);
            assert_int_equal(channel.part, p);
            squares += channel.rms_difference * channel.rms_difference;
        }
        assert_below(fabs(sqrt(squares) / part_at(of, p).rms_difference - 1), 1e-9,
                     "rms of the channels");
    }
    assert_int_equal(warnings_of(of, "times as large"), 1);
    stltsa_comparison_free(of);
}

TEST(left_and_right_are_compared) {
    stltsa_clip* clip = opened();
    stltsa_phase* phase = phase_of(clip, NULL);
    stltsa_comparison* of = NULL;
    must(stltsa_compare_left_right(clip, phase, -1, samples, NULL, &of));
    const stltsa_compared cycles = compared_of(of);
    assert_true(cycles.sides == 1 && cycles.shift == 0.5 && isnan(cycles.shift_error));
    assert_int_equal(motion_at(of, 0).cycles, motion_at(of, 1).cycles);
    for (int64_t p = 0; p < count_of(of, STLTSA_INFO_PART); ++p) {
        const stltsa_compared_part part = part_at(of, p);
        assert_memory_equal(part.first, "Left", 4);
        assert_memory_equal(part.second, "Right", 5);
        assert_below(part.rms_difference, 0.1, "rms in cm");
        assert_below(fabs(part.lag.difference), 5e-3, "lag");
    }
    stltsa_comparison_free(of);

    stltsa_phase* matrix = phase_of_motion(usual);
    assert_int_equal(stltsa_compare_left_right(clip, matrix, 0, samples, NULL, &of),
                     STLTSA_E_ARGUMENT);
    assert_null(of);
}

TEST(errors_say_what_is_wrong) {
    stltsa_clip *clip = opened(), *still = NULL;
    must(stltsa_clip_stretch(clip, "0-100", NULL, &still));
    stltsa_phase *walk = phase_of(clip, NULL), *standing = phase_of(still, NULL),
                 *matrix = phase_of_motion(usual);
    stltsa_clip_free(still);
    stltsa_comparison* of = NULL;
    must_fail(stltsa_compare(walk, -1, standing, -1, samples, NULL, &of), STLTSA_E_NO_SUCH_PART,
              "no cycles");
    assert_int_equal(stltsa_compare(walk, 7, walk, -1, samples, NULL, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(walk, -1, walk, -2, samples, NULL, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(walk, -1, matrix, -1, samples, NULL, &of), STLTSA_E_SHAPE);
    assert_int_equal(stltsa_compare(walk, -1, walk, -1, 4, NULL, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(walk, -1, walk, -1, 1002, NULL, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(NULL, -1, walk, -1, samples, NULL, &of), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare(walk, -1, walk, -1, samples, NULL, NULL), STLTSA_E_ARGUMENT);
    assert_null(of);
    const char *const ours[] = {"a", "b", "c"}, *const theirs[] = {"u", "v", "w"};
    stltsa_phase *one = phase_of_points(ours, 3, 1, 2), *other = phase_of_points(theirs, 3, 1, 2);
    must_fail(stltsa_compare(one, -1, other, -1, samples, NULL, &of), STLTSA_E_SHAPE,
              "the first has a, b, c, the second u, v, w");
    stltsa_comparison_free(NULL);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_motion_does_not_differ_from_itself),
        cmocka_unit_test(known_differences_are_found),
        cmocka_unit_test(differences_change_sign),
        cmocka_unit_test(curves_are_given),
        cmocka_unit_test(a_doubtful_shift_is_said),
        cmocka_unit_test(common_points_are_compared),
        cmocka_unit_test(left_and_right_are_compared),
        cmocka_unit_test(comparing_can_be_cancelled),
        cmocka_unit_test(errors_say_what_is_wrong),
    };
    return run_on_walker(tests, argc, argv);
}
