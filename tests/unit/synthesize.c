/* SPDX-License-Identifier: BSD-3-Clause */
/* New motion from pieces: on the synthetic walker, whose cycles are alike, and on a figure that
 * walks wherever it is told to. */
#include "support.h"

static const char* walker_path;

/* ---- What a clip holds ---- */

static stltsa_clip* opened(void) {
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    return clip;
}

/* The file's numbers, frames x channels. */
static double* new_channels(const stltsa_clip* clip) {
    stltsa_options* options = NULL;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_int(options, STLTSA_FEATURES, STLTSA_FEATURES_RAW));
    const int64_t rows = stltsa_clip_frames(clip), cols = stltsa_clip_channels(clip);
    double* values = new_matrix(rows, cols);
    const stltsa_out out = packed_out(values, rows, cols);
    must(stltsa_clip_features(clip, options, &out));
    stltsa_options_free(options);
    return values;
}

static double* new_positions(const stltsa_clip* clip) {
    const int64_t rows = stltsa_clip_frames(clip), cols = 3 * stltsa_clip_joints(clip);
    double* values = new_matrix(rows, cols);
    const stltsa_out out = packed_out(values, rows, cols);
    must(stltsa_clip_positions(clip, &out));
    return values;
}

static double distance(const double* a, const double* b, int axes) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (axes & 1 << axis)
            sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return sqrt(sum);
}
enum { space = 7, floor_plane = 5 }; /* x y z; x z */

static stltsa_options* with(int32_t key, double value) {
    stltsa_options* options = NULL;
    must(stltsa_options_new(&options));
    must(stltsa_options_set_real(options, key, value));
    return options;
}

static stltsa_synthesis* made(const stltsa_piece* pieces, int64_t count,
                              const stltsa_options* options) {
    stltsa_synthesis* synthesis = NULL;
    must(stltsa_synthesize(pieces, count, options, &synthesis));
    return synthesis;
}

static stltsa_seam seam_of(const stltsa_synthesis* synthesis, int64_t index) {
    stltsa_seam seam = {.size = sizeof seam};
    must(stltsa_synthesis_seam(synthesis, index, &seam));
    return seam;
}

static int has_warning(const stltsa_synthesis* synthesis, const char* word) {
    for (int64_t i = 0; i < stltsa_synthesis_warning_count(synthesis); ++i)
        if (strstr(stltsa_synthesis_warning(synthesis, i), word) != NULL)
            return 1;
    return 0;
}

/* The second of the walker's three cycles. */
static stltsa_interval middle_cycle(const stltsa_clip* clip) {
    stltsa_decomposition* d = NULL;
    must(stltsa_decompose(clip, NULL, &d));
    stltsa_interval cycle;
    must(stltsa_decomposition_cycle(d, 1, &cycle));
    stltsa_decomposition_free(d);
    return cycle;
}

/* ---- A figure that walks ---- */

struct figure {
    double fps;
    int frames;
    double turn, x, z; /* degrees about the up axis, and where it starts */
    double arms;       /* degrees by which both arms are raised */
    double arm_length;
    const char* head;  /* name of a joint */
    const char* order; /* channels of the head */
    double still;      /* 1: nothing moves */
};

static const struct figure usual_figure = {
    120, 480, 0, 0, 0, 0, 30, "Head", "Zrotation Xrotation Yrotation", 0};

static const char hierarchy[] =
    "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n"
    "CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n"
    "JOINT %s\n{\nOFFSET 0 50 0\nCHANNELS 3 %s\nEnd Site\n{\nOFFSET 0 20 0\n}\n}\n"
    "JOINT LeftArm\n{\nOFFSET 20 45 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "End Site\n{\nOFFSET 0 -%.17g 0\n}\n}\n"
    "JOINT RightArm\n{\nOFFSET -20 45 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "End Site\n{\nOFFSET 0 -%.17g 0\n}\n}\n"
    "JOINT LeftFoot\n{\nOFFSET 10 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "End Site\n{\nOFFSET 0 -90 0\n}\n}\n"
    "JOINT RightFoot\n{\nOFFSET -10 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "End Site\n{\nOFFSET 0 -90 0\n}\n}\n"
    "}\nMOTION\nFrames: %d\nFrame Time: %.17g\n";

