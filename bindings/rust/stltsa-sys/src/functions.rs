// SPDX-License-Identifier: BSD-3-Clause
//! The functions of `stltsa.h`, in its order.

use std::os::raw::{c_char, c_void};

use crate::types::*;

extern "C" {
    // Status
    pub fn stltsa_status_name(status: stltsa_status) -> *const c_char;
    pub fn stltsa_last_error() -> *const c_char;
    pub fn stltsa_version() -> *const c_char;

    // Options
    pub fn stltsa_option_count() -> i64;
    pub fn stltsa_option_describe(index: i64, info: *mut stltsa_option_info) -> stltsa_status;
    pub fn stltsa_options_new(options: *mut *mut stltsa_options) -> stltsa_status;
    pub fn stltsa_options_free(options: *mut stltsa_options);
    pub fn stltsa_options_set_int(
        options: *mut stltsa_options,
        key: i32,
        value: i64,
    ) -> stltsa_status;
    pub fn stltsa_options_set_real(
        options: *mut stltsa_options,
        key: i32,
        value: f64,
    ) -> stltsa_status;
    pub fn stltsa_options_set_text(
        options: *mut stltsa_options,
        key: i32,
        value: *const c_char,
    ) -> stltsa_status;
    pub fn stltsa_options_get_int(
        options: *const stltsa_options,
        key: i32,
        value: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_options_get_real(
        options: *const stltsa_options,
        key: i32,
        value: *mut f64,
    ) -> stltsa_status;
    pub fn stltsa_options_get_text(
        options: *const stltsa_options,
        key: i32,
        value: *mut *const c_char,
    ) -> stltsa_status;
    pub fn stltsa_options_set_progress(
        options: *mut stltsa_options,
        progress: stltsa_progress,
        user: *mut c_void,
    ) -> stltsa_status;

    // Clips
    pub fn stltsa_clip_open(
        path: *const c_char,
        options: *const stltsa_options,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
    pub fn stltsa_clip_parse(
        bytes: *const c_void,
        size: usize,
        format: i32,
        options: *const stltsa_options,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
    pub fn stltsa_clip_from_matrix(
        frames: *const stltsa_in,
        fps: f64,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
    pub fn stltsa_clip_free(clip: *mut stltsa_clip);
    pub fn stltsa_clip_frames(clip: *const stltsa_clip) -> i64;
    pub fn stltsa_clip_fps(clip: *const stltsa_clip) -> f64;
    pub fn stltsa_clip_format(clip: *const stltsa_clip) -> i32;
    pub fn stltsa_clip_channels(clip: *const stltsa_clip) -> i64;
    pub fn stltsa_clip_joints(clip: *const stltsa_clip) -> i64;
    pub fn stltsa_clip_joint(
        clip: *const stltsa_clip,
        joint: i64,
        name: *mut *const c_char,
        parent: *mut i64,
        is_end_site: *mut i32,
    ) -> stltsa_status;
    pub fn stltsa_clip_positions(
        clip: *const stltsa_clip,
        positions: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_clip_rotations(
        clip: *const stltsa_clip,
        rotations: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_clip_feature_count(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        count: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_clip_features(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        features: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_clip_json(clip: *const stltsa_clip, json: *mut *mut c_char) -> stltsa_status;
    pub fn stltsa_string_free(text: *mut c_char);
    pub fn stltsa_clip_save(clip: *const stltsa_clip, path: *const c_char) -> stltsa_status;

    // The manifold curve: STLTSA
    pub fn stltsa_fit(
        frames: *const stltsa_in,
        lengths: *const i64,
        clips: i64,
        options: *const stltsa_options,
        model: *mut *mut stltsa_model,
    ) -> stltsa_status;
    pub fn stltsa_fit_clip(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        model: *mut *mut stltsa_model,
    ) -> stltsa_status;
    pub fn stltsa_model_free(model: *mut stltsa_model);
    pub fn stltsa_model_get_int(
        model: *const stltsa_model,
        key: i32,
        value: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_model_get_real(
        model: *const stltsa_model,
        key: i32,
        value: *mut f64,
    ) -> stltsa_status;
    pub fn stltsa_model_coords(
        model: *const stltsa_model,
        coords: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_model_eigenvalues(
        model: *const stltsa_model,
        values: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_model_components(
        model: *const stltsa_model,
        rows: i64,
        labels: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_model_warning_count(model: *const stltsa_model) -> i64;
    pub fn stltsa_model_warning(model: *const stltsa_model, index: i64) -> *const c_char;
    pub fn stltsa_model_json(model: *const stltsa_model, json: *mut *mut c_char) -> stltsa_status;

    // Intrinsic dimension (section 2.3)
    pub fn stltsa_dimension(
        frames: *const stltsa_in,
        lengths: *const i64,
        clips: i64,
        options: *const stltsa_options,
        result: *mut *mut stltsa_dimension_result,
    ) -> stltsa_status;
    pub fn stltsa_dimension_clip(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        result: *mut *mut stltsa_dimension_result,
    ) -> stltsa_status;
    pub fn stltsa_dimension_free(result: *mut stltsa_dimension_result);
    pub fn stltsa_dimension_eigengap(
        result: *const stltsa_dimension_result,
        reason: *mut *const c_char,
    ) -> i64;
    pub fn stltsa_dimension_local_pca(
        result: *const stltsa_dimension_result,
        reason: *mut *const c_char,
    ) -> i64;
    pub fn stltsa_dimension_eigenvalues(
        result: *const stltsa_dimension_result,
        values: *mut f64,
        capacity: i64,
    ) -> i64;
    pub fn stltsa_dimension_local_variances(
        result: *const stltsa_dimension_result,
        values: *mut f64,
        capacity: i64,
    ) -> i64;
    pub fn stltsa_dimension_json(
        result: *const stltsa_dimension_result,
        json: *mut *mut c_char,
    ) -> stltsa_status;

    // Motion units and cycles (section 3.1)
    pub fn stltsa_unit_name(kind: i32) -> *const c_char;
    pub fn stltsa_decompose(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        decomposition: *mut *mut stltsa_decomposition,
    ) -> stltsa_status;
    pub fn stltsa_decomposition_free(decomposition: *mut stltsa_decomposition);
    pub fn stltsa_decomposition_unit_count(decomposition: *const stltsa_decomposition) -> i64;
    pub fn stltsa_decomposition_unit(
        decomposition: *const stltsa_decomposition,
        index: i64,
        unit: *mut stltsa_interval,
    ) -> stltsa_status;
    pub fn stltsa_decomposition_cycle_count(decomposition: *const stltsa_decomposition) -> i64;
    pub fn stltsa_decomposition_cycle(
        decomposition: *const stltsa_decomposition,
        index: i64,
        cycle: *mut stltsa_interval,
    ) -> stltsa_status;
    pub fn stltsa_decomposition_get_int(
        decomposition: *const stltsa_decomposition,
        key: i32,
        value: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_decomposition_get_real(
        decomposition: *const stltsa_decomposition,
        key: i32,
        value: *mut f64,
    ) -> stltsa_status;
    pub fn stltsa_decomposition_curve(
        decomposition: *const stltsa_decomposition,
        curve: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_decomposition_loop(
        decomposition: *const stltsa_decomposition,
        r#loop: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_decomposition_reason(decomposition: *const stltsa_decomposition)
        -> *const c_char;
    pub fn stltsa_decomposition_warning_count(decomposition: *const stltsa_decomposition) -> i64;
    pub fn stltsa_decomposition_warning(
        decomposition: *const stltsa_decomposition,
        index: i64,
    ) -> *const c_char;
    pub fn stltsa_decomposition_json(
        decomposition: *const stltsa_decomposition,
        json: *mut *mut c_char,
    ) -> stltsa_status;

    // Mapping, both ways (section 2.4)
    pub fn stltsa_map(
        model: *const stltsa_model,
        frames: *const stltsa_in,
        hints: *const i64,
        options: *const stltsa_options,
        coords: *const stltsa_out,
        distance: *const stltsa_out,
        nearest: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_map_clip(
        model: *const stltsa_model,
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        coords: *const stltsa_out,
        distance: *const stltsa_out,
        nearest: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_unmap(
        model: *const stltsa_model,
        coords: *const stltsa_in,
        hints: *const i64,
        options: *const stltsa_options,
        frames: *const stltsa_out,
        distance: *const stltsa_out,
        nearest: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_unmap_clip(
        model: *const stltsa_model,
        coords: *const stltsa_in,
        hints: *const i64,
        options: *const stltsa_options,
        distance: *const stltsa_out,
        nearest: *mut i64,
        poses: *mut *mut stltsa_clip,
    ) -> stltsa_status;

    // Model files
    pub fn stltsa_model_serialize(
        model: *const stltsa_model,
        bytes: *mut *mut u8,
        size: *mut usize,
    ) -> stltsa_status;
    pub fn stltsa_model_parse(
        bytes: *const c_void,
        size: usize,
        model: *mut *mut stltsa_model,
    ) -> stltsa_status;
    pub fn stltsa_bytes_free(bytes: *mut u8);
    pub fn stltsa_model_save(model: *const stltsa_model, path: *const c_char) -> stltsa_status;
    pub fn stltsa_model_load(path: *const c_char, model: *mut *mut stltsa_model) -> stltsa_status;

    // Denoising (section 3.2)
    pub fn stltsa_denoise(
        coords: *const stltsa_in,
        lengths: *const i64,
        clips: i64,
        options: *const stltsa_options,
        denoising: *mut *mut stltsa_denoising,
    ) -> stltsa_status;
    pub fn stltsa_denoise_model(
        model: *const stltsa_model,
        options: *const stltsa_options,
        denoising: *mut *mut stltsa_denoising,
    ) -> stltsa_status;
    pub fn stltsa_denoising_free(denoising: *mut stltsa_denoising);
    pub fn stltsa_denoising_get_int(
        denoising: *const stltsa_denoising,
        key: i32,
        column: i64,
        value: *mut i64,
    ) -> stltsa_status;
    pub fn stltsa_denoising_get_real(
        denoising: *const stltsa_denoising,
        key: i32,
        column: i64,
        value: *mut f64,
    ) -> stltsa_status;
    pub fn stltsa_denoising_curve(
        denoising: *const stltsa_denoising,
        curve: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_denoising_cleaned(
        denoising: *const stltsa_denoising,
        cleaned: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_denoising_moves(
        denoising: *const stltsa_denoising,
        moves: *const stltsa_out,
    ) -> stltsa_status;
    pub fn stltsa_denoising_json(
        denoising: *const stltsa_denoising,
        json: *mut *mut c_char,
    ) -> stltsa_status;

    // New motion from units (section 4)
    pub fn stltsa_synthesize(
        pieces: *const stltsa_piece,
        count: i64,
        options: *const stltsa_options,
        synthesis: *mut *mut stltsa_synthesis,
    ) -> stltsa_status;
    pub fn stltsa_synthesis_free(synthesis: *mut stltsa_synthesis);
    pub fn stltsa_synthesis_clip(synthesis: *const stltsa_synthesis) -> *const stltsa_clip;
    pub fn stltsa_synthesis_seam_count(synthesis: *const stltsa_synthesis) -> i64;
    pub fn stltsa_synthesis_seam(
        synthesis: *const stltsa_synthesis,
        index: i64,
        seam: *mut stltsa_seam,
    ) -> stltsa_status;
    pub fn stltsa_synthesis_warning_count(synthesis: *const stltsa_synthesis) -> i64;
    pub fn stltsa_synthesis_warning(
        synthesis: *const stltsa_synthesis,
        index: i64,
    ) -> *const c_char;
    pub fn stltsa_synthesis_json(
        synthesis: *const stltsa_synthesis,
        json: *mut *mut c_char,
    ) -> stltsa_status;
}
