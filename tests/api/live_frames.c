/* SPDX-License-Identifier: BSD-3-Clause */
/* Streams of points and poses, as sensors give them, through the public API. */
#include <string.h>

#include "support.h"

/* A clip, its model with a mean cycle, and the phase of the whole clip. */
typedef struct {
    stltsa_clip* clip;
    stltsa_model* model;
    double* offline;
    int64_t frames;
} taught;

static taught taught_with(stltsa_clip* clip, const stltsa_options* options) {
    taught t = {clip, NULL, NULL, stltsa_clip_frames(clip)};
    t.model = fitted_clip(clip, options);
    stltsa_phase* phase = phase_of(clip, options);
    must(stltsa_model_keep_cycle(t.model, phase, NULL));
    t.offline = array_of(phase, STLTSA_INFO_PHASE);
    return t;
}

static taught taught_by(stltsa_clip* clip) {
    return taught_with(clip, NULL);
}

static stltsa_live* stream_of(taught t) {
    stltsa_live* live = NULL;
    must(stltsa_live_new(t.model, &live));
    return keep_live(live);
}

/* The joints of the walker as points. */
static double* walker_points(int64_t* frames, int64_t* points) {
    stltsa_clip* clip = opened();
    *frames = stltsa_clip_frames(clip);
    *points = count_of(clip, STLTSA_INFO_JOINT);
    return array_of(clip, STLTSA_INFO_POSITIONS);
}

static stltsa_clip* clip_of(const double* x, int64_t frames, int64_t points) {
    stltsa_points given;
    memset(&given, 0, sizeof given);
    given.size = sizeof given;
    given.space = 3;
    given.positions = packed_in(x, frames, 3 * points);
    given.fps = 120;
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_points(&given, NULL, &clip));
    return keep_clip(clip);
}

static stltsa_live_frame pushed(stltsa_live* live, double seconds, const double* x,
                                int64_t points) {
    stltsa_live_frame now;
    now.size = sizeof now;
    const stltsa_in in = packed_in(x, points, 3);
    must(stltsa_live_push_points(live, seconds, &in, NULL, &now));
    return now;
}

static double off(double a, double b) {
    return fabs(remainder(a - b, 1));
}

/* Turns about the y axis, which is up, and moves. */
static void put_elsewhere(const double* from, int64_t points, double angle, double* to) {
    for (int64_t p = 0; p < points; ++p) {
        const double *f = from + 3 * p, c = cos(angle), s = sin(angle);
        to[3 * p] = c * f[0] + s * f[2] + 700;
        to[3 * p + 1] = f[1] - 20;
        to[3 * p + 2] = -s * f[0] + c * f[2] - 300;
    }
}

/* Where the body is and which way it faces does not count, and a tenth of the points may be lost.
 */
TEST(points_are_followed_frame_by_frame) {
    int64_t frames, points;
    double* x = walker_points(&frames, &points);
    taught t = taught_by(clip_of(x, frames, points));
    stltsa_live *whole = stream_of(t), *turned = stream_of(t), *lossy = stream_of(t);
    double* row = new_matrix(points, 3);
    uint64_t random = 5;
    double sum = 0, sum_lossy = 0, furthest = 0;
    int64_t inside = 0;
    for (int64_t i = 0; i < frames; ++i) {
        const double seconds = (double)i / 120, *frame = x + 3 * points * i;
        const stltsa_live_frame now = pushed(whole, seconds, frame, points);
        put_elsewhere(frame, points, 0.03 * (double)i, row);
        const stltsa_live_frame moved = pushed(turned, seconds, row, points);
        furthest = fmax(furthest, off(now.phase, moved.phase));
        memcpy(row, frame, 3 * (size_t)points * sizeof *row);
        for (int64_t p = 0; p < points; ++p) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            if (random >> 33 < (UINT64_C(1) << 31) / 10)
                row[3 * p + (int64_t)(random >> 32 & 1)] = NAN;
        }
        const stltsa_live_frame partial = pushed(lossy, seconds, row, points);
        if (isnan(t.offline[i]))
            continue;
        ++inside;
        assert_true(now.known && partial.known);
        sum += off(now.phase, t.offline[i]);
        sum_lossy += off(partial.phase, t.offline[i]);
    }
    assert_true(inside > 200);
    assert_below(sum / (double)inside, 0.005, "mean error");
    assert_below(sum_lossy / (double)inside, 0.006, "mean error with lost points");
    assert_below(furthest, 1e-6, "difference of a body that turns");
}

