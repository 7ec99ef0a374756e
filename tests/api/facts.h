/* SPDX-License-Identifier: BSD-3-Clause */
/* Facts, rows and arrays of handles in one expression each, for calls that must succeed; and the
 * handles that most tests start from. */
#ifndef STLTSA_TESTS_UNIT_FACTS_H
#define STLTSA_TESTS_UNIT_FACTS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "stltsa.h"

/* A test that needs no fixture. */
#define TEST(name) static void name(void** state __attribute__((unused)))

static inline void must(stltsa_status status) {
    if (status != STLTSA_OK)
        print_error("%s: %s\n", stltsa_status_name(status), stltsa_last_error());
    assert_int_equal(status, STLTSA_OK);
}

/* The call failed with this status, and its text has these words. */
static inline void must_fail(stltsa_status status, stltsa_status expected, const char* words) {
    if (status != expected || strstr(stltsa_last_error(), words) == NULL)
        fail_msg("%s instead of %s with \"%s\": %s", stltsa_status_name(status),
                 stltsa_status_name(expected), words, stltsa_last_error());
}

/* What the functions below make is freed when the program ends, so no test need free it. */
typedef void release_fn(void* made);

struct kept {
    struct kept* before;
    void* made;
    release_fn* release;
};
static _Atomic(struct kept*) all_kept; /* any thread may keep something */

static inline void release_all(void) {
    while (all_kept != NULL) {
        struct kept* last = all_kept;
        all_kept = last->before;
        last->release(last->made);
        free(last);
    }
}

static inline void* keep(void* made, release_fn* release) {
    struct kept* now = malloc(sizeof *now);
    assert_non_null(now);
    *now = (struct kept){all_kept, made, release};
    while (!atomic_compare_exchange_weak(&all_kept, &now->before, now))
        ;
    if (now->before == NULL)
        assert_int_equal(atexit(release_all), 0);
    return made;
}

/* keep_clip(clip) and so on. */
#define KEEPER(kind)                                                                               \
    static inline void release_##kind(void* made) {                                                \
        stltsa_##kind##_free(made);                                                                \
    }                                                                                              \
    static inline stltsa_##kind* keep_##kind(stltsa_##kind* made) {                                \
        return keep(made, release_##kind);                                                         \
    }
KEEPER(options)
KEEPER(clip)
KEEPER(model)
KEEPER(decomposition)
KEEPER(phase)
KEEPER(synthesis)
KEEPER(cycles)
KEEPER(events)
KEEPER(comparison)
KEEPER(denoising)
KEEPER(live)

/* A rows x cols matrix of doubles, packed rows. */
static inline double* new_matrix(int64_t rows, int64_t cols) {
    double* values = calloc((size_t)(rows * cols), sizeof *values);
    assert_non_null(values);
    return keep(values, free);
}

static inline stltsa_in packed_in(const double* x, int64_t rows, int64_t cols) {
    const stltsa_in in = {x, rows, cols, 0, 0, STLTSA_F64, 0};
    return in;
}

static inline stltsa_out packed_out(double* x, int64_t rows, int64_t cols) {
    const stltsa_out out = {x, rows, cols, 0, 0, STLTSA_F64, 0};
    return out;
}

/* A list, one entry a row. */
static inline stltsa_in list_in(const int64_t* x, int64_t rows) {
    const stltsa_in in = {x, rows, 1, 0, 0, STLTSA_I64, 0};
    return in;
}

static inline stltsa_out list_out(int64_t* x, int64_t rows) {
    const stltsa_out out = {x, rows, 1, 0, 0, STLTSA_I64, 0};
    return out;
}

/* ---- Facts and arrays of any handle ---- */

#define INFO_OF(kind)                                                                              \
    stltsa_##kind* : stltsa_##kind##_info, const stltsa_##kind* : stltsa_##kind##_info
#define info_of(handle)                                                                            \
    _Generic((handle), INFO_OF(clip), INFO_OF(model), INFO_OF(phase), INFO_OF(decomposition),      \
             INFO_OF(denoising), INFO_OF(synthesis), INFO_OF(cycles), INFO_OF(events),             \
             INFO_OF(comparison), INFO_OF(live))(handle)

static inline int64_t get_int(const stltsa_info* info, int32_t key, int64_t index) {
    int64_t value = -1;
    must(stltsa_info_int(info, key, index, &value));
    return value;
}

static inline double get_real(const stltsa_info* info, int32_t key, int64_t index) {
    double value = -1;
    must(stltsa_info_real(info, key, index, &value));
    return value;
}

