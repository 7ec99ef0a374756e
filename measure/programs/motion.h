/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Synthetic motion for measurements: 56 features that swing with a cycle of about a second at 120
 * frames per second; no two cycles are equal. Frames are the same in every run, and a shorter
 * motion is the beginning of a longer one.
 */
#ifndef MOTION_H
#define MOTION_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { motion_features = 56 };

/* Uniform in [-1, 1). */
static inline double next_random(uint64_t* state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 4503599627370496.0 - 1;
}

static inline void* allocate(size_t bytes) {
    void* memory = malloc(bytes);
    if (memory == NULL) {
        fprintf(stderr, "no memory\n");
        exit(1);
    }
    return memory;
}

/* frames x motion_features; release it with free(). */
static inline double* make_motion(int64_t frames) {
    const double turn = 6.283185307179586;
    uint64_t state = 1;
    double* x = allocate((size_t)frames * motion_features * sizeof *x);
    double phase = 0, speed = 1, size = 1;
    int64_t i;
    int c;
    for (i = 0; i < frames; ++i) {
        /* Both drift slowly around 1. */
        speed += 0.003 * next_random(&state) - 0.002 * (speed - 1);
        size += 0.003 * next_random(&state) - 0.002 * (size - 1);
        phase += turn / 120 * speed;
        for (c = 0; c < motion_features; ++c)
            x[i * motion_features + c] = 20 * size * sin(phase + c) + 8 * sin(2 * phase + 2.3 * c) +
                                         3 * size * sin(3 * phase + 3.1 * c) +
                                         0.01 * next_random(&state);
    }
    return x;
}

#endif