/* Confidence 0, NaN and three zeros are the same; most points lost is a missing frame. */
TEST(points_may_be_lost) {
    int64_t frames, points;
    double* x = walker_points(&frames, &points);
    taught t = taught_by(clip_of(x, frames, points));
    stltsa_live* lives[3] = {stream_of(t), stream_of(t), stream_of(t)};
    double *row = new_matrix(points, 3), *sure = new_matrix(points, 1);
    const stltsa_in seen = packed_in(sure, points, 1);
    stltsa_live_frame now[3];
    for (int64_t i = 200; i < 300; ++i)
        for (int way = 0; way < 3; ++way) {
            memcpy(row, x + 3 * points * i, 3 * (size_t)points * sizeof *row);
            for (int64_t p = 0; p < points; ++p)
                sure[p] = way != 0 || p != 7;
            for (int c = 0; c < 3 && way > 0; ++c)
                row[21 + c] = way == 1 ? NAN : 0;
            const stltsa_in in = packed_in(row, points, 3);
            now[way].size = sizeof now[way];
            must(stltsa_live_push_points(lives[way], (double)i / 120, &in, &seen, &now[way]));
            assert_memory_equal(&now[0], &now[way], sizeof now[0]);
        }
    assert_true(now[0].known);
    for (int64_t p = 0; p < points / 2 + 1; ++p)
        sure[p] = 0;
    const stltsa_in in = packed_in(x + 3 * points * 300, points, 3);
    must(stltsa_live_push_points(lives[0], 2.5, &in, &seen, &now[0]));
    assert_false(now[0].known);
    assert_true(isnan(now[0].distance));
}

/* A frame has the same answer whatever comes after it: clips of one frame each, and the whole. */
TEST(no_frame_depends_on_later_ones) {
    int64_t frames, points;
    double* x = walker_points(&frames, &points);
    for (int64_t i = 0; i < frames; ++i) /* one point after another is lost for a while */
        x[3 * (points * i + i / 40 % points)] = NAN;
    for (int skeleton = 0; skeleton < 2; ++skeleton) {
        taught t = taught_by(skeleton ? opened() : clip_of(x, frames, points));
        stltsa_live *one = stream_of(t), *all = stream_of(t);
        for (int64_t i = 100; i < 400; ++i) {
            char name[32];
            stltsa_clip* single = NULL;
            stltsa_live_frame a, b;
            a.size = b.size = sizeof a;
            snprintf(name, sizeof name, "%d-%d", (int)i, (int)i + 1);
            must(stltsa_clip_stretch(t.clip, name, NULL, &single));
            must(stltsa_live_push_frame(one, (double)i / 120, single, 0, &a));
            must(stltsa_live_push_frame(all, (double)i / 120, t.clip, i, &b));
            assert_memory_equal(&a, &b, sizeof a);
            stltsa_clip_free(single);
        }
    }
}

/* Quaternions, matrices and channels of a pose are one frame. */
TEST(poses_are_followed_in_every_form) {
    taught t = taught_by(opened());
    const int64_t joints = count_of(t.clip, STLTSA_INFO_JOINT),
                  channels = int_of(t.clip, STLTSA_INFO_CHANNELS);
    double *q = array_of(t.clip, STLTSA_INFO_ROTATIONS), *raw = new_channels(t.clip);
    double* m = new_matrix(joints, 9);
    stltsa_live* lives[4] = {stream_of(t), stream_of(t), stream_of(t), stream_of(t)};
    stltsa_live_frame now[4];
    for (int64_t i = 0; i < t.frames; ++i) {
        const double seconds = (double)i / 120, *of_frame = q + 4 * joints * i;
        for (int64_t j = 0; j < joints; ++j) {
            const double w = of_frame[4 * j], a = of_frame[4 * j + 1], b = of_frame[4 * j + 2],
                         c = of_frame[4 * j + 3];
            const double rows[9] = {
                1 - 2 * (b * b + c * c), 2 * (a * b - w * c),     2 * (a * c + w * b),
                2 * (a * b + w * c),     1 - 2 * (a * a + c * c), 2 * (b * c - w * a),
                2 * (a * c - w * b),     2 * (b * c + w * a),     1 - 2 * (a * a + b * b)};
            memcpy(m + 9 * j, rows, sizeof rows);
        }
        const stltsa_in quaternions = packed_in(of_frame, joints, 4),
                        matrices = packed_in(m, joints, 9),
                        numbers = packed_in(raw + channels * i, 1, channels);
        for (int k = 0; k < 4; ++k)
            now[k].size = sizeof now[k];
        must(stltsa_live_push_frame(lives[0], seconds, t.clip, i, &now[0]));
        must(stltsa_live_push_pose(lives[1], seconds, STLTSA_ROTATIONS_QUATERNION, &quaternions,
                                   NULL, &now[1]));
        must(stltsa_live_push_pose(lives[2], seconds, STLTSA_ROTATIONS_MATRIX, &matrices, NULL,
                                   &now[2]));
        must(stltsa_live_push_pose(lives[3], seconds, STLTSA_ROTATIONS_CHANNELS, &numbers, NULL,
                                   &now[3]));
        for (int k = 1; k < 4; ++k)
            assert_below(off(now[0].phase, now[k].phase), 1e-5, "difference of the forms");
        if (!isnan(t.offline[i]))
            assert_below(off(now[0].phase, t.offline[i]), 0.05, "error");
    }
    q[5] = NAN;
    const stltsa_in bad = packed_in(q, joints, 4);
    must(stltsa_live_push_pose(lives[1], 99, STLTSA_ROTATIONS_QUATERNION, &bad, NULL, &now[1]));
    assert_false(now[1].known);
    q[5] = 3;
    assert_int_equal(
        stltsa_live_push_pose(lives[1], 99, STLTSA_ROTATIONS_QUATERNION, &bad, NULL, &now[1]),
        STLTSA_E_ARGUMENT);
    assert_non_null(strstr(stltsa_last_error(), "is no rotation"));
}

