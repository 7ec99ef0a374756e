/* SPDX-License-Identifier: BSD-3-Clause */
/* Helpers for the tests of new motion: the synthetic walker, whose cycles are equal, and a figure
 * that walks along a given path. */
#ifndef STLTSA_TESTS_UNIT_WALKING_H
#define STLTSA_TESTS_UNIT_WALKING_H

#include "support.h"

static inline double distance(const double* a, const double* b, int axes) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (axes & 1 << axis)
            sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return sqrt(sum);
}
enum { space = 7, floor_plane = 5 }; /* x y z; x z */

static inline stltsa_synthesis* made(const stltsa_piece* pieces, int64_t count,
                                     const stltsa_options* options) {
    stltsa_synthesis* synthesis = NULL;
    must(stltsa_synthesize(pieces, count, options, &synthesis));
    return keep_synthesis(synthesis);
}

/* The second of the walker's three cycles. */
static inline stltsa_part middle_cycle(const stltsa_clip* clip) {
    return cycle_at(decomposed(clip, NULL), 1);
}

/* Largest step of a joint on the floor from frame to frame. */
static inline double largest_step(const double* positions, int64_t frames, int64_t joints,
                                  int joint) {
    double largest = 0;
    for (int64_t i = 1; i < frames; ++i)
        largest = fmax(largest, distance(positions + (i * joints + joint) * 3,
                                         positions + ((i - 1) * joints + joint) * 3, floor_plane));
    return largest;
}

/* ---- A walking figure ---- */

struct figure {
    double fps;
    int frames;
    double turn, x, z; /* degrees about the up axis, and start position */
    double arms;       /* degrees by which both arms are raised */
    double arm_length;
    const char* head;  /* name of a joint */
    const char* order; /* channels of the head */
    double still;      /* 1: no movement */
};

static const struct figure usual_figure = {
    120, 480, 0, 0, 0, 0, 30, "Head", "Zrotation Xrotation Yrotation", 0};

static const char hierarchy[] =
    "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n"
    "CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n"
    "JOINT %s\n{\nOFFSET 0 50 0\nCHANNELS 3 %s\nEnd Site\n{\nOFFSET 0 20 0\n}\n}\n"
    "JOINT LeftArm\n{\nOFFSET 20 45 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "End Site\n{\nOFFSET 0 -%.17g 0\n}\n}\n"
    "JOINT RightArm\n{\nOFFSET -20 45 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "End Site\n{\nOFFSET 0 -%.17g 0\n}\n}\n"
    "JOINT LeftFoot\n{\nOFFSET 10 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "End Site\n{\nOFFSET 0 -90 0\n}\n}\n"
    "JOINT RightFoot\n{\nOFFSET -10 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "End Site\n{\nOFFSET 0 -90 0\n}\n}\n"
    "}\nMOTION\nFrames: %d\nFrame Time: %.17g\n";

static inline stltsa_clip* new_figure(struct figure f) {
    const size_t size = 4096 + (size_t)f.frames * 21 * 26;
    char* text = malloc(size);
    assert_non_null(text);
    int at = snprintf(text, size, hierarchy, f.head, f.order, f.arm_length, f.arm_length, f.frames,
                      1 / f.fps);
    for (int i = 0; i < f.frames; ++i) {
        const double t = i / f.fps, swing = f.still > 0 ? 0 : sin(2 * pi * t);
        const double along = f.still > 0 ? 0 : 120 * t + 3 * sin(4 * pi * t);
        const double c = cos(f.turn * pi / 180), s = sin(f.turn * pi / 180);
        const double row[21] = {f.x + s * along,
                                90 + 2 * swing * swing,
                                f.z + c * along,
                                f.turn + 4 * swing,
                                3 * swing * swing,
                                2 * swing,
                                0,
                                5 * swing,
                                0,
                                f.arms,
                                20 * swing,
                                0,
                                -f.arms,
                                -20 * swing,
                                0,
                                0,
                                -25 * swing,
                                0,
                                0,
                                25 * swing,
                                0};
        for (int k = 0; k < 21; ++k)
            at += snprintf(text + at, size - (size_t)at, "%.17g%c", row[k], k < 20 ? ' ' : '\n');
    }
    stltsa_clip* clip = NULL;
    must(stltsa_clip_parse(text, (size_t)at, STLTSA_FORMAT_BVH, NULL, NULL, &clip));
    free(text);
    return keep_clip(clip);
}

#endif
