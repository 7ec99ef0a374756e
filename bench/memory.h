/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * The most memory that this process has had at once, in bytes; 0 where it cannot be told (not
 * Linux). What getrusage says would be the caller's, if that had more before it started this
 * program.
 */
#ifndef MEMORY_H
#define MEMORY_H

#include <stdio.h>

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

#endif