static stltsa_clip* new_figure(struct figure f) {
    const size_t size = 4096 + (size_t)f.frames * 21 * 26;
    char* text = malloc(size);
    assert_non_null(text);
    int at = snprintf(text, size, hierarchy, f.head, f.order, f.arm_length, f.arm_length, f.frames,
                      1 / f.fps);
    for (int i = 0; i < f.frames; ++i) {
        const double t = i / f.fps, swing = f.still > 0 ? 0 : sin(2 * pi * t);
        const double along = f.still > 0 ? 0 : 120 * t + 3 * sin(4 * pi * t);
        const double c = cos(f.turn * pi / 180), s = sin(f.turn * pi / 180);
        const double row[21] = {f.x + s * along,
                                90 + 2 * swing * swing,
                                f.z + c * along,
                                f.turn + 4 * swing,
                                3 * swing * swing,
                                2 * swing,
                                0,
                                5 * swing,
                                0,
                                f.arms,
                                20 * swing,
                                0,
                                -f.arms,
                                -20 * swing,
                                0,
                                0,
                                -25 * swing,
                                0,
                                0,
                                25 * swing,
                                0};
        for (int k = 0; k < 21; ++k)
            at += snprintf(text + at, size - (size_t)at, "%.17g%c", row[k], k < 20 ? ' ' : '\n');
    }
    stltsa_clip* clip = NULL;
    must(stltsa_clip_parse(text, (size_t)at, STLTSA_FORMAT_BVH, NULL, &clip));
    free(text);
    return clip;
}

/* ---- Pieces that follow each other ---- */

static void units_give_the_clip_back(void** state) {
    (void)state;
    stltsa_clip* clip = opened();
    stltsa_decomposition* d = NULL;
    must(stltsa_decompose(clip, NULL, &d));
    stltsa_piece pieces[5];
    assert_int_equal(stltsa_decomposition_unit_count(d), 5);
    for (int i = 0; i < 5; ++i) {
        stltsa_interval unit;
        must(stltsa_decomposition_unit(d, i, &unit));
        pieces[i] = (stltsa_piece){clip, unit.begin, unit.end, 1, 0};
    }
    stltsa_synthesis* s = made(pieces, 5, NULL);
    const stltsa_clip* again = stltsa_synthesis_clip(s);
    assert_int_equal(stltsa_synthesis_seam_count(s), 0);
    assert_int_equal(stltsa_synthesis_warning_count(s), 0);
    assert_int_equal(stltsa_clip_frames(again), stltsa_clip_frames(clip));
    assert_int_equal(stltsa_clip_format(again), STLTSA_FORMAT_BVH);
    assert_true(stltsa_clip_fps(again) == stltsa_clip_fps(clip));
    double *a = new_channels(clip), *b = new_channels(again);
    assert_same_bits(a, b, stltsa_clip_frames(clip) * stltsa_clip_channels(clip));
    free(a);
    free(b);
    stltsa_synthesis_free(s);
    stltsa_decomposition_free(d);
    stltsa_clip_free(clip);
}

static void one_piece_is_its_frames(void** state) {
    (void)state;
    stltsa_clip* clip = opened();
    const stltsa_piece piece = {clip, 100, 101, 1, 0};
    stltsa_synthesis* s = made(&piece, 1, NULL);
    assert_int_equal(stltsa_clip_frames(stltsa_synthesis_clip(s)), 1);
    const int64_t channels = stltsa_clip_channels(clip);
    double *a = new_channels(clip), *b = new_channels(stltsa_synthesis_clip(s));
    assert_same_bits(a + 100 * channels, b, channels);
    free(a);
    free(b);
    stltsa_synthesis_free(s);
    stltsa_clip_free(clip);
}

/* ---- A cycle again and again ---- */

