/* SPDX-License-Identifier: BSD-3-Clause */
/* The phase of a stream, through the public API. */
#include "support.h"

typedef struct {
    stltsa_model* model;
    stltsa_phase* phase;
    double *features, *offline;
    int64_t frames, count;
} stream;

static stream taught(void) {
    stream w = {NULL, NULL, NULL, NULL, 0, 0};
    stltsa_clip* clip = opened();
    w.model = fitted_clip(clip, NULL);
    w.phase = phase_of(clip, NULL);
    w.frames = stltsa_clip_frames(clip);
    w.features = new_features(clip, NULL, &w.count);
    w.offline = array_of(w.phase, STLTSA_INFO_PHASE);
    return w;
}

static stltsa_live* started(stream w) {
    must(stltsa_model_keep_cycle(w.model, w.phase, NULL));
    must(stltsa_model_keep_mark(w.model, w.phase, 250, "strike"));
    stltsa_live* live = NULL;
    must(stltsa_live_new(w.model, &live));
    return keep_live(live);
}

static stltsa_live_frame pushed(stltsa_live* live, stream w, int64_t frame, double seconds) {
    stltsa_live_frame found;
    found.size = sizeof found;
    const stltsa_in row = packed_in(w.features + frame * w.count, 1, w.count);
    must(stltsa_live_push(live, seconds, &row, &found));
    return found;
}

static double off(double a, double b) {
    return fabs(remainder(a - b, 1));
}

TEST(the_stream_has_the_phase_of_the_clip) {
    stream w = taught();
    assert_int_equal(int_of(w.model, STLTSA_INFO_HAS_CYCLE), 0);
    stltsa_live* live = started(w);
    assert_int_equal(int_of(w.model, STLTSA_INFO_HAS_CYCLE), 1);
    assert_int_equal(count_of(live, STLTSA_INFO_MARK), 1);
    assert_string_equal(text_of(live, STLTSA_INFO_MARK), "strike");
    int64_t inside = 0, passed = 0;
    double sum = 0;
    for (int64_t i = 0; i < w.frames; ++i) {
        const stltsa_live_frame frame = pushed(live, w, i, (double)i / 120);
        assert_true(frame.phase >= 0 && frame.phase < 1);
        assert_true(frame.confidence >= 0 && frame.confidence <= 1.0001);
        if (isnan(w.offline[i]))
            continue;
        ++inside;
        sum += off(frame.phase, w.offline[i]);
        passed += frame.passed;
        assert_true(frame.known);
        assert_int_equal(frame.kind, STLTSA_SEGMENT_CYCLIC);
    }
    assert_below(sum / (double)inside, 0.005, "mean error of the phase");
    assert_int_equal(passed, 3); /* once in each cycle */
}

static stltsa_status keep_cycle(void* user, const stltsa_options* options) {
    const stream* w = user;
    return stltsa_model_keep_cycle(w->model, w->phase, options);
}

TEST(keeping_can_be_cancelled) {
    stream w = taught();
    assert_in_range(cancelled_calls(keep_cycle, &w), 1, 1000);
}

/* Its first phases jump. The body stands, and all places of the cycle are alike. */
TEST(no_mark_is_passed_before_the_filter_settles) {
    stream w = taught();
    must(stltsa_model_keep_cycle(w.model, w.phase, NULL));
    for (int i = 0; i < 12; ++i) {
        const char name[] = {(char)('a' + i), 0};
        must(stltsa_model_keep_mark(w.model, w.phase, 230 + 11 * i, name));
    }
    stltsa_live* live = NULL;
    must(stltsa_live_new(w.model, &live));
    int64_t later = 0;
    for (int64_t i = 0; i < w.frames; ++i) {
        const stltsa_live_frame frame = pushed(live, w, i, (double)i / 120);
        if (i < 18)
            assert_int_equal(frame.passed, 0);
        later |= frame.passed;
    }
    assert_int_equal(later, (1 << 12) - 1);
    stltsa_live_free(live);
}

/* Two streams side by side do not disturb each other; a saved model gives the same bits. */
TEST(streams_are_independent) {
    stream w = taught();
    stltsa_live *one = started(w), *two = NULL, *again = NULL;
    unsigned char* bytes = NULL;
    size_t size = 0;
    stltsa_model* loaded = NULL;
    must(stltsa_model_serialize(w.model, &bytes, &size));
    must(stltsa_model_parse(bytes, size, &loaded));
    must(stltsa_live_new(w.model, &two));
    must(stltsa_live_new(loaded, &again));
    stltsa_model_free(loaded); /* a stream does not refer to its model */
    for (int64_t i = 0; i < w.frames; ++i) {
        const stltsa_live_frame a = pushed(one, w, i, (double)i / 120);
        pushed(two, w, w.frames - 1 - i, (double)i / 120);
        const stltsa_live_frame b = pushed(again, w, i, (double)i / 120);
        assert_memory_equal(&a, &b, sizeof a);
    }
    stltsa_free(bytes);
    stltsa_live_free(two);
    stltsa_live_free(again);
}

