/* SPDX-License-Identifier: BSD-3-Clause */
/* Comparison of left and right over a cycle, through the public API. */
#include <string.h>
#include <time.h>

#include "support.h"

static const char* walker_path;

static const double turn = 6.283185307179586;

enum { period = 100, cycles_of_signals = 4, frames_of_signals = period * cycles_of_signals + 1 };

static stltsa_side_pair pair_of(const stltsa_sides* sides, int64_t index) {
    stltsa_side_pair pair = {.size = sizeof pair};
    must(stltsa_sides_pair(sides, index, &pair));
    return pair;
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

static stltsa_sides* compared_knees(double gain, double raised, double late, int64_t samples) {
    const char* const names[] = {"knee_r", "trunk", "knee_l"};
    stltsa_cycles* cycles = knees(gain, raised, late, samples);
    stltsa_sides* sides = NULL;
    must(stltsa_sides_compare(cycles, names, &sides));
    stltsa_cycles_free(cycles);
    assert_string_equal(stltsa_sides_reason(sides), "");
    assert_int_equal(stltsa_sides_count(sides), 1);
    assert_string_equal(stltsa_sides_left_name(sides, 0), "knee_l");
    assert_string_equal(stltsa_sides_right_name(sides, 0), "knee_r");
    assert_string_equal(stltsa_sides_left_name(sides, 1), "");
    assert_string_equal(stltsa_sides_right_name(sides, -1), "");
    return sides;
}

static void like_sides_differ_by_nothing(void** state) {
    (void)state;
    stltsa_sides* sides = compared_knees(1, 0, 0, 101);
    const stltsa_side_pair pair = pair_of(sides, 0);
    assert_int_equal(pair.left, 2);
    assert_int_equal(pair.right, 0);
    assert_below(pair.rms, 1e-12, "rms");
    assert_below(pair.chance, 1e-12, "chance");
    assert_below(fabs(pair.mean), 1e-12, "mean");
    assert_below(fabs(pair.left_range - pair.right_range), 1e-12, "ranges");
    assert_below(fabs(pair.shift), 1e-9, "shift");
    assert_below(1 - pair.correlation, 1e-9, "1 - correlation");
    stltsa_sides_free(sides);
}

static void known_differences_are_found(void** state) {
    (void)state;
    stltsa_sides* sides = compared_knees(0.8, 0.1, 0.031, 101);
    const stltsa_side_pair pair = pair_of(sides, 0);
    assert_below(fabs(pair.mean + 0.1), 1e-9, "mean");
    assert_below(fabs(pair.right_range / pair.left_range - 0.8), 1e-3, "ratio of ranges");
    assert_below(fabs(pair.shift - 0.031), 2e-4, "shift");
    assert_below(1 - pair.correlation, 1e-3, "1 - correlation");
    double left[101], right[101], difference[101], squares = 0;
    const stltsa_out to_left = packed_out(left, 101, 1), to_right = packed_out(right, 101, 1),
                     to_difference = packed_out(difference, 101, 1);
    must(stltsa_sides_curves(sides, &to_left, &to_right, &to_difference));
    must(stltsa_sides_curves(sides, NULL, NULL, NULL));
    for (int s = 0; s < 101; ++s) {
        const double at = s / 100.0;
        assert_below(fabs(left[s] - sin(turn * at) - 0.4 * cos(2 * turn * at)), 1e-9, "left");
        assert_below(fabs(right[s] - 0.1 - 0.8 * sin(turn * (at - 0.031)) -
                          0.32 * cos(2 * turn * (at - 0.031))),
                     1e-9, "right");
        assert_true(difference[s] == left[s] - right[s]);
        squares += s < 100 ? difference[s] * difference[s] : 0;
    }
    assert_below(fabs(pair.rms - sqrt(squares / 100)), 1e-12, "rms");
    stltsa_sides_free(sides);
}

/* The shift is then found from fewer samples. */
static void a_known_shift_is_found_with_many_samples(void** state) {
    (void)state;
    const int64_t samples[] = {1502, 12345};
    for (int i = 0; i < 2; ++i) {
        stltsa_sides* sides = compared_knees(0.8, 0.1, 0.031, samples[i]);
        assert_below(fabs(pair_of(sides, 0).shift - 0.031), 2e-4, "shift");
        assert_below(1 - pair_of(sides, 0).correlation, 1e-3, "1 - correlation");
        stltsa_sides_free(sides);
    }
}

/* Curves without a common shape, or that do not move, have no shift. */
static void unlike_curves_have_no_shift(void** state) {
    (void)state;
    stltsa_sides* sides = compared_knees(0, 1, 0, 101);
    const stltsa_side_pair pair = pair_of(sides, 0);
    assert_true(isnan(pair.shift) && isnan(pair.correlation));
    assert_true(pair.right_range < 1e-12 && pair.rms > 0.5);
    stltsa_sides_free(sides);
    sides = compared_knees(-1, 0, 0.03, 101);
    assert_true(isnan(pair_of(sides, 0).shift));
    assert_below(pair_of(sides, 0).correlation, 0.7, "correlation");
    stltsa_sides_free(sides);
}

static void names_must_pair(void** state) {
    (void)state;
    stltsa_cycles* cycles = knees(1, 0, 0, 101);
    const char* const unlike[] = {"knee_l", "lock", "hip_r"};
    stltsa_sides* sides = NULL;
    must(stltsa_sides_compare(cycles, unlike, &sides));
    assert_int_equal(stltsa_sides_count(sides), 0);
    assert_non_null(strstr(stltsa_sides_reason(sides), "differ only in the side"));
    stltsa_side_pair pair = {.size = sizeof pair};
    assert_int_equal(stltsa_sides_pair(sides, 0, &pair), STLTSA_E_ARGUMENT);
    stltsa_sides_free(sides);
    const char* const missing[] = {"knee_l", NULL, "knee_r"};
    assert_int_equal(stltsa_sides_compare(cycles, missing, &sides), STLTSA_E_ARGUMENT);
    assert_null(sides);
    assert_int_equal(stltsa_sides_compare(cycles, NULL, &sides), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_sides_count(NULL), 0);
    assert_string_equal(stltsa_sides_reason(NULL), "");
    stltsa_sides_free(NULL);
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
    must(stltsa_phase_find(w.clip, w.found, NULL, &w.phase));
    return w;
}

static void closed(walk w) {
    stltsa_phase_free(w.phase);
    stltsa_decomposition_free(w.found);
    stltsa_clip_free(w.clip);
}

static stltsa_sides* sides_of(walk w) {
    stltsa_sides* sides = NULL;
    must(stltsa_sides_find(w.clip, w.phase, 0, 101, NULL, &sides));
    return sides;
}

static void a_symmetric_walk_differs_by_nothing(void** state) {
    (void)state;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    walk w = walk_of(clip);
    stltsa_sides* sides = sides_of(w);
    assert_string_equal(stltsa_sides_reason(sides), "");
    assert_true(stltsa_sides_count(sides) > 20);
    for (int64_t i = 0; i < stltsa_sides_count(sides); ++i) {
        const stltsa_side_pair pair = pair_of(sides, i);
        /* With steps of 70 cm; 0.02 cm measured. */
        assert_below(pair.rms, 0.1, "rms (cm)");
        assert_below(fabs(pair.mean), 0.1, "mean (cm)");
        if (pair.left_range > 5)
            assert_below(fabs(pair.shift), 0.002, "shift");
        assert_string_equal(stltsa_phase_column_owner(w.phase, pair.left),
                            stltsa_sides_left_name(sides, i));
        assert_string_equal(stltsa_phase_column_owner(w.phase, pair.right),
                            stltsa_sides_right_name(sides, i));
    }
    stltsa_sides_free(sides);
    assert_int_equal(stltsa_sides_find(w.clip, w.phase, 3, 101, NULL, &sides), STLTSA_E_ARGUMENT);
    assert_null(sides);
    assert_int_equal(stltsa_sides_find(w.clip, w.phase, 0, 1, NULL, &sides), STLTSA_E_ARGUMENT);
    closed(w);
}

/* The search for the shift took quadratic time: a minute for these samples. */
static void many_samples_take_linear_time_and_poll(void** state) {
    (void)state;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    walk w = walk_of(clip);
    stltsa_sides *few = sides_of(w), *many = NULL;
    int32_t left = INT32_MAX;
    stltsa_options* options = NULL;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_progress(options, cancel_after, &left));
    const double begin = (double)clock() / CLOCKS_PER_SEC;
    must(stltsa_sides_find(w.clip, w.phase, 0, 30001, options, &many));
    assert_below((double)clock() / CLOCKS_PER_SEC - begin, 20, "seconds");
    assert_true(INT32_MAX - left > 30); /* 33 calls; 29 if the comparison of the pairs has none */
    stltsa_options_free(options);
    assert_int_equal(stltsa_sides_count(many), stltsa_sides_count(few));
    for (int64_t i = 0; i < stltsa_sides_count(few); ++i) {
        const stltsa_side_pair one = pair_of(few, i), other = pair_of(many, i);
        assert_below(fabs(one.rms - other.rms), 0.01, "rms (cm)");
        assert_below(fabs(one.left_range - other.left_range), 0.2, "range (cm)");
        if (one.left_range > 5)
            assert_below(fabs(one.shift - other.shift), 0.001, "shift");
    }
    stltsa_sides_free(many);
    stltsa_sides_free(few);
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
        stltsa_sides* sides = sides_of(w);
        assert_string_equal(stltsa_sides_reason(sides), "");
        assert_true(stltsa_sides_count(sides) > 20);
        for (int64_t i = 0; i < stltsa_sides_count(sides); ++i) {
            const stltsa_side_pair pair = pair_of(sides, i);
            const double expected = pair.left % 3 == 1 ? -raised : 0;
            /* 0.07 and 0.28 measured; 0.77 and 0.88 with the heading of the mirror image. */
            assert_below(fabs(pair.mean - expected), 0.1, "mean (cm)");
            assert_below(fabs(pair.rms - fabs(expected)), 0.35, "rms (cm)");
        }
        stltsa_sides_free(sides);
        closed(w);
    }
}

