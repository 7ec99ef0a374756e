/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * What one core of this machine can do at most, as one line of JSON: the bounds that
 * scripts/benchmark holds the library's stages against.
 *
 * - fused, separate: floating-point operations a second, of independent multiply-adds in the widest
 *   vector registers, fused and, as the library has them, a multiplication and an addition
 * - streams: bytes a second of y += a x, with x and y together of so many bytes
 * - addition: seconds from one addition to the next that needs its result
 * - step: the same of (b - a t) c, a step of a triangular solve
 *
 * Each is the best of several runs.
 */
#define _POSIX_C_SOURCE 199309L
#include <string.h>

#include "motion.h"
#include "timing.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define WIDER_REGISTERS 1
#else
#define WIDER_REGISTERS 0
#endif

enum { runs = 7, accumulators = 12 };

/* Keeps the compiler from knowing a value, or from leaving out what makes it. */
static volatile double opaque_one = 1, opaque_sink;

typedef double doubles2 __attribute__((vector_size(16)));
typedef double doubles4 __attribute__((vector_size(32)));
typedef double doubles8 __attribute__((vector_size(64)));

/* Clang takes no such wish for one function: there both are fused. */
#ifdef __clang__
#define CONTRACT(how)
#else
#define CONTRACT(how) , optimize("fp-contract=" how)
#endif

/* Twelve sums hide the latency of any machine and leave registers for the two factors. They begin
 * with different values, or the compiler would see that they are equal. */
#define DEFINE_MULTIPLY_ADDS(name, vector, ...)                                                    \
    __attribute__((noinline __VA_ARGS__)) static double name(long rounds) {                        \
        const vector a = (vector){0} + opaque_one * 0.999, b = (vector){0} + opaque_one * 0.001;   \
        vector s0 = b, s1 = s0 + b, s2 = s1 + b, s3 = s2 + b, s4 = s3 + b, s5 = s4 + b;            \
        vector s6 = s5 + b, s7 = s6 + b, s8 = s7 + b, s9 = s8 + b, s10 = s9 + b, s11 = s10 + b;    \
        for (; rounds > 0; --rounds) {                                                             \
            s0 = s0 * a + b, s1 = s1 * a + b, s2 = s2 * a + b, s3 = s3 * a + b;                    \
            s4 = s4 * a + b, s5 = s5 * a + b, s6 = s6 * a + b, s7 = s7 * a + b;                    \
            s8 = s8 * a + b, s9 = s9 * a + b, s10 = s10 * a + b, s11 = s11 * a + b;                \
        }                                                                                          \
        s0 += s1 + s2 + s3 + s4 + s5 + s6 + s7 + s8 + s9 + s10 + s11;                              \
        return s0[0];                                                                              \
    }

DEFINE_MULTIPLY_ADDS(fused_narrow, doubles2, CONTRACT("fast"))
DEFINE_MULTIPLY_ADDS(separate_narrow, doubles2, CONTRACT("off"))
#if WIDER_REGISTERS
DEFINE_MULTIPLY_ADDS(fused_avx2, doubles4, , target("avx2,fma") CONTRACT("fast"))
DEFINE_MULTIPLY_ADDS(separate_avx2, doubles4, , target("avx2") CONTRACT("off"))
DEFINE_MULTIPLY_ADDS(fused_avx512, doubles8, , target("avx512f") CONTRACT("fast"))
DEFINE_MULTIPLY_ADDS(separate_avx512, doubles8, , target("avx512f") CONTRACT("off"))
#endif

struct arithmetic {
    double (*fused)(long), (*separate)(long);
    int width; /* doubles in a register */
};

static struct arithmetic widest(void) {
    struct arithmetic narrow = {fused_narrow, separate_narrow, 2};
#if WIDER_REGISTERS
    const struct arithmetic avx2 = {fused_avx2, separate_avx2, 4};
    const struct arithmetic avx512 = {fused_avx512, separate_avx512, 8};
    if (__builtin_cpu_supports("avx512f"))
        return avx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return avx2;
#endif
    return narrow;
}

static double operations_a_second(double (*work)(long), int width) {
    const long rounds = 4000000;
    double best = 0;
    int run;
    for (run = 0; run < runs; ++run) {
        const double begin = seconds_of(CLOCK_MONOTONIC);
        opaque_sink = work(rounds);
        const double rate =
            2.0 * accumulators * width * (double)rounds / (seconds_of(CLOCK_MONOTONIC) - begin);
        best = rate > best ? rate : best;
    }
    return best;
}

#if WIDER_REGISTERS
__attribute__((target_clones("avx512f", "avx2", "default")))
#endif
static void
add_multiple(double a, const double* x, double* y, size_t count) {
    size_t i;
    for (i = 0; i < count; ++i)
        y[i] += a * x[i];
}

/* Reads x and y and writes y. */
static double bytes_a_second(size_t bytes) {
    const size_t count = bytes / (2 * sizeof(double));
    const size_t passes = bytes < (1u << 26) ? (1u << 28) / bytes : 2;
    double* x = allocate(count * sizeof *x);
    double* y = allocate(count * sizeof *y);
    double best = 0;
    size_t i, pass;
    int run;
    for (i = 0; i < count; ++i)
        x[i] = y[i] = (double)i;
    for (run = 0; run < runs; ++run) {
        const double begin = seconds_of(CLOCK_MONOTONIC);
        for (pass = 0; pass < passes; ++pass)
            add_multiple(opaque_one * 1e-9, x, y, count);
        const double rate = 3.0 * sizeof(double) * (double)count * (double)passes /
                            (seconds_of(CLOCK_MONOTONIC) - begin);
        best = rate > best ? rate : best;
    }
    opaque_sink = y[count / 2];
    free(x);
    free(y);
    return best;
}

__attribute__((noinline)) static double additions(long steps) {
    const double b = opaque_one * 1e-9;
    double t = opaque_one;
    for (; steps > 0; --steps)
        t += b;
    return t;
}

#ifndef __clang__
__attribute__((noinline, optimize("fp-contract=off")))
#endif
static double
solve_steps(long steps) {
    const double a = opaque_one * 0.5, b = opaque_one, c = opaque_one * 0.9;
    double t = opaque_one;
    for (; steps > 0; --steps)
        t = (b - a * t) * c;
    return t;
}

static double seconds_a_step(double (*chain)(long)) {
    const long steps = 5000000;
    double best = 1;
    int run;
    for (run = 0; run < runs; ++run) {
        const double begin = seconds_of(CLOCK_MONOTONIC);
        opaque_sink = chain(steps);
        const double time = (seconds_of(CLOCK_MONOTONIC) - begin) / (double)steps;
        best = time < best ? time : best;
    }
    return best;
}

int main(void) {
    const struct arithmetic arithmetic = widest();
    const size_t sizes[] = {1u << 19, 1u << 22, 1u << 25, 1u << 28};
    size_t s;
    printf("{\"bits\": %d, \"fused\": %.4g, \"separate\": %.4g, \"streams\": [",
           64 * arithmetic.width, operations_a_second(arithmetic.fused, arithmetic.width),
           operations_a_second(arithmetic.separate, arithmetic.width));
    for (s = 0; s < sizeof sizes / sizeof *sizes; ++s)
        printf("%s{\"size\": %zu, \"rate\": %.4g}", s == 0 ? "" : ", ", sizes[s],
               bytes_a_second(sizes[s]));
    printf("], \"addition\": %.4g, \"step\": %.4g}\n", seconds_a_step(additions),
           seconds_a_step(solve_steps));
    return 0;
}
