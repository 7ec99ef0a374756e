/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Writes frames for scripts/benchmark as doubles, one frame after another:
 *
 *     make_frames FILE FRAMES                       synthetic motion (motion.h)
 *     make_frames FILE FRAMES SKELETON CLIP...      joint angles of clips, one after the other
 *
 * Clips are cross-faded over a second, so that neighborhoods stay connected at a joint. All clips
 * have the same skeleton. Prints the numbers of frames and features.
 */
#define _POSIX_C_SOURCE 199309L
#include <string.h>

#include "motion.h"
#include "timing.h"

enum { overlap = 120 };

struct frames {
    double* x;
    int64_t rows, cols;
};

static struct frames read_clip(const char* path, const char* skeleton) {
    struct frames read = {NULL, 0, 0};
    stltsa_options* options = NULL;
    stltsa_clip* clip = NULL;
    stltsa_out out;
    check(stltsa_options_new(&options));
    check(stltsa_options_set_text(options, STLTSA_OPT_SKELETON, skeleton));
    check(stltsa_options_set_int(options, STLTSA_OPT_FEATURES, STLTSA_FEATURES_EULER));
    check(stltsa_clip_open(path, options, &clip));
    check(stltsa_clip_feature_count(clip, options, &read.cols));
    read.rows = stltsa_clip_frames(clip);
    read.x = allocate((size_t)(read.rows * read.cols) * sizeof *read.x);
    memset(&out, 0, sizeof out);
    out.data = read.x;
    out.rows = read.rows;
    out.cols = read.cols;
    out.dtype = STLTSA_F64;
    check(stltsa_clip_features(clip, options, &out));
    stltsa_clip_free(clip);
    stltsa_options_free(options);
    return read;
}

/* Appends `next` to `chain`; takes ownership of both. */
static struct frames fade(struct frames chain, struct frames next) {
    const int64_t begin = chain.rows - overlap;
    const struct frames joined = {
        allocate((size_t)((begin + next.rows) * chain.cols) * sizeof(double)), begin + next.rows,
        chain.cols};
    int64_t i, c;
    memcpy(joined.x, chain.x, (size_t)(chain.rows * chain.cols) * sizeof(double));
    memcpy(joined.x + chain.rows * chain.cols, next.x + overlap * chain.cols,
           (size_t)((next.rows - overlap) * chain.cols) * sizeof(double));
    for (i = 0; i < overlap; ++i) {
        const double t = (double)(i + 1) / (overlap + 1);
        const double weight = t * t * (3 - 2 * t);
        for (c = 0; c < chain.cols; ++c)
            joined.x[(begin + i) * chain.cols + c] +=
                weight * (next.x[i * chain.cols + c] - joined.x[(begin + i) * chain.cols + c]);
    }
    free(chain.x);
    free(next.x);
    return joined;
}

static struct frames read_chain(const char* skeleton, char** clips, int count) {
    struct frames chain = read_clip(clips[0], skeleton);
    int i;
    for (i = 1; i < count; ++i) {
        const struct frames next = read_clip(clips[i], skeleton);
        if (next.cols != chain.cols || next.rows < overlap || chain.rows < overlap) {
            fprintf(stderr, "make_frames: %s: too short, or of another skeleton\n", clips[i]);
            exit(1);
        }
        chain = fade(chain, next);
    }
    return chain;
}

static void write_frames(const char* path, struct frames frames) {
    const size_t count = (size_t)(frames.rows * frames.cols);
    FILE* file = fopen(path, "wb");
    int written = file != NULL && fwrite(frames.x, sizeof(double), count, file) == count;
    if (file != NULL)
        written = fclose(file) == 0 && written;
    if (!written) {
        fprintf(stderr, "make_frames: %s cannot be written\n", path);
        exit(1);
    }
}

int main(int argc, char** argv) {
    struct frames frames;
    int64_t wanted;
    if (argc < 3 || argc == 4 || (wanted = atoll(argv[2])) < 1) {
        fprintf(stderr, "usage: make_frames FILE FRAMES [SKELETON CLIP...]\n");
        return 2;
    }
    if (argc == 3) {
        frames.x = make_motion(wanted);
        frames.rows = wanted;
        frames.cols = motion_features;
    } else {
        frames = read_chain(argv[3], argv + 4, argc - 4);
        if (wanted < frames.rows)
            frames.rows = wanted;
    }
    write_frames(argv[1], frames);
    printf("{\"frames\": %lld, \"features\": %lld}\n", (long long)frames.rows,
           (long long)frames.cols);
    free(frames.x);
    return 0;
}
