/* SPDX-License-Identifier: BSD-3-Clause */
/* Maps both ways: fits a curve to every second frame of a clip, maps the frames between them, which
 * the fit has not seen, onto it, turns the coordinates back into poses, and saves these as a clip.
 *
 *     cc map.c $(pkg-config --cflags --libs stltsa) -o map
 *     ./map walk.bvh poses.bvh
 */
#include <stdio.h>
#include <stdlib.h>

#include <stltsa.h>

enum { dimension = 3 };

static stltsa_out output(double* data, int64_t rows, int64_t cols) {
    stltsa_out out = {NULL, 0, 0, 0, 0, STLTSA_F64, 0}; /* strides of 0: packed */
    out.data = data;
    out.rows = rows;
    out.cols = cols;
    return out;
}

/* Fits three coordinates to every second frame. */
static stltsa_status fit(const stltsa_clip* clip, stltsa_model** model) {
    stltsa_options* options = NULL;
    stltsa_status status = stltsa_options_new(&options);
    if (status == STLTSA_OK)
        status = stltsa_options_set_int(options, STLTSA_OPT_DIMENSION, dimension);
    if (status == STLTSA_OK)
        status =
            stltsa_options_set_real(options, STLTSA_OPT_SAMPLE_RATE, stltsa_clip_fps(clip) / 2);
    if (status == STLTSA_OK)
        status = stltsa_fit_clips(&clip, 1, options, model);
    stltsa_options_free(options);
    return status;
}

/* Moves the coordinates of frames between the fitted ones to the front; returns their number. */
static int64_t keep_between(const stltsa_model* model, double* coords, const double* distance,
                            int64_t frames) {
    int64_t first = 0, step = 1, kept = 0, unlike = 0;
    stltsa_info_int(stltsa_model_info(model), STLTSA_INFO_FIRST_FRAME, 0, &first);
    stltsa_info_int(stltsa_model_info(model), STLTSA_INFO_FRAME_STEP, 0, &step);
    for (int64_t frame = first + step / 2; step > 1 && frame < frames; frame += step, ++kept) {
        for (int64_t c = 0; c < dimension; ++c)
            coords[kept * dimension + c] = coords[frame * dimension + c];
        unlike += distance[frame] > 1;
    }
    printf("%lld frames between, %lld unlike what was learned\n", (long long)kept,
           (long long)unlike);
    return kept;
}

static stltsa_status there_and_back(const stltsa_clip* clip, const char* path) {
    const int64_t frames = stltsa_clip_frames(clip);
    double* coords = malloc((size_t)frames * dimension * sizeof *coords);
    double* distance = malloc((size_t)frames * sizeof *distance);
    stltsa_model* model = NULL;
    stltsa_clip* poses = NULL;
    stltsa_status status = STLTSA_E_NO_MEMORY;

    if (coords != NULL && distance != NULL)
        status = fit(clip, &model);
    if (status == STLTSA_OK) {
        const stltsa_out coords_out = output(coords, frames, dimension);
        const stltsa_out distance_out = output(distance, frames, 1);
        status = stltsa_map_clip(model, clip, NULL, &coords_out, &distance_out, NULL);
    }
    if (status == STLTSA_OK) {
        stltsa_in points = {NULL, 0, dimension, 0, 0, STLTSA_F64, 0};
        points.data = coords;
        points.rows = keep_between(model, coords, distance, frames);
        status = stltsa_unmap_clip(model, &points, NULL, NULL, NULL, NULL, &poses);
    }
    if (status == STLTSA_OK)
        status = stltsa_clip_save(poses, path, NULL);
    if (status == STLTSA_OK)
        printf("poses: %lld frames at %g a second\n", (long long)stltsa_clip_frames(poses),
               stltsa_clip_fps(poses));
    stltsa_clip_free(poses);
    stltsa_model_free(model);
    free(distance);
    free(coords);
    return status;
}

int main(int argc, char** argv) {
    stltsa_clip* clip = NULL;

    if (argc != 3) {
        fprintf(stderr, "usage: %s CLIP NEW_CLIP\n", argv[0]);
        return 2;
    }
    const int done = stltsa_clip_open(argv[1], NULL, &clip) == STLTSA_OK &&
                     there_and_back(clip, argv[2]) == STLTSA_OK;
    if (!done)
        fprintf(stderr, "%s\n", stltsa_last_error());
    stltsa_clip_free(clip);
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
