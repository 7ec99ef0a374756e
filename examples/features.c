/* SPDX-License-Identifier: BSD-3-Clause */
/* Describes a clip: its skeleton, the path of each joint, and the features that STLTSA uses.
 *
 *     cc features.c $(pkg-config --cflags --libs stltsa) -lm -o features
 *     ./features walk.bvh
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <stltsa.h>

/* Length of the path of one joint through the world, in the file's unit of length. */
static double path_length(const float* positions, int64_t frames, int64_t joints, int64_t joint) {
    double length = 0;
    for (int64_t t = 1; t < frames; ++t) {
        const float* now = positions + (t * joints + joint) * 3;
        const float* before = now - joints * 3;
        const double dx = (double)now[0] - (double)before[0];
        const double dy = (double)now[1] - (double)before[1];
        const double dz = (double)now[2] - (double)before[2];
        length += sqrt(dx * dx + dy * dy + dz * dz);
    }
    return length;
}

static stltsa_status print_joints(const stltsa_clip* clip, const float* positions) {
    const int64_t frames = stltsa_clip_frames(clip);
    const stltsa_info* info = stltsa_clip_info(clip);
    const int64_t joints = stltsa_info_count(info, STLTSA_INFO_JOINT);
    for (int64_t j = 0; j < joints; ++j) {
        stltsa_joint joint;
        const stltsa_status status =
            stltsa_info_rows(info, STLTSA_INFO_JOINT, j, 1, &joint, sizeof joint);
        if (status != STLTSA_OK)
            return status;
        printf("joint %2lld, parent %2lld, path %9.3f  %s%s\n", (long long)j,
               (long long)joint.parent, path_length(positions, frames, joints, j), joint.name,
               joint.is_end_site ? " (end site)" : "");
    }
    return STLTSA_OK;
}

/* The library fills the caller's arrays, and converts to float32 if asked. */
static stltsa_status print_positions(const stltsa_clip* clip) {
    const stltsa_info* info = stltsa_clip_info(clip);
    int64_t frames = 0, columns = 0;
    stltsa_status status = stltsa_info_shape(info, STLTSA_INFO_POSITIONS, &frames, &columns);
    if (status != STLTSA_OK)
        return status;

    float* positions = malloc((size_t)frames * (size_t)columns * sizeof *positions);
    const stltsa_out out = {positions, frames, columns, 0, 0, STLTSA_F32, 0};
    status = STLTSA_E_NO_MEMORY;
    if (positions != NULL)
        status = stltsa_info_array(info, STLTSA_INFO_POSITIONS, 0, &out);
    if (status == STLTSA_OK)
        status = print_joints(clip, positions);
    free(positions);
    return status;
}

static stltsa_status print_features(const stltsa_clip* clip) {
    int64_t columns = 0;
    stltsa_status status = stltsa_clip_feature_count(clip, NULL, &columns);
    if (status != STLTSA_OK)
        return status;

    const int64_t frames = stltsa_clip_frames(clip);
    double* features = malloc((size_t)frames * (size_t)columns * sizeof *features);
    const stltsa_out out = {features, frames, columns, 0, 0, STLTSA_F64, 0};
    status = STLTSA_E_NO_MEMORY;
    if (features != NULL)
        status = stltsa_clip_features(clip, NULL, &out);
    if (status == STLTSA_OK)
        printf("features: %lld frames x %lld columns at %g frames a second\n", (long long)frames,
               (long long)columns, stltsa_clip_fps(clip));
    free(features);
    return status;
}

int main(int argc, char** argv) {
    stltsa_clip* clip = NULL;

    if (argc != 2) {
        fprintf(stderr, "usage: %s CLIP\n", argv[0]);
        return 2;
    }
    stltsa_status status = stltsa_clip_open(argv[1], NULL, &clip);
    if (status == STLTSA_OK && /* 0: a plain matrix, no skeleton */
        stltsa_info_count(stltsa_clip_info(clip), STLTSA_INFO_JOINT) > 0)
        status = print_positions(clip);
    if (status == STLTSA_OK)
        status = print_features(clip);
    if (status != STLTSA_OK)
        fprintf(stderr, "%s: %s\n", stltsa_status_name(status), stltsa_last_error());
    stltsa_clip_free(clip);
    return status == STLTSA_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