static inline const char* get_text(const stltsa_info* info, int32_t key, int64_t index) {
    const char* value = NULL;
    must(stltsa_info_text(info, key, index, &value));
    return value;
}

static inline double* get_array(const stltsa_info* info, int32_t key, int64_t index) {
    int64_t rows = 0, cols = 0;
    must(stltsa_info_shape(info, key, &rows, &cols));
    double* values = new_matrix(rows, cols);
    const stltsa_out out = packed_out(values, rows, cols);
    must(stltsa_info_array(info, key, index, &out));
    return values;
}

static inline int64_t* get_whole(const stltsa_info* info, int32_t key) {
    int64_t rows = 0, cols = 0;
    must(stltsa_info_shape(info, key, &rows, &cols));
    assert_int_equal(cols, 1);
    int64_t* values = keep(calloc((size_t)rows, sizeof *values), free);
    const stltsa_out out = list_out(values, rows);
    must(stltsa_info_array(info, key, 0, &out));
    return values;
}

static inline char* get_json(const stltsa_info* info) {
    char* json = NULL;
    must(stltsa_info_json(info, &json));
    return keep(json, stltsa_free);
}

static inline stltsa_warning get_warning(const stltsa_info* info, int64_t index) {
    stltsa_warning warning;
    must(stltsa_info_rows(info, STLTSA_INFO_WARNING, index, 1, &warning, sizeof warning));
    return warning;
}

/* How many warnings have these words. */
static inline int64_t get_warnings(const stltsa_info* info, const char* words) {
    int64_t found = 0;
    for (int64_t i = 0; i < stltsa_info_count(info, STLTSA_INFO_WARNING); ++i)
        found += strstr(get_warning(info, i).text, words) != NULL;
    return found;
}

#define count_of(handle, key) stltsa_info_count(info_of(handle), key)
#define int_of(handle, key) get_int(info_of(handle), key, 0)
#define real_of(handle, key) get_real(info_of(handle), key, 0)
#define text_of(handle, key) get_text(info_of(handle), key, 0)
#define array_of(handle, key) get_array(info_of(handle), key, 0)
#define whole_of(handle, key) get_whole(info_of(handle), key)
#define json_of(handle) get_json(info_of(handle))
#define warnings_of(handle, words) get_warnings(info_of(handle), words)

/* ---- Rows ---- */

