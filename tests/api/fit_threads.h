/* SPDX-License-Identifier: BSD-3-Clause */
/* For tests of the threads that a fit starts. */
#pragma once
#include <dirent.h>

#include "support.h"

/* Threads of this process. */
static inline int count_threads(void) {
    DIR* folder = opendir("/proc/self/task");
    assert_non_null(folder);
    int count = 0;
    for (const struct dirent* entry; (entry = readdir(folder)) != NULL;)
        count += entry->d_name[0] != '.';
    closedir(folder);
    return count;
}

/* Fits and frees the model. `progress` may be NULL. */
static inline stltsa_status fit_in_mode(const stltsa_in* in, int64_t mode, int64_t threads,
                                        stltsa_progress_fn progress, void* user) {
    stltsa_options* options = new_options(24, 24, 2);
    must(stltsa_options_set_int(options, STLTSA_OPT_MODE, mode));
    must(stltsa_options_set_int(options, STLTSA_OPT_THREADS, threads));
    must(stltsa_options_set_progress(options, progress, user));
    stltsa_model* model = NULL;
    const stltsa_status status = stltsa_fit(in, NULL, options, &model);
    stltsa_model_free(model);
    return status;
}

static const int64_t all_modes[] = {STLTSA_MODE_TEMPORAL, STLTSA_MODE_SPATIAL,
                                    STLTSA_MODE_RECURRENT};
