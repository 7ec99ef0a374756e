/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Reads and decomposes each clip a number of times and prints the least CPU milliseconds of each
 * part, one clip a line: read, decompose, name. The start of the program is not in them.
 * Usage: decompose_times TIMES CLIP...
 */
#define _POSIX_C_SOURCE 200809L

#include "timing.h"

static double least(double a, double b) {
    return a == 0 || b < a ? b : a;
}

int main(int argc, char** argv) {
    const int times = argc > 2 ? atoi(argv[1]) : 0;
    for (int c = 2; c < argc; ++c) {
        double read = 0, decompose = 0;
        for (int i = 0; i < times; ++i) {
            stltsa_clip* clip = NULL;
            stltsa_decomposition* made = NULL;
            const double begin = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
            check(stltsa_clip_open(argv[c], NULL, &clip));
            const double opened = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
            check(stltsa_decompose(clip, NULL, &made));
            const double done = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
            read = least(read, opened - begin);
            decompose = least(decompose, done - opened);
            stltsa_decomposition_free(made);
            stltsa_clip_free(clip);
        }
        printf("%.3f %.3f %s\n", 1e3 * read, 1e3 * decompose, argv[c]);
    }
    return 0;
}