static void sides_without_names_are_not_compared(void** state) {
    (void)state;
    walk w = walk_of_points("Other", 0);
    stltsa_sides* sides = sides_of(w);
    assert_int_equal(stltsa_sides_count(sides), 0);
    assert_non_null(strstr(stltsa_sides_reason(sides),
                           "second half of a cycle of motion A may not mirror the first"));
    stltsa_sides_free(sides);
    closed(w);
}

static void the_phase_of_another_clip_is_refused(void** state) {
    (void)state;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    walk skeleton = walk_of(clip), points = walk_of_points("Right", 0);
    const walk mixed[] = {{skeleton.clip, NULL, points.phase}, {points.clip, NULL, skeleton.phase}};
    for (int i = 0; i < 2; ++i) {
        stltsa_sides* sides = NULL;
        const stltsa_status status =
            stltsa_sides_find(mixed[i].clip, mixed[i].phase, 0, 101, NULL, &sides);
        assert_int_equal(status, STLTSA_E_ARGUMENT);
        assert_null(sides);
    }
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
        cmocka_unit_test(a_known_shift_is_found_with_many_samples),
        cmocka_unit_test(unlike_curves_have_no_shift),
        cmocka_unit_test(names_must_pair),
        cmocka_unit_test(a_symmetric_walk_differs_by_nothing),
        cmocka_unit_test(many_samples_take_linear_time_and_poll),
        cmocka_unit_test(a_raised_side_is_seen_in_points),
        cmocka_unit_test(sides_without_names_are_not_compared),
        cmocka_unit_test(the_phase_of_another_clip_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
