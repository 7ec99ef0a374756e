/* SPDX-License-Identifier: BSD-3-Clause */
/* Cuts a clip into motion units and cycles: opens it, decomposes it, prints the result.
 *
 *     cc decompose.c $(pkg-config --cflags --libs stltsa) -o decompose
 *     ./decompose walk.bvh
 */
#include <stdio.h>
#include <stdlib.h>

#include <stltsa.h>

static void print_interval(const stltsa_interval* interval) {
    printf("%-10s frames %5lld to %5lld, %7.3f s to %7.3f s\n", stltsa_unit_name(interval->kind),
           (long long)interval->begin, (long long)interval->end, interval->begin_s,
           interval->end_s);
}

static void print_units(const stltsa_decomposition* decomposition) {
    const int64_t units = stltsa_decomposition_unit_count(decomposition);
    const int64_t cycles = stltsa_decomposition_cycle_count(decomposition);
    stltsa_interval interval;

    for (int64_t i = 0; i < units; ++i)
        if (stltsa_decomposition_unit(decomposition, i, &interval) == STLTSA_OK)
            print_interval(&interval);
    for (int64_t i = 0; i < cycles; ++i)
        if (stltsa_decomposition_cycle(decomposition, i, &interval) == STLTSA_OK)
            print_interval(&interval);

    /* A clip without cycles is not an error; the reason explains why there are none. */
    if (cycles == 0)
        printf("no cycle: %s\n", stltsa_decomposition_reason(decomposition));
    for (int64_t i = 0; i < stltsa_decomposition_warning_count(decomposition); ++i)
        printf("warning: %s\n", stltsa_decomposition_warning(decomposition, i));
}

int main(int argc, char** argv) {
    stltsa_clip* clip = NULL;
    stltsa_decomposition* decomposition = NULL;

    if (argc != 2) {
        fprintf(stderr, "usage: %s CLIP\n", argv[0]);
        return 2;
    }

    /* NULL options mean the defaults. A failed call sets its handle to NULL, and every _free
     * accepts NULL, so one cleanup at the end is enough. */
    const int done = stltsa_clip_open(argv[1], NULL, &clip) == STLTSA_OK &&
                     stltsa_decompose(clip, NULL, &decomposition) == STLTSA_OK;
    if (done)
        print_units(decomposition);
    else
        fprintf(stderr, "%s\n", stltsa_last_error());

    stltsa_decomposition_free(decomposition);
    stltsa_clip_free(clip);
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