/* Dropped and missing frames, a jump, a stop and a restart. */
TEST(streams_survive) {
    stream w = taught();
    stltsa_live* live = started(w);
    stltsa_live_frame frame;
    for (int64_t i = 150; i < 500; ++i) {
        if (i % 3 == 1)
            continue; /* dropped */
        if (i % 50 == 0) {
            const double kept = w.features[i * w.count + 4];
            w.features[i * w.count + 4] = NAN;
            frame = pushed(live, w, i, (double)i / 120);
            w.features[i * w.count + 4] = kept;
            assert_int_equal(frame.known, 0);
        } else {
            frame = pushed(live, w, i, (double)i / 120);
        }
        if (i > 250)
            assert_below(off(frame.phase, w.offline[i]), 0.03, "error with dropped frames");
    }
    /* 0.4 cycles are cut out; 0.3 s later the phase is right again. */
    for (int64_t i = 552; i < 610; ++i)
        frame = pushed(live, w, i, (double)(i - 52) / 120);
    assert_below(off(frame.phase, w.offline[609]), 0.03, "error after a jump");
    /* The same frame again and again: the phase is where the body has stopped. */
    const double stopped = frame.phase;
    for (int64_t i = 0; i < 240; ++i)
        frame = pushed(live, w, 609, (double)(558 + i) / 120);
    assert_below(off(frame.phase, stopped), 0.03, "creep of a stopped stream");
    assert_int_equal(frame.kind, STLTSA_SEGMENT_REST);
    /* Time begins anew. */
    for (int64_t i = 300; i < 360; ++i)
        frame = pushed(live, w, i, (double)(i - 300) / 120);
    assert_below(off(frame.phase, w.offline[359]), 0.03, "error after a restart");
}

/* What was before leaves no trace when time falls by more than 0.25 s, or after a second. */
TEST(a_restarted_stream_is_a_new_one) {
    stream w = taught();
    const double ends[] = {0.26, 100, -1.1}; /* the last time before, after the first one then */
    for (size_t k = 0; k < sizeof ends / sizeof *ends; ++k) {
        stltsa_live *anew = started(w), *fresh = NULL;
        must(stltsa_live_new(w.model, &fresh));
        for (int64_t i = 400; i < w.frames; ++i) /* the walk ends, and the body stands */
            pushed(anew, w, i, 10 + ends[k] - (double)(w.frames - 1 - i) / 120);
        for (int64_t i = 150; i < 300; ++i) {
            const double seconds = 10 + (double)(i - 150) / 120;
            const stltsa_live_frame a = pushed(anew, w, i, seconds),
                                    b = pushed(fresh, w, i, seconds);
            assert_true(a.phase == b.phase && a.rate_hz == b.rate_hz);
            assert_true(a.distance == b.distance && a.confidence == b.confidence);
        }
        stltsa_live_free(fresh);
        must(stltsa_model_keep_cycle(w.model, w.phase, NULL)); /* without the mark */
    }
}

/* The longer nothing is known, the more likely the body has stopped: from frame to frame a little.
 */
TEST(rest_becomes_likely_evenly) {
    stream w = taught();
    stltsa_live* live = started(w);
    double rate = 0, step = 0;
    for (int64_t i = 200; i < 300; ++i)
        rate = pushed(live, w, i, (double)i / 120).rate_hz;
    w.features[300 * w.count] = NAN;
    for (int64_t i = 300; i < 312; ++i) {
        const double next = pushed(live, w, 300, (double)i / 120).rate_hz;
        assert_true(next < rate);
        if (i > 300)
            assert_below(fabs(rate - next - step), 0.3 * step, "change of the step of the rate");
        step = rate - next;
        rate = next;
    }
}

