/* SPDX-License-Identifier: BSD-3-Clause */
/* Helpers for the tests of the public API: frames to fit, fits that must succeed, comparisons. */
#ifndef STLTSA_TESTS_UNIT_SUPPORT_H
#define STLTSA_TESTS_UNIT_SUPPORT_H

#include "facts.h"

#include <math.h>
#include <stdio.h>

static const double pi = 3.14159265358979323846;

static inline double* copy_of(const double* values, int64_t count) {
    double* copy = new_matrix(count, 1);
    memcpy(copy, values, (size_t)count * sizeof *copy);
    return copy;
}

/* Uniform in [0, 1); splitmix64. */
static inline double uniform(uint64_t* state) {
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* A smooth motion that never stops: three sinusoids in every channel. */
static inline double* new_motion(int64_t rows, int64_t cols, uint64_t seed) {
    double* x = new_matrix(rows, cols);
    for (int64_t c = 0; c < cols; ++c)
        for (int term = 0; term < 3; ++term) {
            const double frequency = 0.01 + 0.04 * uniform(&seed);
            const double phase = 2 * pi * uniform(&seed);
            const double amplitude = uniform(&seed);
            for (int64_t i = 0; i < rows; ++i)
                x[i * cols + c] += amplitude * sin(2 * pi * frequency * (double)i + phase);
        }
    return x;
}

/* A random orthonormal set of `rows` vectors of length `cols`. */
static inline double* new_directions(int64_t rows, int64_t cols, uint64_t seed) {
    double* q = new_matrix(rows, cols);
    for (int64_t r = 0; r < rows; ++r) {
        for (int64_t c = 0; c < cols; ++c)
            q[r * cols + c] = uniform(&seed) - 0.5;
        for (int pass = 0; pass < 2; ++pass) {
            for (int64_t s = 0; s < r; ++s) {
                double part = 0;
                for (int64_t c = 0; c < cols; ++c)
                    part += q[r * cols + c] * q[s * cols + c];
                for (int64_t c = 0; c < cols; ++c)
                    q[r * cols + c] -= part * q[s * cols + c];
            }
            double norm = 0;
            for (int64_t c = 0; c < cols; ++c)
                norm += q[r * cols + c] * q[r * cols + c];
            for (int64_t c = 0; c < cols; ++c)
                q[r * cols + c] /= sqrt(norm);
        }
    }
    return q;
}

/* a (rows x inner) times b (inner x cols). */
static inline double* new_product(const double* a, const double* b, int64_t rows, int64_t inner,
                                  int64_t cols) {
    double* product = new_matrix(rows, cols);
    for (int64_t r = 0; r < rows; ++r)
        for (int64_t i = 0; i < inner; ++i)
            for (int64_t c = 0; c < cols; ++c)
                product[r * cols + c] += a[r * inner + i] * b[i * cols + c];
    return product;
}

static inline stltsa_options* new_options(int64_t k, int64_t w, int64_t d) {
    stltsa_options* options = with_int(STLTSA_OPT_NEIGHBORS, k);
    must(stltsa_options_set_int(options, STLTSA_OPT_WINDOW, w));
    must(stltsa_options_set_int(options, STLTSA_OPT_DIMENSION, d));
    must(stltsa_options_set_int(options, STLTSA_OPT_MODE, STLTSA_MODE_TEMPORAL));
    return options;
}

/* Coordinates of a fit of one packed clip. */
static inline double* fit_coords_with(stltsa_options* options, const double* x, int64_t rows,
                                      int64_t cols) {
    return array_of(fitted_rows(x, rows, cols, options), STLTSA_INFO_COORDS);
}

/* The same with k = w = 12. */
static inline double* fit_coords(const double* x, int64_t rows, int64_t cols, int64_t d) {
    return fit_coords_with(new_options(12, 12, d), x, rows, cols);
}

/* Relative distance of `target` (rows x cols) from an affine image of `coords`, whose d columns are
 * centered and orthonormal: the norm of the residual of the centered target. */
static inline double affine_misfit(const double* coords, int64_t d, const double* target,
                                   int64_t rows, int64_t cols) {
    double all = 0;
    double left = 0;
    for (int64_t c = 0; c < cols; ++c) {
        double mean = 0;
        for (int64_t i = 0; i < rows; ++i)
            mean += target[i * cols + c] / (double)rows;
        double* rest = new_matrix(rows, 1);
        for (int64_t i = 0; i < rows; ++i) {
            rest[i] = target[i * cols + c] - mean;
            all += rest[i] * rest[i];
        }
        for (int64_t l = 0; l < d; ++l) {
            double part = 0;
            for (int64_t i = 0; i < rows; ++i)
                part += coords[i * d + l] * rest[i];
            for (int64_t i = 0; i < rows; ++i)
                rest[i] -= part * coords[i * d + l];
        }
        for (int64_t i = 0; i < rows; ++i)
            left += rest[i] * rest[i];
    }
    return sqrt(left / all);
}

/* Largest entry of |a - b|. */
static inline double largest_difference(const double* a, const double* b, int64_t count) {
    double largest = 0;
    for (int64_t i = 0; i < count; ++i)
        largest = fmax(largest, fabs(a[i] - b[i]));
    return largest;
}

static inline void assert_below(double value, double bound, const char* what) {
    if (!(value < bound))
        print_error("%s: %g is not below %g\n", what, value, bound);
    assert_true(value < bound);
}

static inline void assert_same_bits(const double* a, const double* b, int64_t count) {
    assert_memory_equal(a, b, (size_t)count * sizeof *a);
}

#endif