#define ROW_READER(name, handle, row_type, key)                                                    \
    static inline row_type name(const stltsa_##handle* of, int64_t index) {                        \
        row_type row;                                                                              \
        must(stltsa_info_rows(stltsa_##handle##_info(of), key, index, 1, &row, sizeof row));       \
        return row;                                                                                \
    }
ROW_READER(joint_at, clip, stltsa_joint, STLTSA_INFO_JOINT)
ROW_READER(file_event_at, clip, stltsa_file_event, STLTSA_INFO_FILE_EVENT)
ROW_READER(component_at, model, stltsa_component, STLTSA_INFO_COMPONENT)
ROW_READER(segment_at, decomposition, stltsa_segment, STLTSA_INFO_SEGMENT)
ROW_READER(unit_at, decomposition, stltsa_unit, STLTSA_INFO_UNIT)
ROW_READER(cycle_at, decomposition, stltsa_part, STLTSA_INFO_CYCLE)
ROW_READER(repetition_at, decomposition, stltsa_part, STLTSA_INFO_REPETITION)
ROW_READER(summary_at, decomposition, stltsa_summary, STLTSA_INFO_SUMMARY)
ROW_READER(event_at, events, stltsa_event, STLTSA_INFO_EVENT)
ROW_READER(motion_at, comparison, stltsa_compared_motion, STLTSA_INFO_MOTION)
ROW_READER(part_at, comparison, stltsa_compared_part, STLTSA_INFO_PART)
ROW_READER(channel_at, comparison, stltsa_compared_part, STLTSA_INFO_PART_CHANNEL)
ROW_READER(column_at, denoising, stltsa_denoised_column, STLTSA_INFO_COLUMN)
ROW_READER(seam_at, synthesis, stltsa_seam, STLTSA_INFO_SEAM)

static inline stltsa_compared compared_of(const stltsa_comparison* of) {
    stltsa_compared row;
    must(stltsa_info_rows(stltsa_comparison_info(of), STLTSA_INFO_COMPARISON, 0, 1, &row,
                          sizeof row));
    return row;
}

/* ---- Handles ---- */

static inline stltsa_options* empty_options(void) {
    stltsa_options* options = NULL;
    must(stltsa_options_new(&options));
    return keep_options(options);
}

static inline stltsa_options* with_int(int32_t key, int64_t value) {
    stltsa_options* options = empty_options();
    must(stltsa_options_set_int(options, key, value));
    return options;
}

static inline stltsa_options* with(int32_t key, double value) {
    stltsa_options* options = empty_options();
    must(stltsa_options_set_real(options, key, value));
    return options;
}

static inline stltsa_options* with_progress(stltsa_progress_fn progress, void* user) {
    stltsa_options* options = empty_options();
    must(stltsa_options_set_progress(options, progress, user));
    return options;
}

/* A progress callback that cancels after *(int32_t*)user more calls. */
static inline int32_t cancel_after(void* user, int32_t stage, double fraction) {
    (void)stage;
    (void)fraction;
    int32_t* left = user;
    return (*left)-- == 0;
}

/* Cancels `call` at its first progress callback, the second, ... until it succeeds; returns how
 * often it was cancelled. */
static inline int32_t cancelled_calls(stltsa_status (*call)(void* user, const stltsa_options*),
                                      void* user) {
    int32_t left = 0;
    stltsa_options* options = with_progress(cancel_after, &left);
    for (int32_t cancelled = 0;; ++cancelled) {
        left = cancelled;
        const stltsa_status status = call(user, options);
        if (status == STLTSA_E_CANCELLED && cancelled < 1000)
            continue;
        must(status);
        return cancelled;
    }
}

/* Set by main() of the tests that are given the walker's BVH file. */
static const char* walker_path;

static inline stltsa_clip* opened(void) {
    stltsa_clip* clip = NULL;
    must(stltsa_clip_open(walker_path, NULL, &clip));
    return keep_clip(clip);
}

static inline stltsa_clip* matrix_clip(const double* x, int64_t rows, int64_t cols, double fps) {
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_clip* clip = NULL;
    must(stltsa_clip_from_matrix(&in, fps, &clip));
    return keep_clip(clip);
}

static inline stltsa_decomposition* decomposed(const stltsa_clip* clip,
                                               const stltsa_options* options) {
    stltsa_decomposition* found = NULL;
    must(stltsa_decompose(clip, options, &found));
    return keep_decomposition(found);
}

static inline stltsa_phase* phase_of(const stltsa_clip* clip, const stltsa_options* options) {
    stltsa_decomposition* found = NULL;
    stltsa_phase* phase = NULL;
    must(stltsa_decompose(clip, options, &found));
    must(stltsa_phase_find(found, options, &phase));
    stltsa_decomposition_free(found);
    return keep_phase(phase);
}

static inline stltsa_model* fitted_clip(const stltsa_clip* clip, const stltsa_options* options) {
    stltsa_model* model = NULL;
    must(stltsa_fit_clips(&clip, 1, options, &model));
    return keep_model(model);
}

static inline stltsa_model* fitted_rows(const double* x, int64_t rows, int64_t cols,
                                        const stltsa_options* options) {
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_model* model = NULL;
    must(stltsa_fit(&in, NULL, options, &model));
    return keep_model(model);
}

/* A clip with what is found in it. */
struct walk {
    stltsa_clip* clip;
    stltsa_decomposition* found;
    stltsa_phase* phase;
};

static inline struct walk walk_of(stltsa_clip* clip) {
    struct walk w = {clip, decomposed(clip, NULL), NULL};
    must(stltsa_phase_find(w.found, NULL, &w.phase));
    keep_phase(w.phase);
    return w;
}

/* Features of every frame; the file's own numbers. */
static inline double* new_features(const stltsa_clip* clip, const stltsa_options* options,
                                   int64_t* cols) {
    must(stltsa_clip_feature_count(clip, options, cols));
    double* values = new_matrix(stltsa_clip_frames(clip), *cols);
    const stltsa_out out = packed_out(values, stltsa_clip_frames(clip), *cols);
    must(stltsa_clip_features(clip, options, &out));
    return values;
}

static inline double* new_channels(const stltsa_clip* clip) {
    stltsa_options* raw = with_int(STLTSA_OPT_FEATURES, STLTSA_FEATURES_RAW);
    int64_t cols = 0;
    double* values = new_features(clip, raw, &cols);
    return values;
}

/* Runs the tests on the walker named on the command line. */
#define run_on_walker(tests, argc, argv)                                                           \
    ((argc) == 2 ? (walker_path = (argv)[1], cmocka_run_group_tests(tests, NULL, NULL))            \
                 : (print_error("usage: %s WALK.BVH\n", (argv)[0]), 2))

#endif