/* A time that cannot be one is an error, and the frame is not taken. */
TEST(absurd_times_leave_no_trace) {
    stream w = taught();
    const double absurd[] = {NAN, INFINITY, -INFINITY, 1e15, -1e13, 1e300};
    stltsa_live *live = started(w), *other = NULL;
    must(stltsa_live_new(w.model, &other));
    for (int64_t i = 150; i < 400; ++i) {
        const stltsa_in row = packed_in(w.features + 400 * w.count, 1, w.count);
        stltsa_live_frame none;
        none.size = sizeof none;
        must_fail(stltsa_live_push(live, absurd[i % 6], &row, &none), STLTSA_E_ARGUMENT,
                  "count from the first frame");
        const stltsa_live_frame a = pushed(live, w, i, (double)i / 120),
                                b = pushed(other, w, i, (double)i / 120);
        assert_memory_equal(&a, &b, sizeof a);
    }
    for (int64_t i = 150; i < 400; ++i) { /* as coarse as the clock may be */
        const stltsa_live_frame frame = pushed(live, w, i, -1e12 + (double)i / 120);
        assert_true(isfinite(frame.cycles) && frame.confidence <= 1.0001);
    }
    stltsa_live_free(other);
}

/* Coarse clocks give several frames one time, late packets an earlier one. */
TEST(clocks_may_be_coarse) {
    stream w = taught();
    stltsa_live *coarse = started(w), *even = started(w);
    stltsa_live_frame frame, right;
    int64_t passed = 0;
    for (int64_t i = 150; i < 500; ++i) {
        right = pushed(even, w, i, (double)i / 120);
        frame = pushed(coarse, w, i, (double)(i - i % 4) / 120);
        passed += frame.passed;
        if (i > 200 && i % 4 == 0)
            assert_below(off(frame.phase, right.phase), 0.02, "difference of a coarse clock");
        if (i % 50 == 0) { /* a frame from 0.1 s ago */
            const stltsa_live_frame late = pushed(even, w, i - 12, (double)(i - 12) / 120);
            assert_true(late.phase == right.phase && late.cycles == right.cycles);
            assert_int_equal(late.passed, 0);
        }
    }
    assert_below(fabs(frame.cycles - right.cycles), 0.03, "turns by a coarse clock");
    assert_int_equal(passed, 2); /* at 250 and 382 */
}

/* A number that is no pose is a missing frame: it leaves no trace in the filter. */
TEST(huge_numbers_do_no_harm) {
    stream w = taught();
    const double huge[] = {1e300, -1e30, 1e9, INFINITY, NAN};
    for (size_t k = 0; k < sizeof huge / sizeof *huge; ++k) {
        stltsa_live *live = started(w), *missed = started(w);
        stltsa_live_frame frame, other;
        for (int64_t i = 200; i < 400; ++i) {
            if (i == 300) {
                const double before = frame.confidence, kept = w.features[i * w.count + 4];
                w.features[i * w.count + 4] = huge[k];
                frame = pushed(live, w, i, (double)i / 120);
                w.features[i * w.count + 4] = kept;
                assert_int_equal(frame.known, 0);
                assert_true(isnan(frame.distance));
                assert_true(frame.confidence < before);
                continue;
            }
            frame = pushed(live, w, i, (double)i / 120);
            other = pushed(missed, w, i, (double)i / 120);
            assert_true(frame.known && isfinite(frame.phase) && isfinite(frame.distance));
            assert_below(off(frame.phase, other.phase), 0.001, "trace of a huge number");
        }
    }
}

/* The longer frames are missing, the less the phase is known. */
TEST(confidence_falls_while_frames_are_missing) {
    stream w = taught();
    stltsa_live* live = started(w);
    stltsa_live_frame frame;
    for (int64_t i = 200; i < 300; ++i)
        frame = pushed(live, w, i, (double)i / 120);
    double* lost = w.features + 300 * w.count;
    *lost = NAN;
    double before = frame.confidence;
    for (int64_t i = 300; i < 418; ++i) {
        frame = pushed(live, w, 300, (double)i / 120);
        assert_true(frame.confidence < before);
        before = frame.confidence;
        if (i < 340)
            assert_below(off(frame.phase, w.offline[i]), 0.05, "error while frames are missing");
    }
    assert_below(before, 0.8, "confidence after a second");
    frame = pushed(live, w, 300, 450 / 120.0);
    assert_true(frame.confidence == 0);
}

TEST(other_motion_is_not_known) {
    stream w = taught();
    stltsa_live* live = started(w);
    for (int64_t i = 200; i < 400; ++i)
        pushed(live, w, i, (double)i / 120);
    int64_t told = -1;
    for (int64_t i = 400; i < 460; ++i) {
        double* row = w.features + i * w.count;
        for (int64_t c = 0; c < w.count; ++c)
            row[c] += 40 * sin(0.9 * (double)c); /* a body bent in half */
        const stltsa_live_frame frame = pushed(live, w, i, (double)i / 120);
        assert_true(frame.known || frame.distance > 1);
        if (!frame.known && told < 0) {
            told = i;
            assert_int_equal(frame.kind, STLTSA_SEGMENT_ACTION);
        }
    }
    assert_true(told >= 0 && told < 400 + 24); /* 0.2 s */
}