static void a_cycle_four_times(void** state) {
    (void)state;
    stltsa_clip* clip = opened();
    const stltsa_interval cycle = middle_cycle(clip);
    const int64_t length = cycle.end - cycle.begin;
    const stltsa_piece piece = {clip, cycle.begin, cycle.end, 4, 0};
    stltsa_synthesis* s = made(&piece, 1, NULL);
    assert_int_equal(stltsa_synthesis_seam_count(s), 3);
    const stltsa_seam first = seam_of(s, 0);
    const int64_t loop = first.cut_end - first.cut_begin;
    assert_true(llabs(loop - length) <= 0.08 * (double)length);
    assert_int_equal(first.frame, first.cut_end - cycle.begin);
    for (int i = 0; i < 3; ++i) {
        const stltsa_seam seam = seam_of(s, i);
        assert_int_equal(seam.frame, first.frame + i * loop);
        assert_true(seam.piece == 0 && seam.next == 0);
        assert_true(seam.cut_end == first.cut_end && seam.cut_begin == first.cut_begin);
        assert_true(llabs(seam.cut_end - cycle.end) <= 0.1 * (double)length + 1);
        assert_int_equal(seam.crossfade, llround(0.1 * (double)length));
        /* The walker's cycles are the same, up to the frames that fall between frames. */
        assert_below(seam.posture, 1.5, "posture");
        assert_below(seam.step, 1.1, "step");
        assert_below(seam.acceleration, 1.2, "acceleration");
    }
    assert_int_equal(stltsa_clip_frames(stltsa_synthesis_clip(s)),
                     first.cut_end - cycle.begin + 2 * loop + cycle.end - first.cut_begin);
    assert_int_equal(stltsa_synthesis_warning_count(s), 0);
    stltsa_synthesis_free(s);
    stltsa_clip_free(clip);
}

/* Largest step of a joint on the floor from frame to frame. */
static double largest_step(const double* positions, int64_t frames, int64_t joints, int joint) {
    double largest = 0;
    for (int64_t i = 1; i < frames; ++i)
        largest = fmax(largest, distance(positions + (i * joints + joint) * 3,
                                         positions + ((i - 1) * joints + joint) * 3, floor_plane));
    return largest;
}

static void every_joint_goes_on_and_bones_stay_rigid(void** state) {
    (void)state;
    stltsa_clip* clip = opened();
    const stltsa_interval cycle = middle_cycle(clip);
    const stltsa_piece piece = {clip, cycle.begin, cycle.end, 4, 0};
    stltsa_synthesis* s = made(&piece, 1, NULL);
    const stltsa_clip* loop = stltsa_synthesis_clip(s);
    const int64_t joints = stltsa_clip_joints(clip), frames = stltsa_clip_frames(loop);
    double *a = new_positions(clip), *b = new_positions(loop);
    for (int j = 0; j < joints; ++j) {
        assert_below(largest_step(b, frames, joints, j),
                     1.1 * largest_step(a, stltsa_clip_frames(clip), joints, j), "step");
        int64_t parent = -1;
        must(stltsa_clip_joint(loop, j, NULL, &parent, NULL));
        if (parent < 0)
            continue;
        const double length = distance(a + 3 * j, a + 3 * parent, space);
        for (int64_t i = 0; i < frames; ++i)
            assert_below(
                fabs(distance(b + (i * joints + j) * 3, b + (i * joints + parent) * 3, space) -
                     length),
                1e-9, "length of a bone");
    }
    /* Each repetition goes as far as the source does. */
    const double* source = a + cycle.begin * joints * 3;
    const double way = distance(source, a + cycle.end * joints * 3, floor_plane);
    assert_below(fabs(distance(b, b + (frames - 1) * joints * 3, floor_plane) / (4 * way) - 1),
                 0.02, "way");
    free(a);
    free(b);
    stltsa_synthesis_free(s);
    stltsa_clip_free(clip);
}

