/* SPDX-License-Identifier: BSD-3-Clause */
/* Motion that cannot be made, and wrong usage. */
#include "walking.h"

/* ---- Incompatible clips ---- */

static void refuses(const stltsa_clip* first, struct figure other, stltsa_status status,
                    const char* word) {
    stltsa_clip* clip = new_figure(other);
    const stltsa_piece pieces[] = {{first, 0, 300, 1, 0}, {clip, 0, 300, 1, 0}};
    stltsa_synthesis* s = (stltsa_synthesis*)&pieces; /* must become NULL */
    must_fail(stltsa_synthesize(pieces, 2, NULL, &s), status, word);
    assert_null(s);
}

TEST(other_bodies_are_refused) {
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
    must_fail(stltsa_synthesize(pieces, 2, NULL, &s), STLTSA_E_UNSUPPORTED, "joints");

    other = usual_figure;
    other.arm_length = 30.1;
    stltsa_clip* alike = new_figure(other);
    const stltsa_piece joined[] = {{clip, 0, 300, 1, 0}, {alike, 100, 400, 1, 0}};
    s = made(joined, 2, NULL);
    assert_true(warnings_of(s, "offsets"));
}

TEST(no_common_posture_is_refused) {
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
    const stltsa_seam seam = seam_at(s, 0);
    assert_true(isfinite(seam.posture) && isfinite(seam.step) && isfinite(seam.acceleration));
    assert_true(warnings_of(s, "as fast as"));
    const stltsa_piece same[] = {{hanging, 0, 100, 1, 0}, {hanging, 200, 300, 1, 0}};
    s = made(same, 2, NULL);
    assert_below(seam_at(s, 0).posture, 1e-6, "posture");
    assert_below(seam_at(s, 0).step, 1e-6, "step");
}

/* ---- Wrong usage ---- */

static void wrong(const stltsa_piece* pieces, int64_t count, stltsa_status status,
                  const char* word) {
    stltsa_synthesis* s = NULL;
    must_fail(stltsa_synthesize(pieces, count, NULL, &s), status, word);
    assert_null(s);
}

TEST(wrong_pieces) {
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
    stltsa_clip* bare = matrix_clip(x, 100, 6, 30);
    const stltsa_piece numbers = {bare, 0, 100, 1, 0};
    wrong(&numbers, 1, STLTSA_E_UNSUPPORTED, "skeleton");
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(other_bodies_are_refused),
        cmocka_unit_test(no_common_posture_is_refused),
        cmocka_unit_test(wrong_pieces),
    };
    return run_on_walker(tests, argc, argv);
}
