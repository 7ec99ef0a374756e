/* SPDX-License-Identifier: BSD-3-Clause */
/* Comparison of left and right over a cycle, through the public API. */
#include <string.h>

#include "support.h"

static const char* walker_path;

static const double turn = 6.283185307179586;

enum { period = 100, cycles_of_signals = 4, frames_of_signals = period * cycles_of_signals + 1 };

static stltsa_compared_part channel_of(const stltsa_comparison* comparison, int64_t index) {
    stltsa_compared_part channel = {.size = sizeof channel};
    must(stltsa_comparison_channel(comparison, index, &channel));
    return channel;
}

/* A swing of both knees; the right one is scaled, raised, and late by a share of the cycle. */
static stltsa_cycles* knees(double gain, double raised, double late, int64_t samples) {
    double signals[3 * frames_of_signals], borders[cycles_of_signals + 1];
    for (int i = 0; i < frames_of_signals; ++i) {
        const double at = (double)i / period;
        signals[3 * i] = raised + gain * sin(turn * (at - 0.5 - late)) +
                         gain * 0.4 * cos(2 * turn * (at - 0.5 - late));
        signals[3 * i + 1] = 7; /* belongs to no side */
        signals[3 * i + 2] = sin(turn * at) + 0.4 * cos(2 * turn * at);
    }
    for (int c = 0; c <= cycles_of_signals; ++c)
        borders[c] = period * c;
    const stltsa_in in = packed_in(signals, frames_of_signals, 3),
                    at = packed_in(borders, cycles_of_signals + 1, 1);
    stltsa_cycles* cycles = NULL;
    must(stltsa_cycles_between(&at, &in, samples, &cycles));
    return cycles;
}

static stltsa_comparison* compared_knees(double gain, double raised, double late) {
    const char* const names[] = {"knee_r", "trunk", "knee_l"};
    stltsa_cycles* cycles = knees(gain, raised, late, 101);
    stltsa_comparison* comparison = NULL;
    must(stltsa_cycles_compare_left_right(cycles, names, period, NULL, &comparison));
    stltsa_cycles_free(cycles);
    assert_int_equal(stltsa_comparison_part_count(comparison), 1);
    assert_string_equal(stltsa_comparison_part_name(comparison, 0, 0), "knee_l");
    assert_string_equal(stltsa_comparison_part_name(comparison, 1, 0), "knee_r");
    return comparison;
}

static void like_sides_differ_by_nothing(void** state) {
    (void)state;
    stltsa_comparison* comparison = compared_knees(1, 0, 0);
    const stltsa_compared_part channel = channel_of(comparison, 0);
    assert_below(channel.rms, 1e-12, "rms");
    assert_below(channel.chance, 1e-12, "chance");
    assert_below(fabs(channel.mean.difference), 1e-12, "mean");
    assert_below(fabs(channel.amplitude.difference), 1e-12, "ranges");
    assert_below(fabs(channel.lag.difference), 1e-9, "lag");
    assert_below(1 - channel.correlation, 1e-9, "1 - correlation");
    stltsa_comparison_free(comparison);
}

/* No cycle is lost by the half that the right side is later. */
static void known_differences_are_found(void** state) {
    (void)state;
    stltsa_comparison* comparison = compared_knees(0.8, 0.1, 0.031);
    const stltsa_compared_part channel = channel_of(comparison, 0);
    assert_below(fabs(channel.mean.difference - 0.1), 1e-9, "mean");
    assert_below(fabs(channel.ratio - 0.8), 1e-3, "ratio");
    assert_below(fabs(channel.lag.difference - 0.031), 2e-4, "lag");
    assert_below(1 - channel.correlation, 1e-3, "1 - correlation");
    stltsa_compared_cycles cycles = {.size = sizeof cycles};
    must(stltsa_comparison_cycles(comparison, &cycles));
    assert_int_equal(cycles.first_count, cycles_of_signals);
    assert_int_equal(cycles.second_count, cycles_of_signals);
    assert_true(cycles.sides == 1 && cycles.shift == 0.5);
    assert_below(fabs(cycles.cycle_time.first - 1), 1e-12, "cycle time");
    double left[101], right[101];
    const stltsa_out to_left = packed_out(left, 101, 1), to_right = packed_out(right, 101, 1);
    must(stltsa_comparison_curves(comparison, 0, &to_left, NULL));
    must(stltsa_comparison_curves(comparison, 1, &to_right, NULL));
    for (int s = 0; s < 101; ++s) {
        const double at = s / 100.0;
        assert_below(fabs(left[s] - sin(turn * at) - 0.4 * cos(2 * turn * at)), 1e-9, "left");
        assert_below(fabs(right[s] - 0.1 - 0.8 * sin(turn * (at - 0.031)) -
                          0.32 * cos(2 * turn * (at - 0.031))),
                     1e-9, "right");
    }
    stltsa_comparison_free(comparison);
}

