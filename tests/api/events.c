/* SPDX-License-Identifier: BSD-3-Clause */
/* Events marked once and found in every cycle, through the public API. */
#include "support.h"

static stltsa_phase* walk_phase(void) {
    stltsa_clip* clip = opened();
    stltsa_phase* phase = phase_of(clip, NULL);
    return phase;
}

static stltsa_events* found_in(const stltsa_phase* from, double mark, const stltsa_phase* in) {
    const stltsa_in marks = packed_in(&mark, 1, 1);
    stltsa_events* events = NULL;
    must(stltsa_events_find(from, &marks, in, NULL, &events));
    return keep_events(events);
}

static stltsa_status find(void* phase, const stltsa_options* options) {
    const double mark = 250;
    const stltsa_in marks = packed_in(&mark, 1, 1);
    stltsa_events* events = NULL;
    const stltsa_status status = stltsa_events_find(phase, &marks, NULL, options, &events);
    assert_true((events == NULL) == (status != STLTSA_OK));
    if (status == STLTSA_OK) {
        stltsa_events* expected = found_in(phase, mark, NULL);
        assert_int_equal(count_of(events, STLTSA_INFO_EVENT),
                         count_of(expected, STLTSA_INFO_EVENT));
    }
    stltsa_events_free(events);
    return status;
}

TEST(finding_can_be_cancelled) {
    stltsa_phase* phase = walk_phase();
    assert_in_range(cancelled_calls(find, phase), 4, 1000); /* at the start, and for each cycle */
}

/* The walker repeats every 132 frames: the event does so, too, to a fraction of a frame. */
TEST(a_mark_is_found_in_every_cycle) {
    stltsa_phase* phase = walk_phase();
    const double marks[] = {250, 263.4, 301.25};
    for (size_t m = 0; m < sizeof marks / sizeof *marks; ++m) {
        stltsa_events* events = found_in(phase, marks[m], NULL);
        int64_t marked = -1;
        for (int64_t i = 0; i < count_of(events, STLTSA_INFO_EVENT); ++i) {
            const stltsa_event event = event_at(events, i);
            assert_below(fabs(event.seconds - event.frame / 120), 1e-12, "seconds");
            assert_true(event.confidence >= 0 && event.confidence <= 1);
            if (event.marked) {
                assert_true(event.frame == marks[m] && event.cycle == 0);
                marked = i;
            }
        }
        assert_true(marked >= 0);
        for (int c = 1; c <= 2; ++c) {
            const stltsa_event event = event_at(events, marked + c);
            assert_int_equal(event.cycle, c);
            assert_false(event.marked);
            assert_below(fabs(event.frame - (marks[m] + c * 132)), 0.25, "frames off");
            assert_true(event.confidence > 0.9);
        }
        assert_true(real_of(events, STLTSA_INFO_LIKENESS) == 1);
    }
}

/* The same event in a stretch of the walk, which begins elsewhere in the cycle. */
TEST(a_mark_is_found_in_another_clip) {
    stltsa_clip *clip = opened(), *part = NULL;
    must(stltsa_clip_stretch(clip, "170-600", NULL, &part));
    stltsa_phase *phase = walk_phase(), *other = phase_of(part, NULL);
    stltsa_clip_free(part);
    stltsa_events* events = found_in(phase, 250, other);
    assert_true(real_of(events, STLTSA_INFO_LIKENESS) > 0.99);
    int near_by = 0;
    for (int64_t i = 0; i < count_of(events, STLTSA_INFO_EVENT); ++i) {
        const stltsa_event event = event_at(events, i);
        assert_false(event.marked);
        const double cycles = (event.frame + 170 - 250) / 132;
        if (event.cycle >= 0) {
            assert_below(fabs(cycles - nearbyint(cycles)) * 132, 1.5, "frames off");
            ++near_by;
        }
    }
    assert_true(near_by >= 2);
}

