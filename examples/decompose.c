/* SPDX-License-Identifier: BSD-3-Clause */
/* Cuts a clip into motion units and cycles: opens it, decomposes it, prints the result.
 *
 *     cc decompose.c $(pkg-config --cflags --libs stltsa) -o decompose
 *     ./decompose walk.bvh
 */
#include <stdio.h>
#include <stdlib.h>

#include <stltsa.h>

static void print_interval(const char* name, int64_t begin, int64_t end, double begin_s,
                           double end_s) {
    printf("%-10s frames %5lld to %5lld, %7.3f s to %7.3f s\n", name, (long long)begin,
           (long long)end, begin_s, end_s);
}

/* All that a result says is read by key: units and cycles are lists of structs. */
static void print_units(const stltsa_info* info) {
    const int64_t cycles = stltsa_info_count(info, STLTSA_INFO_CYCLE);
    const char* reason = NULL;

    for (int64_t i = 0; i < stltsa_info_count(info, STLTSA_INFO_UNIT); ++i) {
        stltsa_unit unit;
        if (stltsa_info_rows(info, STLTSA_INFO_UNIT, i, 1, &unit, sizeof unit) == STLTSA_OK)
            print_interval(stltsa_unit_name(unit.kind), unit.begin, unit.end, unit.begin_s,
                           unit.end_s);
    }
    for (int64_t i = 0; i < cycles; ++i) {
        stltsa_part cycle;
        if (stltsa_info_rows(info, STLTSA_INFO_CYCLE, i, 1, &cycle, sizeof cycle) == STLTSA_OK)
            print_interval("cycle", cycle.begin, cycle.end, cycle.begin_s, cycle.end_s);
    }

    /* A clip without cycles is not an error; the reason explains why there are none. */
    if (cycles == 0 && stltsa_info_text(info, STLTSA_INFO_REASON, 0, &reason) == STLTSA_OK)
        printf("no cycle: %s\n", reason);
    for (int64_t i = 0; i < stltsa_info_count(info, STLTSA_INFO_WARNING); ++i) {
        stltsa_warning warning;
        if (stltsa_info_rows(info, STLTSA_INFO_WARNING, i, 1, &warning, sizeof warning) ==
            STLTSA_OK)
            printf("warning: %s\n", warning.text);
    }
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
        print_units(stltsa_decomposition_info(decomposition));
    else
        fprintf(stderr, "%s\n", stltsa_last_error());

    stltsa_decomposition_free(decomposition);
    stltsa_clip_free(clip);
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