TEST(other_forms_are_refused) {
    int64_t frames, points;
    double* x = walker_points(&frames, &points);
    taught body = taught_by(opened()), marks = taught_by(clip_of(x, frames, points));
    stltsa_live *of_body = stream_of(body), *of_marks = stream_of(marks);
    const stltsa_in three = packed_in(x, points, 3), few = packed_in(x, points - 1, 3),
                    turns = packed_in(x, points, 4);
    stltsa_live_frame now;
    now.size = sizeof now;
    assert_int_equal(stltsa_live_push_points(of_body, 0, &three, NULL, &now), STLTSA_E_UNSUPPORTED);
    assert_int_equal(stltsa_live_push_points(of_marks, 0, &few, NULL, &now), STLTSA_E_SHAPE);
    assert_int_equal(stltsa_live_push_points(of_marks, 0, &three, &three, &now), STLTSA_E_SHAPE);
    assert_int_equal(
        stltsa_live_push_pose(of_marks, 0, STLTSA_ROTATIONS_QUATERNION, &turns, NULL, &now),
        STLTSA_E_UNSUPPORTED);
    assert_int_equal(stltsa_live_push_pose(of_body, 0, 9, &turns, NULL, &now), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_live_push_pose(of_body, 0, STLTSA_ROTATIONS_MATRIX, &turns, NULL, &now),
                     STLTSA_E_SHAPE);
    assert_int_equal(stltsa_live_push_frame(of_body, 0, marks.clip, 0, &now), STLTSA_E_SHAPE);
    assert_int_equal(stltsa_live_push_frame(of_marks, 0, body.clip, 0, &now), STLTSA_E_SHAPE);
    assert_int_equal(stltsa_live_push_frame(of_marks, 0, marks.clip, frames, &now),
                     STLTSA_E_ARGUMENT);
}

/* A frame that is off by half a turn must not move the frames after it by a whole one, nor may two
 * frames at nearly the same time do harm. */
TEST(a_wrong_frame_of_angles_is_forgotten) {
    stltsa_options* options = with_int(STLTSA_OPT_FEATURES, STLTSA_FEATURES_EULER);
    taught t = taught_with(opened(), options);
    const int64_t channels = int_of(t.clip, STLTSA_INFO_CHANNELS);
    double* raw = new_channels(t.clip);
    stltsa_live* live = stream_of(t);
    stltsa_live_frame now;
    now.size = sizeof now;
    const int64_t wrong = 350;
    for (int64_t i = 250; i < 600; ++i) {
        double* row = raw + channels * i;
        for (int64_t c = 6; i == wrong && c < channels; ++c)
            row[c] += 179.9;
        const stltsa_in numbers = packed_in(row, 1, channels);
        const double seconds = i == 301 ? 300 / 120.0 + 1e-15 : (double)i / 120;
        must(stltsa_live_push_pose(live, seconds, STLTSA_ROTATIONS_CHANNELS, &numbers, NULL, &now));
        if ((i > 320 && i < wrong) || i > wrong + 60) {
            assert_true(now.known);
            if (!isnan(t.offline[i]))
                assert_below(off(now.phase, t.offline[i]), 0.05, "error");
        }
    }
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_followed_frame_by_frame),
        cmocka_unit_test(points_may_be_lost),
        cmocka_unit_test(no_frame_depends_on_later_ones),
        cmocka_unit_test(poses_are_followed_in_every_form),
        cmocka_unit_test(other_forms_are_refused),
        cmocka_unit_test(a_wrong_frame_of_angles_is_forgotten),
    };
    return run_on_walker(tests, argc, argv);
}