/* Curves without a common shape, or that do not move, have no lag. */
static void unlike_curves_have_no_lag(void** state) {
    (void)state;
    stltsa_comparison* comparison = compared_knees(0, 1, 0);
    const stltsa_compared_part still = channel_of(comparison, 0);
    assert_true(isnan(still.lag.difference) && isnan(still.correlation));
    assert_true(still.amplitude.second < 1e-12 && still.rms > 0.5);
    stltsa_comparison_free(comparison);
    comparison = compared_knees(-1, 0, 0.03);
    assert_true(isnan(channel_of(comparison, 0).lag.difference));
    assert_below(channel_of(comparison, 0).correlation, 0.7, "correlation");
    stltsa_comparison_free(comparison);
}

static void names_must_pair(void** state) {
    (void)state;
    stltsa_cycles* cycles = knees(1, 0, 0, 101);
    const char *const unlike[] = {"knee_l", "lock", "hip_r"},
                      *const missing[] = {"knee_l", NULL, "knee_r"},
                      *const pair[] = {"knee_l", "", "knee_r"};
    stltsa_comparison* comparison = NULL;
    assert_int_equal(stltsa_cycles_compare_left_right(cycles, unlike, 0, NULL, &comparison),
                     STLTSA_E_UNSUPPORTED);
    assert_non_null(strstr(stltsa_last_error(), "differ only in the side"));
    assert_int_equal(stltsa_cycles_compare_left_right(cycles, missing, 0, NULL, &comparison),
                     STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_compare_left_right(cycles, NULL, 0, NULL, &comparison),
                     STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_cycles_compare_left_right(cycles, pair, -1, NULL, &comparison),
                     STLTSA_E_ARGUMENT);
    assert_null(comparison);
    must(stltsa_cycles_compare_left_right(cycles, pair, 0, NULL, &comparison));
    stltsa_compared_cycles found = {.size = sizeof found};
    must(stltsa_comparison_cycles(comparison, &found));
    assert_true(isnan(found.cycle_time.first) && isnan(found.first_per_minute));
    stltsa_comparison_free(comparison);
    stltsa_cycles_free(cycles);
}

/* Cycles with a gap in one of the signals of a pair are left out; a gap elsewhere does no harm. */
static void cycles_with_gaps_are_left_out(void** state) {
    (void)state;
    double signals[3 * frames_of_signals], borders[cycles_of_signals + 1];
    for (int i = 0; i < frames_of_signals; ++i) {
        signals[3 * i] = sin(turn * i / period);
        signals[3 * i + 1] = NAN;
        signals[3 * i + 2] = i / period == 1 ? NAN : -signals[3 * i];
    }
    for (int c = 0; c <= cycles_of_signals; ++c)
        borders[c] = period * c;
    const stltsa_in in = packed_in(signals, frames_of_signals, 3),
                    at = packed_in(borders, cycles_of_signals + 1, 1);
    const char* const names[] = {"L_heel", "trunk", "R_heel"};
    stltsa_cycles* cycles = NULL;
    stltsa_comparison* comparison = NULL;
    must(stltsa_cycles_between(&at, &in, 51, &cycles));
    must(stltsa_cycles_compare_left_right(cycles, names, 0, NULL, &comparison));
    stltsa_compared_cycles found = {.size = sizeof found};
    must(stltsa_comparison_cycles(comparison, &found));
    assert_int_equal(found.first_count, cycles_of_signals - 1);
    assert_below(channel_of(comparison, 0).rms, 1e-12, "rms");
    stltsa_comparison_free(comparison);
    stltsa_cycles_free(cycles);
}