/* Both feet under one name: each is found half a cycle from the other, and a warning says so. */
TEST(marks_at_two_places_are_two_events) {
    stltsa_phase* phase = walk_phase();
    const double both[] = {250, 316};
    const stltsa_in marks = packed_in(both, 2, 1);
    stltsa_events *events = NULL, *one = found_in(phase, 250, NULL);
    must(stltsa_events_find(phase, &marks, NULL, NULL, &events));
    assert_int_equal(count_of(one, STLTSA_INFO_WARNING), 0);
    assert_int_equal(count_of(events, STLTSA_INFO_WARNING), 1);
    assert_int_equal(warnings_of(events, "2 places in the cycle"), 1);
    assert_int_equal(get_warning(stltsa_events_info(events), 0).code,
                     STLTSA_WARNING_SEVERAL_PLACES);
    int64_t marked = 0, of_first = 0;
    for (int64_t i = 0; i < count_of(events, STLTSA_INFO_EVENT); ++i) {
        const stltsa_event event = event_at(events, i);
        if (event.marked)
            assert_true(event.frame == both[marked++]);
        const double turns = (event.frame - 250) / 66;
        if (event.cycle >= 0)
            assert_below(fabs(turns - nearbyint(turns)) * 66, 0.5, "frames off");
        of_first += (int64_t)nearbyint(turns) % 2 == 0;
    }
    assert_int_equal(marked, 2);
    assert_int_equal(of_first, count_of(one, STLTSA_INFO_EVENT));
    stltsa_events_free(events);

    /* All marks come back, also several in one cycle; marks all over it mark no place in it. */
    const double near_by[] = {250, 252, 254};
    const stltsa_in few = packed_in(near_by, 3, 1);
    must(stltsa_events_find(phase, &few, NULL, NULL, &events));
    marked = 0;
    for (int64_t i = 0; i < count_of(events, STLTSA_INFO_EVENT); ++i)
        marked += event_at(events, i).marked;
    assert_int_equal(marked, 3);
    stltsa_events_free(events);
    double all[30];
    for (int i = 0; i < 30; ++i)
        all[i] = 250 + 4 * i;
    const stltsa_in many = packed_in(all, 30, 1);
    must_fail(stltsa_events_find(phase, &many, NULL, NULL, &events), STLTSA_E_ARGUMENT,
              "spread over");
}

TEST(wrong_arguments_are_named) {
    stltsa_phase* phase = walk_phase();
    stltsa_events* events = NULL;
    const double outside[] = {2, 99999, NAN};
    const char* const texts[] = {"lies in no motion that repeats", "the clip has frames 0 to",
                                 "mark 0 is frame"};
    for (int i = 0; i < 3; ++i) {
        const stltsa_in marks = packed_in(outside + i, 1, 1);
        assert_int_equal(stltsa_events_find(phase, &marks, NULL, NULL, &events), STLTSA_E_ARGUMENT);
        assert_non_null(strstr(stltsa_last_error(), texts[i]));
    }
    const stltsa_in none = packed_in(outside, 0, 1), wide = packed_in(outside, 1, 2);
    assert_int_equal(stltsa_events_find(phase, &none, NULL, NULL, &events), STLTSA_E_SHAPE);
    assert_int_equal(stltsa_events_find(phase, &wide, NULL, NULL, &events), STLTSA_E_SHAPE);
    assert_null(events);
    stltsa_events_free(NULL);
}

/* Points whose columns differ from the walker's features. */
TEST(other_features_are_refused) {
    enum { rows = 300, cols = 4 };
    double* x = new_motion(rows, cols, 2);
    stltsa_clip* clip = matrix_clip(x, rows, cols, 30);
    stltsa_phase *phase = walk_phase(), *other = phase_of(clip, NULL);
    const double mark = 250;
    const stltsa_in marks = packed_in(&mark, 1, 1);
    stltsa_events* events = NULL;
    must_fail(stltsa_events_find(phase, &marks, other, NULL, &events), STLTSA_E_SHAPE,
              "other features");
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mark_is_found_in_every_cycle),
        cmocka_unit_test(a_mark_is_found_in_another_clip),
        cmocka_unit_test(finding_can_be_cancelled),
        cmocka_unit_test(marks_at_two_places_are_two_events),
        cmocka_unit_test(wrong_arguments_are_named),
        cmocka_unit_test(other_features_are_refused),
    };
    return run_on_walker(tests, argc, argv);
}
