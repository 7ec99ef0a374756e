/* SPDX-License-Identifier: BSD-3-Clause */
/* Motion that cannot be made, and wrong usage. */
#include "walking.h"

/* ---- Incompatible clips ---- */

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
    /* Two bodies that stand still: there is no scale for a difference. */
    const stltsa_piece pieces[] = {{raised, 0, 300, 1, 0}, {hanging, 0, 300, 1, 0}};
    stltsa_synthesis* s = NULL;
    assert_int_equal(stltsa_synthesize(pieces, 2, NULL, &s), STLTSA_E_NO_COMMON_POSTURE);
    stltsa_options* options = with(STLTSA_OPT_POSTURE_LIMIT, 0);
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

/* ---- Wrong usage ---- */

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
        {{clip, 0, 300, 0, 0}, "repeat 0;"},
        {{clip, 0, 300, -3, 0}, "repeat -3;"},
        {{clip, 0, 300, INT64_MAX, 0}, "use fewer repetitions"},
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
    /* A caller built for an older library: only the fields that it knows. */
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
    stltsa_free(json);
    stltsa_synthesis_free(NULL);
    stltsa_synthesis_free(s);
    stltsa_clip_free(clip);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(other_bodies_are_refused),
        cmocka_unit_test(no_common_posture_is_refused),
        cmocka_unit_test(wrong_pieces),
        cmocka_unit_test(wrong_questions),
    };
    return run_on_walker(tests, argc, argv);
}
