/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Time by stage, from the calls of the progress callback, which run on the caller's thread: the
 * time between two calls counts towards the stage of the second one. _POSIX_C_SOURCE must be
 * defined before the first header.
 */
#ifndef TIMING_H
#define TIMING_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "stltsa.h"

enum { stages = STLTSA_STAGE_UNITS + 1 };

struct stage_times {
    clockid_t clock;
    double last;
    double seconds[stages];
};

static inline double seconds_of(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static inline struct stage_times start_stages(clockid_t clock) {
    struct stage_times times = {clock, 0, {0}};
    times.last = seconds_of(clock);
    return times;
}

/* The progress callback; `user` is a struct stage_times. */
static inline int32_t record_stage(void* user, int32_t stage, double fraction) {
    struct stage_times* times = user;
    const double time = seconds_of(times->clock);
    (void)fraction;
    if (stage >= 0 && stage < stages)
        times->seconds[stage] += time - times->last;
    times->last = time;
    return 0;
}

static inline void check(stltsa_status status) {
    if (status != STLTSA_OK) {
        fprintf(stderr, "%s\n", stltsa_last_error());
        exit(1);
    }
}

#endif