typedef struct {
    stltsa_clip* clip;
    stltsa_decomposition* found;
    stltsa_phase* phase;
} walk;

static walk walk_of(stltsa_clip* clip) {
    walk w = {clip, NULL, NULL};
    must(stltsa_decompose(w.clip, NULL, &w.found));
    must(stltsa_phase_find(w.found, NULL, &w.phase));
    return w;
}

static void closed(walk w) {
    stltsa_phase_free(w.phase);
    stltsa_decomposition_free(w.found);
    stltsa_clip_free(w.clip);
}

static stltsa_comparison* sides_of(walk w) {
    stltsa_comparison* comparison = NULL;
    must(stltsa_compare_left_right(w.clip, w.phase, 0, 101, NULL, &comparison));
    return comparison;
}

static void a_symmetric_walk_differs_by_nothing(void** state) {
    (void)state;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    walk w = walk_of(clip);
    stltsa_comparison* sides = sides_of(w);
    assert_true(stltsa_comparison_channel_count(sides) > 20);
    for (int64_t i = 0; i < stltsa_comparison_channel_count(sides); ++i) {
        const stltsa_compared_part channel = channel_of(sides, i);
        /* With steps of 70 cm; 0.02 cm measured. */
        assert_below(channel.rms, 0.1, "rms (cm)");
        assert_below(fabs(channel.mean.difference), 0.1, "mean (cm)");
        if (channel.amplitude.first > 5)
            assert_below(fabs(channel.lag.difference), 0.002, "lag");
    }
    stltsa_comparison_free(sides);
    assert_int_equal(stltsa_compare_left_right(w.clip, w.phase, 3, 101, NULL, &sides),
                     STLTSA_E_ARGUMENT);
    assert_null(sides);
    closed(w);
}

/* The joints of the walker as points; those of the right side are renamed and raised. */
static walk walk_of_points(const char* right, double raised) {
    stltsa_clip *clip = NULL, *points = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    const int64_t frames = stltsa_clip_frames(clip), joints = stltsa_clip_joints(clip);
    double* positions = new_matrix(frames, 3 * joints);
    const stltsa_out to = packed_out(positions, frames, 3 * joints);
    must(stltsa_clip_positions(clip, &to));
    const char* names[64] = {NULL};
    static char texts[64][64];
    for (int64_t j = 0; j < joints; ++j) {
        stltsa_joint joint = {.size = sizeof joint};
        must(stltsa_clip_joint(clip, j, &joint));
        const int is_right = strncmp(joint.name, "Right", 5) == 0;
        snprintf(texts[j], sizeof texts[j], "%s%s%s", is_right ? right : "",
                 is_right ? joint.name + 5 : joint.name, joint.is_end_site ? "Tip" : "");
        names[j] = texts[j];
        for (int64_t i = 0; is_right && i < frames; ++i)
            positions[i * 3 * joints + 3 * j + 1] += raised;
    }
    const stltsa_in in = packed_in(positions, frames, 3 * joints);
    const stltsa_points of = {.size = sizeof of,
                              .positions = in,
                              .space = 3,
                              .names = names,
                              .fps = stltsa_clip_fps(clip)};
    must(stltsa_clip_from_points(&of, NULL, &points));
    free(positions);
    stltsa_clip_free(clip);
    return walk_of(points);
}

