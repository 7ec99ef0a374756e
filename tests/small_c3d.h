/* SPDX-License-Identifier: BSD-3-Clause */
/* A C3D file of one point in 32 frames, 100 a second, with an event RHS after 0.125 s. */
#ifndef SMALL_C3D_H
#define SMALL_C3D_H

#include <string.h>

enum { small_c3d_size = 4 * 512 };

static inline void make_small_c3d(unsigned char* bytes) {
    static const unsigned char head[] = {3, 'P', 1,    0,    0, 0, 1, 0, 32, 0, 0,    0,
                                         0, 0,   0x80, 0xbf, 4, 0, 0, 0, 0,  0, 0xc8, 0x42};
    static const unsigned char events[] = {0x39, 0x30, 1, 0}, seconds[] = {0, 0, 0, 0x3e};
    static const unsigned char parameters[] = {1, 'P', 1, 84}, one[] = {0, 0, 0x80, 0x3f};
    memset(bytes, 0, small_c3d_size);
    memcpy(bytes, head, sizeof head);
    memcpy(bytes + 298, events, sizeof events);
    memcpy(bytes + 304, seconds, sizeof seconds);
    memcpy(bytes + 396, "RHS ", 4);
    memcpy(bytes + 1024, parameters, sizeof parameters);
    for (int at = 3 * 512; at < small_c3d_size; at += 4)
        memcpy(bytes + at, one, sizeof one);
}

#endif
