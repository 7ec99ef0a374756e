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
 * Peak memory in bytes; 0 if it is unknown (not Linux). getrusage would report the peak of the
 * parent process if that was larger before it started this program.
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
 * Reserves memory for later allocations (glibc). A virtual machine gives away unused memory, and
 * getting it back takes longer than the measured work.
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
