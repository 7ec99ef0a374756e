/* SPDX-License-Identifier: BSD-3-Clause */
/* The memory of this process. */
#ifndef MEMORY_H
#define MEMORY_H

#include <stdio.h>
#include <stdlib.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

/*
 * The most that it has had at once, in bytes; 0 where it cannot be told (not Linux). What getrusage
 * says would be the caller's, if that had more before it started this program.
 */
static inline long long peak_memory(void) {
    char line[256];
    long long kib = 0;
    FILE* status = fopen("/proc/self/status", "r");
    if (status == NULL)
        return 0;
    while (fgets(line, sizeof line, status) != NULL)
        if (sscanf(line, "VmHWM: %lld", &kib) == 1)
            break;
    fclose(status);
    return kib * 1024;
}

/*
 * Takes so much, and keeps it for what is allocated from now on (glibc). A virtual machine lends
 * out what nobody uses: to get it back takes longer than the work that is to be measured.
 */
static inline void keep_memory(long long bytes) {
    volatile char* memory;
    long long i;
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
    mallopt(M_ARENA_MAX, 1);
#endif
    memory = malloc((size_t)bytes);
    for (i = 0; memory != NULL && i < bytes; i += 4096)
        memory[i] = 1;
    free((void*)memory);
}

#endif
