/* SPDX-License-Identifier: BSD-3-Clause */
/* A program written for 0.1.0. It is compiled with the header of that version in the same folder,
 * and linked and run with the current library. It requires every function of 0.1.0, and passes
 * every struct by value or by pointer, so a changed layout makes it fail.
 *
 *     program CLIP
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stltsa.h"

#include "../check.h"

/* clang-format off */
static const function functions[] = {
    (function)stltsa_clip_channels,
    (function)stltsa_clip_feature_count,
    (function)stltsa_clip_features,
    (function)stltsa_clip_find,
    (function)stltsa_clip_format,
    (function)stltsa_clip_fps,
    (function)stltsa_clip_frames,
    (function)stltsa_clip_free,
    (function)stltsa_clip_from_matrix,
    (function)stltsa_clip_from_points,
    (function)stltsa_clip_from_skeleton,
    (function)stltsa_clip_info,
    (function)stltsa_clip_joint,
    (function)stltsa_clip_joints,
    (function)stltsa_clip_json,
    (function)stltsa_clip_mirror,
    (function)stltsa_clip_open,
    (function)stltsa_clip_parse,
    (function)stltsa_clip_positions,
    (function)stltsa_clip_rotations,
    (function)stltsa_clip_save,
    (function)stltsa_clip_set_path,
    (function)stltsa_clip_stretch,
    (function)stltsa_cycles_between,
    (function)stltsa_cycles_count,
    (function)stltsa_cycles_cycle,
    (function)stltsa_cycles_distance,
    (function)stltsa_cycles_free,
    (function)stltsa_cycles_group_distance,
    (function)stltsa_cycles_mean,
    (function)stltsa_cycles_resample,
    (function)stltsa_cycles_times,
    (function)stltsa_decompose,
    (function)stltsa_decomposition_carrier,
    (function)stltsa_decomposition_carrier_count,
    (function)stltsa_decomposition_coords,
    (function)stltsa_decomposition_curve,
    (function)stltsa_decomposition_cycle,
    (function)stltsa_decomposition_cycle_count,
    (function)stltsa_decomposition_free,
    (function)stltsa_decomposition_info,
    (function)stltsa_decomposition_json,
    (function)stltsa_decomposition_loop,
    (function)stltsa_decomposition_part,
    (function)stltsa_decomposition_part_count,
    (function)stltsa_decomposition_reason,
    (function)stltsa_decomposition_segment,
    (function)stltsa_decomposition_segment_count,
    (function)stltsa_decomposition_segment_reason,
    (function)stltsa_decomposition_statistics,
    (function)stltsa_decomposition_summary,
    (function)stltsa_decomposition_summary_count,
    (function)stltsa_decomposition_travel,
    (function)stltsa_decomposition_unit,
    (function)stltsa_decomposition_unit_count,
    (function)stltsa_decomposition_warning,
    (function)stltsa_decomposition_warning_count,
    (function)stltsa_denoise,
    (function)stltsa_denoise_model,
    (function)stltsa_denoising_cleaned,
    (function)stltsa_denoising_curve,
    (function)stltsa_denoising_free,
    (function)stltsa_denoising_info,
    (function)stltsa_denoising_json,
    (function)stltsa_denoising_moves,
    (function)stltsa_dimension_eigengap,
    (function)stltsa_dimension_eigenvalues,
    (function)stltsa_dimension_free,
    (function)stltsa_dimension_info,
    (function)stltsa_dimension_json,
    (function)stltsa_dimension_local_pca,
    (function)stltsa_dimension_local_variances,
    (function)stltsa_estimate_dimension,
    (function)stltsa_estimate_dimension_clip,
    (function)stltsa_estimate_dimension_clips,
    (function)stltsa_events_count,
    (function)stltsa_events_event,
    (function)stltsa_events_find,
    (function)stltsa_events_free,
    (function)stltsa_events_likeness,
    (function)stltsa_events_warning,
    (function)stltsa_events_warning_count,
    (function)stltsa_fit,
    (function)stltsa_fit_clip,
    (function)stltsa_fit_clips,
    (function)stltsa_free,
    (function)stltsa_has,
    (function)stltsa_info_count,
    (function)stltsa_info_describe,
    (function)stltsa_info_int,
    (function)stltsa_info_key_count,
    (function)stltsa_info_real,
    (function)stltsa_info_text,
    (function)stltsa_last_error,
    (function)stltsa_live_free,
    (function)stltsa_live_mark_count,
    (function)stltsa_live_mark_name,
    (function)stltsa_live_new,
    (function)stltsa_live_push,
    (function)stltsa_live_push_frame,
    (function)stltsa_live_push_points,
    (function)stltsa_live_push_pose,
    (function)stltsa_map,
    (function)stltsa_map_clip,
    (function)stltsa_model_components,
    (function)stltsa_model_coords,
    (function)stltsa_model_eigenvalues,
    (function)stltsa_model_free,
    (function)stltsa_model_has_cycle,
    (function)stltsa_model_info,
    (function)stltsa_model_json,
    (function)stltsa_model_keep_cycle,
    (function)stltsa_model_keep_mark,
    (function)stltsa_model_load,
    (function)stltsa_model_parse,
    (function)stltsa_model_save,
    (function)stltsa_model_serialize,
    (function)stltsa_model_warning,
    (function)stltsa_model_warning_count,
    (function)stltsa_option_count,
    (function)stltsa_option_describe,
    (function)stltsa_options_free,
    (function)stltsa_options_get_int,
    (function)stltsa_options_get_real,
    (function)stltsa_options_get_text,
    (function)stltsa_options_is_set,
    (function)stltsa_options_new,
    (function)stltsa_options_set_int,
    (function)stltsa_options_set_progress,
    (function)stltsa_options_set_real,
    (function)stltsa_options_set_text,
    (function)stltsa_options_unset,
    (function)stltsa_phase_column_count,
    (function)stltsa_phase_column_owner,
    (function)stltsa_phase_find,
    (function)stltsa_phase_free,
    (function)stltsa_phase_values,
    (function)stltsa_phase_warning,
    (function)stltsa_phase_warning_count,
    (function)stltsa_segment_name,
    (function)stltsa_side_of_name,
    (function)stltsa_status_name,
    (function)stltsa_synthesis_clip,
    (function)stltsa_synthesis_free,
    (function)stltsa_synthesis_info,
    (function)stltsa_synthesis_json,
    (function)stltsa_synthesis_seam,
    (function)stltsa_synthesis_seam_count,
    (function)stltsa_synthesis_warning,
    (function)stltsa_synthesis_warning_count,
    (function)stltsa_synthesize,
    (function)stltsa_synthesize_loop,
    (function)stltsa_unit_name,
    (function)stltsa_unmap,
    (function)stltsa_unmap_clip,
    (function)stltsa_version,
    (function)stltsa_version_number,
};
/* clang-format on */