static void a_loop_goes_on_from_and_into_its_neighbors(void** state) {
    (void)state;
    stltsa_clip* clip = opened();
    const stltsa_interval cycle = middle_cycle(clip);
    const int64_t n = stltsa_clip_frames(clip), channels = stltsa_clip_channels(clip);
    const stltsa_piece pieces[] = {{clip, 0, cycle.begin, 1, 0},
                                   {clip, cycle.begin, cycle.end, 3, 0},
                                   {clip, cycle.end, n, 1, 0}};
    stltsa_synthesis* s = made(pieces, 3, NULL);
    assert_int_equal(stltsa_synthesis_seam_count(s), 2);
    const stltsa_seam first = seam_of(s, 0), last = seam_of(s, 1);
    assert_true(first.piece == 1 && first.next == 1 && last.piece == 1 && last.next == 1);
    const int64_t frames = stltsa_clip_frames(stltsa_synthesis_clip(s));
    double *a = new_channels(clip), *b = new_channels(stltsa_synthesis_clip(s));
    /* Up to the first crossfade to the bit, and after the last in all but the root. */
    assert_same_bits(a, b, (first.frame - first.crossfade) * channels);
    const int64_t tail = frames - last.frame - last.crossfade;
    for (int64_t i = 1; i <= tail; ++i)
        assert_same_bits(a + (n - i) * channels + 6, b + (frames - i) * channels + 6, channels - 6);
    assert_int_equal(n - tail, last.cut_begin + last.crossfade);
    free(a);
    free(b);
    stltsa_synthesis_free(s);
    stltsa_clip_free(clip);
}

static void half_a_cycle_too_much_is_refused(void** state) {
    (void)state;
    stltsa_clip* clip = opened();
    const stltsa_interval cycle = middle_cycle(clip);
    const int64_t half = (cycle.end - cycle.begin) / 2;
    const stltsa_piece piece = {clip, cycle.begin, cycle.end + half, 2, 0};
    stltsa_synthesis* s = NULL;
    assert_int_equal(stltsa_synthesize(&piece, 1, NULL, &s), STLTSA_E_NO_COMMON_POSTURE);
    assert_null(s);
    assert_non_null(strstr(stltsa_last_error(), "pieces[0]"));
    assert_non_null(strstr(stltsa_last_error(), "seam at frame"));
    stltsa_options* options = with(STLTSA_POSTURE_LIMIT, 0);
    s = made(&piece, 1, options);
    assert_true(seam_of(s, 0).posture > 3);
    stltsa_synthesis_free(s);
    stltsa_options_free(options);
    stltsa_clip_free(clip);
}

/* ---- Clips joined ---- */

static void walks_on_from_where_it_stood(void** state) {
    (void)state;
    struct figure there = usual_figure;
    there.turn = 130;
    there.x = 1000;
    there.z = -400;
    stltsa_clip *here = new_figure(usual_figure), *far = new_figure(there);
    const stltsa_piece near_pieces[] = {{here, 0, 300, 1, 0}, {here, 100, 400, 1, 0}};
    const stltsa_piece far_pieces[] = {{here, 0, 300, 1, 0}, {far, 100, 400, 1, 0}};
    stltsa_synthesis *a = made(near_pieces, 2, NULL), *b = made(far_pieces, 2, NULL);
    const stltsa_clip *clip_a = stltsa_synthesis_clip(a), *clip_b = stltsa_synthesis_clip(b);
    const int64_t frames = stltsa_clip_frames(clip_a), joints = stltsa_clip_joints(clip_a);
    assert_int_equal(stltsa_clip_frames(clip_b), frames);
    double *x = new_positions(clip_a), *y = new_positions(clip_b), *source = new_positions(here);
    assert_below(largest_difference(x, y, frames * joints * 3), 1e-7, "where the later clip was");
    assert_below(largest_step(x, frames, joints, 0), 1.1 * largest_step(source, 480, joints, 0),
                 "step");
    /* It walks along z all the time: as far as the frames that it is made of. */
    const stltsa_seam seam = seam_of(a, 0);
    const double way = (double)(seam.cut_end + 400 - seam.cut_begin) / 120 * 120;
    assert_below(fabs(x[(frames - 1) * joints * 3 + 2] - way), 8, "way");
    assert_below(fabs(x[(frames - 1) * joints * 3]), 1, "to the side");
    free(x);
    free(y);
    free(source);
    stltsa_synthesis_free(a);
    stltsa_synthesis_free(b);
    stltsa_clip_free(here);
    stltsa_clip_free(far);
}

