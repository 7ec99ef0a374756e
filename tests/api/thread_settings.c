/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls start no team of OpenMP, and leave the settings of OpenMP and OpenBLAS as they were,
 * whether they succeed, fail or are cancelled. tests/oom checks the same if memory runs out.
 * meson.build sets OMP_NUM_THREADS, so that a team of OpenMP would be larger than those of
 * OpenBLAS. */
#define _GNU_SOURCE
#include <dlfcn.h>

#include "fit_threads.h"

enum { rows = 600, cols = 12, d = 2 };

/* Functions of the libraries that this process loaded; NULL without that library. */
static int (*get_blas_threads)(void), (*get_omp_levels)(void), (*get_omp_threads)(void);

static void (*set_blas_threads)(int), (*set_omp_levels)(int), (*set_omp_threads)(int);

static int find_functions(void** state) {
    (void)state;
    *(void**)&get_blas_threads = dlsym(RTLD_DEFAULT, "openblas_get_num_threads");
    *(void**)&set_blas_threads = dlsym(RTLD_DEFAULT, "openblas_set_num_threads");
    *(void**)&get_omp_levels = dlsym(RTLD_DEFAULT, "omp_get_max_active_levels");
    *(void**)&set_omp_levels = dlsym(RTLD_DEFAULT, "omp_set_max_active_levels");
    *(void**)&get_omp_threads = dlsym(RTLD_DEFAULT, "omp_get_max_threads");
    *(void**)&set_omp_threads = dlsym(RTLD_DEFAULT, "omp_set_num_threads");
    printf("OpenBLAS: %s, OpenMP: %s\n", get_blas_threads ? "yes" : "no",
           get_omp_levels ? "yes" : "no");
    return 0;
}

/* The most threads that existed during the callbacks, and the callbacks until the call is
 * cancelled. */
struct progress {
    int most_threads, most_blas_threads, left;
};

static int32_t watch(void* user, int32_t stage, double fraction) {
    (void)stage;
    (void)fraction;
    struct progress* progress = user;
    const int now = count_threads();
    if (now > progress->most_threads)
        progress->most_threads = now;
    if (get_blas_threads != NULL && get_blas_threads() > progress->most_blas_threads)
        progress->most_blas_threads = get_blas_threads();
    return progress->left-- == 0;
}

static stltsa_status fit(const double* x, int64_t mode, struct progress* progress) {
    const stltsa_in in = packed_in(x, rows, cols);
    return fit_in_mode(&in, mode, 1, watch, progress);
}

/* Threads of a team of OpenMP remain after it ends. */
TEST(no_team_of_openmp) {
    double* x = new_motion(rows, cols, 28);
    const int before = count_threads();
    for (int m = 0; m < 3; ++m) {
        struct progress progress = {0, 0, -1};
        must(fit(x, all_modes[m], &progress));
        assert_int_equal(progress.most_threads, before);
        assert_int_equal(count_threads(), before);
    }
}

enum { blas_threads = 2, omp_levels = 3, omp_threads = 5 };

static void set_all(void) {
    if (set_blas_threads != NULL)
        set_blas_threads(blas_threads);
    if (set_omp_levels != NULL) {
        set_omp_levels(omp_levels);
        set_omp_threads(omp_threads);
    }
}

static void check_all(void) {
    if (get_blas_threads != NULL)
        assert_int_equal(get_blas_threads(), blas_threads);
    if (get_omp_levels != NULL) {
        assert_int_equal(get_omp_levels(), omp_levels);
        assert_int_equal(get_omp_threads(), omp_threads);
    }
}

/* Cancels at the first callback, then at the second, and so on, until the fit succeeds. */
TEST(settings_remain_if_cancelled) {
    double* x = new_motion(rows, cols, 28);
    set_all();
    for (int m = 0; m < 3; ++m) {
        stltsa_status status = STLTSA_E_CANCELLED;
        for (int at = 0; status == STLTSA_E_CANCELLED; ++at) {
            struct progress progress = {0, 0, at};
            status = fit(x, all_modes[m], &progress);
            check_all();
        }
        must(status);
    }
}

/* Also if the library is linked with -lblas and OpenBLAS is what this process loaded. */
TEST(openblas_has_one_thread_during_a_fit) {
    double* x = new_motion(rows, cols, 28);
    assert_int_equal(stltsa_has(STLTSA_HAS_OPENBLAS), get_blas_threads != NULL);
    set_all();
    for (int m = 0; m < 3; ++m) {
        struct progress progress = {0, 0, -1};
        must(fit(x, all_modes[m], &progress));
        assert_int_equal(progress.most_blas_threads, get_blas_threads != NULL);
    }
}

TEST(settings_remain_after_an_error) {
    double* x = new_motion(rows, cols, 28);
    set_all();
    x[rows * cols / 2] = NAN;
    for (int m = 0; m < 3; ++m) {
        struct progress progress = {0, 0, -1};
        assert_int_equal(fit(x, all_modes[m], &progress), STLTSA_E_NOT_FINITE);
        check_all();
    }
}

/* Two groups of rows far from each other have no common coordinates: an error late in the fit. */
TEST(settings_remain_if_rows_are_disconnected) {
    double* x = new_motion(rows, cols, 28);
    for (int i = 0; i < rows / 2 * cols; ++i)
        x[i] += 1e3;
    set_all();
    struct progress progress = {0, 0, -1};
    const stltsa_in in = packed_in(x, rows, cols);
    const stltsa_out out = packed_out(x, rows, cols);
    stltsa_options* options = new_options(24, 24, d);
    must(stltsa_options_set_int(options, STLTSA_OPT_MODE, STLTSA_MODE_SPATIAL));
    must(stltsa_options_set_progress(options, watch, &progress));
    stltsa_model* model = NULL;
    must(stltsa_fit(&in, NULL, options, &model));
    check_all();
    const stltsa_in points = packed_in(x, rows, d);
    assert_int_equal(stltsa_unmap(model, &points, NULL, NULL, &out, NULL, NULL),
                     STLTSA_E_DISCONNECTED);
    check_all();
    stltsa_model_free(model);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_team_of_openmp),
        cmocka_unit_test(settings_remain_if_cancelled),
        cmocka_unit_test(openblas_has_one_thread_during_a_fit),
        cmocka_unit_test(settings_remain_after_an_error),
        cmocka_unit_test(settings_remain_if_rows_are_disconnected),
    };
    return cmocka_run_group_tests(tests, find_functions, NULL);
}