static void a_raised_side_is_seen_in_points(void** state) {
    (void)state;
    for (int side = 0; side < 2; ++side) {
        const double raised = 3.0 * side;
        walk w = walk_of_points("Right", raised);
        stltsa_comparison* sides = sides_of(w);
        assert_true(stltsa_comparison_channel_count(sides) > 20);
        for (int64_t i = 0; i < stltsa_comparison_channel_count(sides); ++i) {
            const stltsa_compared_part channel = channel_of(sides, i);
            const int is_up = strcmp(stltsa_comparison_channel_axis(sides, i), "y") == 0;
            const double expected = is_up ? raised : 0;
            /* 0.07 and 0.28 measured; 0.77 and 0.88 with the heading of the mirror image. */
            assert_below(fabs(channel.mean.difference - expected), 0.1, "mean (cm)");
            assert_below(fabs(channel.rms - fabs(expected)), 0.35, "rms (cm)");
        }
        stltsa_comparison_free(sides);
        closed(w);
    }
}

static void sides_without_names_are_not_compared(void** state) {
    (void)state;
    walk w = walk_of_points("Other", 0);
    stltsa_comparison* sides = NULL;
    assert_int_equal(stltsa_compare_left_right(w.clip, w.phase, 0, 101, NULL, &sides),
                     STLTSA_E_UNSUPPORTED);
    assert_non_null(
        strstr(stltsa_last_error(), "second half of a cycle of motion A may not mirror the first"));
    closed(w);
}

static void the_phase_of_another_clip_is_refused(void** state) {
    (void)state;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    walk skeleton = walk_of(clip), points = walk_of_points("Right", 0);
    stltsa_comparison* sides = NULL;
    assert_int_equal(stltsa_compare_left_right(skeleton.clip, points.phase, 0, 101, NULL, &sides),
                     STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_compare_left_right(points.clip, skeleton.phase, 0, 101, NULL, &sides),
                     STLTSA_E_ARGUMENT);
    assert_null(sides);
    closed(skeleton);
    closed(points);
}

static void names_say_the_side(void** state) {
    (void)state;
    static const struct {
        const char* name;
        int32_t side;
    } names[] = {{"left heel strike", STLTSA_SIDE_LEFT},
                 {"Right Foot Strike", STLTSA_SIDE_RIGHT},
                 {"LHS", STLTSA_SIDE_LEFT},
                 {"RTO", STLTSA_SIDE_RIGHT},
                 {"heel strike, R", STLTSA_SIDE_RIGHT},
                 {"toe_l", STLTSA_SIDE_LEFT},
                 {"FootRight", STLTSA_SIDE_RIGHT},
                 {"LEFT", STLTSA_SIDE_LEFT},
                 {"right L5", STLTSA_SIDE_RIGHT},
                 {"L5", STLTSA_SIDE_NONE},
                 {"upright", STLTSA_SIDE_NONE},
                 {"a bright light", STLTSA_SIDE_NONE},
                 {"rise", STLTSA_SIDE_NONE},
                 {"LAND", STLTSA_SIDE_NONE},
                 {"from left to right", STLTSA_SIDE_NONE},
                 {"L or R", STLTSA_SIDE_NONE},
                 {"LON", STLTSA_SIDE_LEFT},
                 {"ROFF", STLTSA_SIDE_RIGHT},
                 {"LIC", STLTSA_SIDE_LEFT},
                 {"r\xc3\xa9"
                  "ception",
                  STLTSA_SIDE_NONE},
                 {"H\xc3\xb4t\xc3\xa9l", STLTSA_SIDE_NONE},
                 {"", STLTSA_SIDE_NONE},
                 {NULL, STLTSA_SIDE_NONE}};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i)
        if (stltsa_side_of_name(names[i].name) != names[i].side)
            fail_msg("side of %s: %d", names[i].name, stltsa_side_of_name(names[i].name));
}

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    walker_path = argv[1];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_say_the_side),
        cmocka_unit_test(like_sides_differ_by_nothing),
        cmocka_unit_test(known_differences_are_found),
        cmocka_unit_test(unlike_curves_have_no_lag),
        cmocka_unit_test(names_must_pair),
        cmocka_unit_test(cycles_with_gaps_are_left_out),
        cmocka_unit_test(a_symmetric_walk_differs_by_nothing),
        cmocka_unit_test(a_raised_side_is_seen_in_points),
        cmocka_unit_test(sides_without_names_are_not_compared),
        cmocka_unit_test(the_phase_of_another_clip_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