static void other_rates_are_resampled(void** state) {
    (void)state;
    struct figure slow = usual_figure;
    slow.fps = 60;
    slow.frames = 240;
    stltsa_clip *fast_clip = new_figure(usual_figure), *slow_clip = new_figure(slow);
    const stltsa_piece fast[] = {{fast_clip, 0, 300, 1, 0}, {fast_clip, 100, 400, 1, 0}};
    const stltsa_piece mixed[] = {{fast_clip, 0, 300, 1, 0}, {slow_clip, 50, 200, 1, 0}};
    stltsa_synthesis *a = made(fast, 2, NULL), *b = made(mixed, 2, NULL);
    const stltsa_clip *clip_a = stltsa_synthesis_clip(a), *clip_b = stltsa_synthesis_clip(b);
    assert_true(has_warning(b, "resampled"));
    assert_false(has_warning(a, "resampled"));
    assert_true(stltsa_clip_fps(clip_b) == 120);
    assert_int_equal(seam_of(b, 0).cut_end, seam_of(a, 0).cut_end);
    assert_int_equal(seam_of(b, 0).cut_begin, seam_of(a, 0).cut_begin);
    assert_int_equal(stltsa_clip_frames(clip_a), stltsa_clip_frames(clip_b));
    double *x = new_positions(clip_a), *y = new_positions(clip_b);
    const int64_t count = stltsa_clip_frames(clip_a) * stltsa_clip_joints(clip_a) * 3;
    assert_below(largest_difference(x, y, count), 0.1, "resampled");
    free(x);
    free(y);
    stltsa_synthesis_free(a);
    stltsa_synthesis_free(b);
    stltsa_clip_free(fast_clip);
    stltsa_clip_free(slow_clip);
}

static void refuses(const stltsa_clip* first, struct figure other, stltsa_status status,
                    const char* word) {
    stltsa_clip* clip = new_figure(other);
    const stltsa_piece pieces[] = {{first, 0, 300, 1, 0}, {clip, 0, 300, 1, 0}};
    stltsa_synthesis* s = (stltsa_synthesis*)&pieces; /* must become NULL */
    assert_int_equal(stltsa_synthesize(pieces, 2, NULL, &s), status);
    assert_null(s);
    if (strstr(stltsa_last_error(), word) == NULL)
        print_error("\"%s\" is not in: %s\n", word, stltsa_last_error());
    assert_non_null(strstr(stltsa_last_error(), word));
    stltsa_clip_free(clip);
}

static void other_bodies_are_refused(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    struct figure other = usual_figure;
    other.head = "Kopf";
    refuses(clip, other, STLTSA_E_UNSUPPORTED, "\"Kopf\"");
    other = usual_figure;
    other.order = "Xrotation Yrotation Zrotation";
    refuses(clip, other, STLTSA_E_UNSUPPORTED, "\"Head\"");
    other = usual_figure;
    other.arm_length = 31;
    refuses(clip, other, STLTSA_E_UNSUPPORTED, "1 %");
    stltsa_clip* walker = opened();
    const stltsa_piece pieces[] = {{clip, 0, 300, 1, 0}, {walker, 0, 300, 1, 0}};
    stltsa_synthesis* s = NULL;
    assert_int_equal(stltsa_synthesize(pieces, 2, NULL, &s), STLTSA_E_UNSUPPORTED);
    assert_non_null(strstr(stltsa_last_error(), "joints"));
    stltsa_clip_free(walker);

    other = usual_figure;
    other.arm_length = 30.1;
    stltsa_clip* alike = new_figure(other);
    const stltsa_piece joined[] = {{clip, 0, 300, 1, 0}, {alike, 100, 400, 1, 0}};
    s = made(joined, 2, NULL);
    assert_true(has_warning(s, "offsets"));
    stltsa_synthesis_free(s);
    stltsa_clip_free(alike);
    stltsa_clip_free(clip);
}