enum { FRAMES = 240, FEATURES = 4 };

static void fit_and_map(void) {
    static double frames[FRAMES][FEATURES], coords[FRAMES][2], mapped[FRAMES][2];
    for (int t = 0; t < FRAMES; ++t) {
        const double angle = 2 * 3.14159265358979323846 * t / 80;
        const double row[FEATURES] = {cos(angle), sin(angle), 0.3 * cos(2 * angle), 0.001 * t};
        memcpy(frames[t], row, sizeof row);
    }
    const stltsa_in in = {frames, FRAMES, FEATURES, 0, 0, STLTSA_F64, 0};
    const stltsa_out out = {coords, FRAMES, 2, 0, 0, STLTSA_F64, 0};
    const stltsa_out again = {mapped, FRAMES, 2, 0, 0, STLTSA_F64, 0};
    stltsa_options* options = NULL;
    stltsa_model *model = NULL, *read = NULL;
    unsigned char* bytes = NULL;
    size_t size = 0;
    int64_t neighbors = 0;

    MUST(stltsa_options_new(&options));
    MUST(stltsa_options_set_int(options, STLTSA_OPT_DIMENSION, 2));
    MUST(stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, 96));
    MUST(stltsa_fit(&in, NULL, options, &model));
    MUST(stltsa_info_int(stltsa_model_info(model), STLTSA_INFO_NEIGHBORS, 0, &neighbors));
    CHECK(neighbors == 96);
    MUST(stltsa_model_coords(model, &out));
    MUST(stltsa_model_serialize(model, &bytes, &size));
    MUST(stltsa_model_parse(bytes, size, &read));
    MUST(stltsa_map(read, &in, NULL, NULL, &again, NULL, NULL));
    for (int t = 0; t < FRAMES; ++t)
        CHECK(fabs(mapped[t][0] - coords[t][0]) + fabs(mapped[t][1] - coords[t][1]) < 1e-2);
    CHECK(stltsa_fit(&in, NULL, NULL, NULL) == STLTSA_E_ARGUMENT);
    CHECK(strcmp(stltsa_status_name(STLTSA_E_ARGUMENT), "STLTSA_E_ARGUMENT") == 0);

    stltsa_free(bytes);
    stltsa_model_free(read);
    stltsa_model_free(model);
    stltsa_options_free(options);
}

static void cut(const char* path) {
    stltsa_clip* clip = NULL;
    stltsa_decomposition* decomposition = NULL;
    stltsa_phase* phase = NULL;
    char* json = NULL;
    stltsa_interval unit = {0}, before = {0};
    stltsa_segment segment = {0};

    MUST(stltsa_clip_open(path, NULL, &clip));
    const int64_t frames = stltsa_clip_frames(clip);
    CHECK(frames > 0 && stltsa_clip_format(clip) == STLTSA_FORMAT_BVH);
    MUST(stltsa_decompose(clip, NULL, &decomposition));
    CHECK(stltsa_decomposition_cycle_count(decomposition) > 2);
    for (int64_t i = 0; i < stltsa_decomposition_unit_count(decomposition); ++i) {
        MUST(stltsa_decomposition_unit(decomposition, i, &unit));
        CHECK(unit.begin >= before.end && unit.end > unit.begin && unit.end <= frames);
        CHECK(fabs(unit.begin_s * stltsa_clip_fps(clip) - (double)unit.begin) < 1);
        before = unit;
    }
    CHECK(stltsa_decomposition_segment_count(decomposition) > 0);
    MUST(stltsa_decomposition_segment(decomposition, 0, &segment));
    CHECK(segment.begin == 0 && segment.end <= frames && segment.confidence <= 1);
    MUST(stltsa_decomposition_json(decomposition, &json));
    CHECK(strstr(json, "\"format\":\"stltsa-decomposition/2\"") != NULL);
    MUST(stltsa_phase_find(decomposition, NULL, &phase));

    stltsa_free(json);
    stltsa_phase_free(phase);
    stltsa_decomposition_free(decomposition);
    stltsa_clip_free(clip);
}

int main(int argc, char** argv) {
    if (argc != 2) {
        fprintf(stderr, "usage: %s CLIP\n", argv[0]);
        return 2;
    }
    for (size_t i = 0; i < sizeof functions / sizeof *functions; ++i)
        CHECK(functions[i] != NULL);
    CHECK(stltsa_version_number() >= STLTSA_VERSION_NUMBER);
    fit_and_map();
    cut(argv[1]);
    printf("built for 0.1.0, run with %s: %d failures\n", stltsa_version(), failures);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