/* Columns of single precision that are 12 bytes apart give what the same numbers give as doubles.
 */
TEST(frames_may_be_floats_with_strides) {
    stream w = taught();
    stltsa_live *live = started(w), *other = NULL;
    must(stltsa_live_new(w.model, &other));
    float* spread = calloc((size_t)(3 * w.count), sizeof *spread);
    double* packed = new_matrix(1, w.count);
    for (int64_t i = 0; i < 60; ++i) {
        for (int64_t c = 0; c < w.count; ++c)
            packed[c] = spread[3 * c] = (float)w.features[i * w.count + c];
        stltsa_in row = packed_in(packed, 1, w.count);
        stltsa_live_frame a, b;
        a.size = b.size = sizeof a;
        must(stltsa_live_push(live, (double)i / 120, &row, &a));
        row.data = spread;
        row.dtype = STLTSA_F32;
        row.row_stride = 12 * w.count;
        row.col_stride = 12;
        must(stltsa_live_push(other, (double)i / 120, &row, &b));
        assert_true(a.phase == b.phase && a.confidence == b.confidence);
    }
    free(spread);
    stltsa_live_free(other);
}

TEST(wrong_arguments_are_named) {
    stream w = taught();
    stltsa_live* live = NULL;
    assert_int_equal(stltsa_live_new(w.model, &live), STLTSA_E_UNSUPPORTED);
    assert_null(live);
    assert_int_equal(stltsa_model_keep_mark(w.model, w.phase, 250, "a"), STLTSA_E_ARGUMENT);
    live = started(w);
    must_fail(stltsa_model_keep_mark(w.model, w.phase, 2, "a"), STLTSA_E_ARGUMENT,
              "lies in no cycle");
    assert_int_equal(stltsa_model_keep_mark(w.model, w.phase, 250, ""), STLTSA_E_ARGUMENT);
    stltsa_live_frame frame;
    frame.size = sizeof frame;
    const stltsa_in narrow = packed_in(w.features, 1, w.count - 1),
                    right = packed_in(w.features, 1, w.count);
    assert_int_equal(stltsa_live_push(live, 0, &narrow, &frame), STLTSA_E_SHAPE);
    assert_int_equal(stltsa_live_push(live, NAN, &right, &frame), STLTSA_E_ARGUMENT);
    stltsa_in integers = right, none = right;
    integers.dtype = STLTSA_I64;
    must_fail(stltsa_live_push(live, 0, &integers, &frame), STLTSA_E_ARGUMENT,
              "it must be STLTSA_F64 or STLTSA_F32");
    none.data = NULL;
    must_fail(stltsa_live_push(live, 0, &none, &frame), STLTSA_E_ARGUMENT, "data is NULL");
    frame.size = 3;
    assert_int_equal(stltsa_live_push(live, 0, &right, &frame), STLTSA_E_ARGUMENT);
    for (int i = 1; i < 62; ++i)
        must(stltsa_model_keep_mark(w.model, w.phase, 250, "again"));
    must_fail(stltsa_model_keep_mark(w.model, w.phase, 250, "b"), STLTSA_E_ARGUMENT,
              "at most 62 marks");
    enum { rows = 200, cols = 4 };
    double* x = new_motion(rows, cols, 2);
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_model* other = NULL;
    must(stltsa_fit(&in, NULL, NULL, &other));
    assert_int_equal(stltsa_model_keep_cycle(other, w.phase, NULL), STLTSA_E_SHAPE);
    assert_int_equal(int_of(other, STLTSA_INFO_HAS_CYCLE), 0);
    stltsa_live_free(NULL);
    stltsa_model_free(other);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_stream_has_the_phase_of_the_clip),
        cmocka_unit_test(keeping_can_be_cancelled),
        cmocka_unit_test(no_mark_is_passed_before_the_filter_settles),
        cmocka_unit_test(streams_are_independent),
        cmocka_unit_test(streams_survive),
        cmocka_unit_test(a_restarted_stream_is_a_new_one),
        cmocka_unit_test(rest_becomes_likely_evenly),
        cmocka_unit_test(absurd_times_leave_no_trace),
        cmocka_unit_test(clocks_may_be_coarse),
        cmocka_unit_test(huge_numbers_do_no_harm),
        cmocka_unit_test(confidence_falls_while_frames_are_missing),
        cmocka_unit_test(other_motion_is_not_known),
        cmocka_unit_test(frames_may_be_floats_with_strides),
        cmocka_unit_test(wrong_arguments_are_named),
    };
    return run_on_walker(tests, argc, argv);
}