static void no_common_posture_is_refused(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    struct figure other = usual_figure;
    other.arms = 90;
    refuses(clip, other, STLTSA_E_NO_COMMON_POSTURE, "posture_limit");
    other.still = 1;
    refuses(clip, other, STLTSA_E_NO_COMMON_POSTURE, "posture_limit");
    stltsa_clip *raised = new_figure(other), *hanging;
    other.arms = 0;
    hanging = new_figure(other);
    /* Two bodies that stand still: there is nothing to measure a difference by. */
    const stltsa_piece pieces[] = {{raised, 0, 300, 1, 0}, {hanging, 0, 300, 1, 0}};
    stltsa_synthesis* s = NULL;
    assert_int_equal(stltsa_synthesize(pieces, 2, NULL, &s), STLTSA_E_NO_COMMON_POSTURE);
    stltsa_options* options = with(STLTSA_POSTURE_LIMIT, 0);
    s = made(pieces, 2, options);
    const stltsa_seam seam = seam_of(s, 0);
    assert_true(isfinite(seam.posture) && isfinite(seam.step) && isfinite(seam.acceleration));
    assert_true(has_warning(s, "as fast as"));
    stltsa_synthesis_free(s);
    const stltsa_piece same[] = {{hanging, 0, 100, 1, 0}, {hanging, 200, 300, 1, 0}};
    s = made(same, 2, NULL);
    assert_below(seam_of(s, 0).posture, 1e-6, "posture");
    assert_below(seam_of(s, 0).step, 1e-6, "step");
    stltsa_synthesis_free(s);
    stltsa_options_free(options);
    stltsa_clip_free(raised);
    stltsa_clip_free(hanging);
    stltsa_clip_free(clip);
}

/* ---- Options ---- */

static void no_search_cuts_where_the_pieces_end(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    stltsa_options* options = with(STLTSA_SEARCH, 0);
    must(stltsa_options_set_real(options, STLTSA_CROSSFADE, 0.05));
    must(stltsa_options_set_real(options, STLTSA_POSTURE_LIMIT, 0));
    const stltsa_piece pieces[] = {{clip, 20, 300, 1, 0}, {clip, 100, 400, 2, 0}};
    stltsa_synthesis* s = made(pieces, 2, options);
    const stltsa_seam join = seam_of(s, 0), loop = seam_of(s, 1);
    assert_true(join.cut_end == 300 && join.cut_begin == 100 && join.frame == 280);
    assert_true(join.piece == 0 && join.next == 1 && join.crossfade == 6);
    assert_true(loop.cut_end == 400 && loop.cut_begin == 100 && loop.frame == 580);
    assert_int_equal(stltsa_clip_frames(stltsa_synthesis_clip(s)), 880);
    stltsa_synthesis_free(s);
    stltsa_options_free(options);
    stltsa_clip_free(clip);
}

static void where_the_clip_ends_nothing_is_blended(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    stltsa_options* options = with(STLTSA_SEARCH, 0);
    const stltsa_piece piece = {clip, 0, 480, 2, 0};
    stltsa_synthesis* s = made(&piece, 1, options);
    assert_int_equal(seam_of(s, 0).crossfade, 0);
    assert_true(has_warning(s, "blended"));
    assert_int_equal(stltsa_clip_frames(stltsa_synthesis_clip(s)), 960);
    /* Four whole cycles: the step across the seam is one like the others. */
    double* x = new_positions(stltsa_synthesis_clip(s));
    const int64_t joints = stltsa_clip_joints(clip);
    const double step = distance(x + 480 * joints * 3, x + 479 * joints * 3, floor_plane);
    assert_below(fabs(step - 1.3), 0.2, "step");
    free(x);
    stltsa_synthesis_free(s);
    /* No crossfade wanted, none missed. */
    must(stltsa_options_set_real(options, STLTSA_CROSSFADE, 0));
    s = made(&piece, 1, options);
    assert_false(has_warning(s, "blended"));
    stltsa_synthesis_free(s);
    stltsa_options_free(options);
    stltsa_clip_free(clip);
}

static void short_pieces_keep_half_their_length(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    stltsa_options* options = with(STLTSA_POSTURE_LIMIT, 0);
    must(stltsa_options_set_real(options, STLTSA_SEARCH, 3));
    must(stltsa_options_set_real(options, STLTSA_CROSSFADE, 3));
    const int64_t lengths[] = {1, 2, 3, 5, 8, 40};
    for (int l = 0; l < 6; ++l) {
        const int64_t length = lengths[l];
        const stltsa_piece pieces[] = {{clip, 10, 10 + length, 3, 0},
                                       {clip, 300, 300 + length, 2, 0},
                                       {clip, 200, 200 + length, 1, 0}};
        stltsa_synthesis* s = made(pieces, 3, options);
        const int64_t count = stltsa_synthesis_seam_count(s);
        assert_int_equal(count, 5);
        int64_t before = 0;
        for (int64_t i = 0; i <= count; ++i) {
            const int64_t frame =
                i < count ? seam_of(s, i).frame : stltsa_clip_frames(stltsa_synthesis_clip(s));
            assert_true(2 * (frame - before) >= length);
            before = frame;
        }
        stltsa_synthesis_free(s);
    }
    stltsa_options_free(options);
    stltsa_clip_free(clip);
}

static int32_t refuse(void* user, int32_t stage, double fraction) {
    (void)fraction;
    return stage == *(int32_t*)user;
}

static void progress_can_cancel(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    const stltsa_piece piece = {clip, 100, 220, 2, 0};
    for (int32_t stage = STLTSA_STAGE_FEATURES; stage <= STLTSA_STAGE_SYNTHESIS;
         stage += STLTSA_STAGE_SYNTHESIS - STLTSA_STAGE_FEATURES) {
        stltsa_options* options = NULL;
        must(stltsa_options_new(&options));
        must(stltsa_options_set_progress(options, refuse, &stage));
        stltsa_synthesis* s = NULL;
        assert_int_equal(stltsa_synthesize(&piece, 1, options, &s), STLTSA_E_CANCELLED);
        assert_null(s);
        stltsa_options_free(options);
    }
    stltsa_clip_free(clip);
}

/* ---- Wrong use ---- */

static void wrong(const stltsa_piece* pieces, int64_t count, stltsa_status status,
                  const char* word) {
    stltsa_synthesis* s = NULL;
    assert_int_equal(stltsa_synthesize(pieces, count, NULL, &s), status);
    assert_null(s);
    if (strstr(stltsa_last_error(), word) == NULL)
        print_error("\"%s\" is not in: %s\n", word, stltsa_last_error());
    assert_non_null(strstr(stltsa_last_error(), word));
}

static void wrong_pieces(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    const stltsa_piece right = {clip, 0, 300, 1, 0};
    wrong(NULL, 1, STLTSA_E_ARGUMENT, "pieces is NULL");
    wrong(&right, 0, STLTSA_E_ARGUMENT, "count is 0");
    wrong(&right, -1, STLTSA_E_ARGUMENT, "count is -1");
    assert_int_equal(stltsa_synthesize(&right, 1, NULL, NULL), STLTSA_E_ARGUMENT);
    const struct {
        stltsa_piece piece;
        const char* word;
    } cases[] = {
        {{NULL, 0, 1, 1, 0}, "pieces[1].clip is NULL"},
        {{clip, 0, 300, 1, 7}, "reserved is 7"},
        {{clip, -1, 300, 1, 0}, "[-1, 300)"},
        {{clip, 300, 300, 1, 0}, "[300, 300)"},
        {{clip, 300, 20, 1, 0}, "[300, 20)"},
        {{clip, 0, 481, 1, 0}, "480 frames"},
        {{clip, 0, 300, 0, 0}, "repeated 0 times"},
        {{clip, 0, 300, -3, 0}, "repeated -3 times"},
        {{clip, 0, 300, INT64_MAX, 0}, "repeat less"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const stltsa_piece pieces[] = {right, cases[i].piece};
        wrong(pieces, 2, STLTSA_E_ARGUMENT, cases[i].word);
    }
    double* x = new_motion(100, 6, 1);
    const stltsa_in in = packed_in(x, 100, 6);
    stltsa_clip* bare = NULL;
    must(stltsa_clip_from_matrix(&in, 30, &bare));
    const stltsa_piece numbers = {bare, 0, 100, 1, 0};
    wrong(&numbers, 1, STLTSA_E_UNSUPPORTED, "skeleton");
    stltsa_clip_free(bare);
    free(x);
    stltsa_clip_free(clip);
}

static void wrong_questions(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    const stltsa_piece piece = {clip, 100, 220, 2, 0};
    stltsa_synthesis* s = made(&piece, 1, NULL);
    stltsa_seam seam = {.size = sizeof seam};
    assert_int_equal(stltsa_synthesis_seam(NULL, 0, &seam), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_synthesis_seam(s, 0, NULL), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_synthesis_seam(s, 1, &seam), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_synthesis_seam(s, -1, &seam), STLTSA_E_ARGUMENT);
    seam.size = 0;
    assert_int_equal(stltsa_synthesis_seam(s, 0, &seam), STLTSA_E_ARGUMENT);
    /* A caller of an older library: the fields it knows and no byte more. */
    seam.size = offsetof(stltsa_seam, posture);
    seam.posture = -7;
    must(stltsa_synthesis_seam(s, 0, &seam));
    assert_true(seam.posture == -7 && seam.size == offsetof(stltsa_seam, posture));
    assert_true(seam.frame > 0 && seam.crossfade > 0);
    assert_string_equal(stltsa_synthesis_warning(s, 99), "");
    assert_string_equal(stltsa_synthesis_warning(s, -1), "");
    assert_int_equal(stltsa_synthesis_seam_count(NULL), 0);
    assert_int_equal(stltsa_synthesis_warning_count(NULL), 0);
    assert_null(stltsa_synthesis_clip(NULL));
    char* json = NULL;
    assert_int_equal(stltsa_synthesis_json(NULL, &json), STLTSA_E_ARGUMENT);
    assert_int_equal(stltsa_synthesis_json(s, NULL), STLTSA_E_ARGUMENT);
    must(stltsa_synthesis_json(s, &json));
    assert_non_null(strstr(json, "\"format\":\"stltsa-synthesis/1\""));
    stltsa_string_free(json);
    stltsa_synthesis_free(NULL);
    stltsa_synthesis_free(s);
    stltsa_clip_free(clip);
}

static void the_same_bits_every_time(void** state) {
    (void)state;
    stltsa_clip* clip = new_figure(usual_figure);
    const stltsa_piece pieces[] = {{clip, 0, 200, 1, 0}, {clip, 100, 220, 3, 0}};
    stltsa_synthesis *a = made(pieces, 2, NULL), *b = made(pieces, 2, NULL);
    const stltsa_clip* clip_a = stltsa_synthesis_clip(a);
    double *x = new_channels(clip_a), *y = new_channels(stltsa_synthesis_clip(b));
    assert_same_bits(x, y, stltsa_clip_frames(clip_a) * stltsa_clip_channels(clip_a));
    free(x);
    free(y);
    stltsa_synthesis_free(a);
    stltsa_synthesis_free(b);
    stltsa_clip_free(clip);
}

int main(int argc, char** argv) {
    if (argc != 2) {
        print_error("usage: %s WALK.BVH\n", argv[0]);
        return 2;
    }
    walker_path = argv[1];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units_give_the_clip_back),
        cmocka_unit_test(one_piece_is_its_frames),
        cmocka_unit_test(a_cycle_four_times),
        cmocka_unit_test(every_joint_goes_on_and_bones_stay_rigid),
        cmocka_unit_test(a_loop_goes_on_from_and_into_its_neighbors),
        cmocka_unit_test(half_a_cycle_too_much_is_refused),
        cmocka_unit_test(walks_on_from_where_it_stood),
        cmocka_unit_test(other_rates_are_resampled),
        cmocka_unit_test(other_bodies_are_refused),
        cmocka_unit_test(no_common_posture_is_refused),
        cmocka_unit_test(no_search_cuts_where_the_pieces_end),
        cmocka_unit_test(where_the_clip_ends_nothing_is_blended),
        cmocka_unit_test(short_pieces_keep_half_their_length),
        cmocka_unit_test(progress_can_cancel),
        cmocka_unit_test(wrong_pieces),
        cmocka_unit_test(wrong_questions),
        cmocka_unit_test(the_same_bits_every_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
