// SPDX-License-Identifier: BSD-3-Clause
#include "capi/info/info.hpp"

namespace stltsa::capi {
namespace {

constexpr stltsa_info_key whole(int32_t key, const char* name, const char* text,
                                const char* choices = nullptr) {
    return {0, key, STLTSA_TYPE_INT, name, text, choices, 0, 0};
}

constexpr stltsa_info_key real(int32_t key, const char* name, const char* text) {
    return {0, key, STLTSA_TYPE_REAL, name, text, nullptr, 0, 0};
}

constexpr stltsa_info_key text(int32_t key, const char* name, const char* text) {
    return {0, key, STLTSA_TYPE_TEXT, name, text, nullptr, 0, 0};
}

constexpr stltsa_info_key rows[] = {
    text(STLTSA_INFO_PATH, "path", "Path of the clip as given; empty: from memory."),
    whole(STLTSA_INFO_FORMAT, "format", "STLTSA_FORMAT_* of the clip.",
          "bvh=1 amc=2 csv=3 npy=4 matrix=5 points=6 skeleton=7 glb=8 c3d=9 trc=10 mot=11"),
    whole(STLTSA_INFO_CLIP_FRAMES, "clip_frames", "Frames of the clip."),
    real(STLTSA_INFO_CLIP_FPS, "clip_fps", "Frames a second of the clip; 0: unknown."),
    text(STLTSA_INFO_NOTE, "note", "What was assumed of the clip, and removed from it."),
    text(STLTSA_INFO_CHANNEL, "channel",
         "Names of the clip's channels; none if the file has no names."),
    whole(STLTSA_INFO_FEATURES, "features", "STLTSA_FEATURES_* used.",
          "positions=1 rotations6d=2 euler=3 raw=4 points=5"),
    whole(STLTSA_INFO_FEATURE_COUNT, "feature_count", "Columns of the features."),
    whole(STLTSA_INFO_UP_AXIS, "up_axis",
          "Axis that points up: 1, 2, 3 for x, y, z; 0: none was needed.", "none=0 x=1 y=2 z=3"),
    real(STLTSA_INFO_SMOOTHING, "smoothing",
         "Sigma in seconds of the Gaussian on the features; 0: none."),
    whole(STLTSA_INFO_ROWS, "rows", "Rows that the method worked on."),
    whole(STLTSA_INFO_LENGTH, "length", "Rows of each clip; of a denoising, of each spline."),
    whole(STLTSA_INFO_FIRST_FRAME, "first_frame",
          "Row i of a clip is its source frame first_frame + i * frame_step."),
    whole(STLTSA_INFO_FRAME_STEP, "frame_step", "See first_frame; 1 for matrices."),
    real(STLTSA_INFO_FPS, "fps", "Rows a second; 0: unknown."),
    whole(STLTSA_INFO_BODY_ROOT, "body_root",
          "Joint that turns the body. Those before it, its ancestors, are not part of the body."),
    whole(STLTSA_INFO_MODE, "mode", "STLTSA_MODE_*.", "temporal=1 spatial=2 recurrent=3"),
    whole(STLTSA_INFO_NEIGHBORS, "neighbors", "k used, in rows."),
    whole(STLTSA_INFO_WINDOW, "window", "w used, in rows to each side."),
    whole(STLTSA_INFO_DIMENSION, "dimension", "Tangent dimension d."),
    whole(STLTSA_INFO_INCLUDE_SELF, "include_self", "1: a row is among its own neighbors."),
    whole(STLTSA_INFO_LINKS, "links", "Recurrent: neighbors from outside the exclusion zone."),
    whole(STLTSA_INFO_EXCLUSION, "exclusion", "Recurrent: half width of that zone in rows."),
    real(STLTSA_INFO_PERIOD, "period",
         "Period in seconds; 0: none, or the rate is unknown: see period_rows."),
    real(STLTSA_INFO_LAG_QUALITY, "lag_quality",
         "Match of the velocities one period apart; 1: perfect, 0: no period."),
    real(STLTSA_INFO_PERIOD_MIN, "period_min",
         "Shortest period looked for, in seconds; 0: no search was made."),
    real(STLTSA_INFO_PERIOD_MAX, "period_max",
         "Longest period looked for, in seconds; 0: no search was made."),
    real(STLTSA_INFO_PERIOD_ROWS, "period_rows", "Period in rows; 0: none."),
    whole(STLTSA_INFO_REPEATED, "repeated", "Rows collapsed because they repeat the one before."),
    real(STLTSA_INFO_TIME_CORRELATION, "time_correlation",
         "Absolute rank correlation of coordinate 1 with time, over at most 2^14 frames of the "
         "largest component; 1: it only follows time."),
    real(STLTSA_INFO_REACH, "reach",
         "Distance from the fitted frames, in units of the features, up to which a new frame is "
         "like them; 0: the model cannot map."),
    whole(STLTSA_INFO_COMPONENT_ROWS, "component_rows",
          "Distinct rows of each component of the neighborhood graph."),
    whole(STLTSA_INFO_RANK_DEFICIENT, "rank_deficient",
          "Windows of fewer than d directions in each component."),
    whole(STLTSA_INFO_SOLVES, "solves",
          "Applications of the inverse operator by ARPACK, for each component."),
    real(STLTSA_INFO_RESIDUAL, "residual", "Largest ||B u - lambda u|| / k of each component."),
    real(STLTSA_INFO_ERROR_ESTIMATE, "error_estimate",
         "Estimate of the largest principal angle to the exact embedding, in radians, for each "
         "component."),
    real(STLTSA_INFO_GAP, "gap",
         "lambda_{d+2} / lambda_{d+1} of each component; near 1: the curve is ill-defined."),
    whole(STLTSA_INFO_COMPONENTS, "components", "Components of the neighborhood graph."),
    whole(STLTSA_INFO_COORDINATE, "coordinate",
          "1-based coordinate of the fit whose margins count; 0: none."),
    real(STLTSA_INFO_CYCLICITY, "cyclicity",
         "How well that coordinate repeats once a period; 1: perfect."),
    whole(STLTSA_INFO_REPRESENTATIVE, "representative",
          "Index of the first cycle of the cyclic segment that lasts longest; -1: none."),
    whole(STLTSA_INFO_BEST, "best",
          "Index of the cycle most like the mean cycle of that segment; -1: none."),
    text(STLTSA_INFO_REASON, "reason", "Why no cycle is claimed; empty if cycles are."),
    real(STLTSA_INFO_EIGENVALUE, "eigenvalue",
         "Eigenvalues, ascending, the zero one first: of B, and of B / k in a dimension."),
    whole(STLTSA_INFO_LOCAL_PCA, "local_pca", "Intrinsic dimension by local PCA; 0: cannot tell."),
    whole(STLTSA_INFO_EIGENGAP, "eigengap", "Intrinsic dimension by the eigengap; 0: cannot tell."),
    whole(STLTSA_INFO_POSTURES, "postures",
          "Frames of up to 24 distinct postures, for pictures; to draw n, take the first n."),
    text(STLTSA_INFO_LOCAL_PCA_REASON, "local_pca_reason",
         "Why local PCA cannot tell; empty if it can."),
    text(STLTSA_INFO_EIGENGAP_REASON, "eigengap_reason",
         "Why the eigengap cannot tell; empty if it can."),
    real(STLTSA_INFO_VARIANCE, "variance", "Share of local variance that local PCA must explain."),
    real(STLTSA_INFO_EIGENGAP_THRESHOLD, "eigengap_threshold",
         "tau of section 2.3 as a fraction of k."),
    real(STLTSA_INFO_LOCAL_VARIANCE, "local_variance",
         "Mean share of a neighborhood's variance along each of its principal directions."),
    real(STLTSA_INFO_GAMMA, "gamma", "Threshold used in each column."),
    real(STLTSA_INFO_SHIFT, "shift",
         "d_t: mean distance of the points beyond gamma in each column."),
    real(STLTSA_INFO_NOISE, "noise", "Robust standard deviation of the residuals of each column."),
    real(STLTSA_INFO_DEGREES_OF_FREEDOM, "degrees_of_freedom",
         "Effective degrees of freedom of the curve of each column."),
    whole(STLTSA_INFO_MOVED, "moved", "Points that were moved in each column."),
    real(STLTSA_INFO_GAMMA_OPTION, "gamma_option",
         "Option gamma, if it was set; otherwise chosen for each column."),
    real(STLTSA_INFO_KNOT_ROWS, "knot_rows", "Rows between the knots of the curve."),
    whole(STLTSA_INFO_ROBUST, "robust", "1: the influence of spikes is reduced."),
    real(STLTSA_INFO_FIT_PERIOD_MIN, "fit_period_min",
         "period_min of the model whose coordinates these are; 0: none."),
    real(STLTSA_INFO_FIT_PERIOD_MAX, "fit_period_max", "period_max of that model; 0: none."),
    whole(STLTSA_INFO_COLUMNS, "columns", "Columns of the coordinates."),
    real(STLTSA_INFO_NOISE_SHARE, "noise_share",
         "Noise of each column as a share of its curve's range."),
    whole(STLTSA_INFO_NOTHING_TO_CLEAN, "nothing_to_clean",
          "1: the noise of every column is below 0.5 % of its range, which cannot be seen in a "
          "figure."),
    real(STLTSA_INFO_CROSSFADE, "crossfade",
         "Option crossfade, if it was set; otherwise chosen for each seam."),
    real(STLTSA_INFO_CUT_RANGE, "cut_range",
         "Option cut_range, if it was set; otherwise chosen for each seam."),
    real(STLTSA_INFO_POSTURE_LIMIT, "posture_limit", "Option posture_limit; 0: none."),
    text(STLTSA_INFO_PIECE_PATH, "piece_path",
         "Path of the clip of each piece; empty: from memory."),
    whole(STLTSA_INFO_PIECE_BEGIN, "piece_begin", "First frame of each piece."),
    whole(STLTSA_INFO_PIECE_END, "piece_end", "Frame after the last of each piece."),
    whole(STLTSA_INFO_PIECE_REPEAT, "piece_repeat", "How often each piece is played."),
    whole(STLTSA_INFO_LOOP, "loop", "1: a loop; only loops have the facts in_place to coverage."),
    whole(STLTSA_INFO_IN_PLACE, "in_place", "Option in_place."),
    real(STLTSA_INFO_TRAVEL, "travel",
         "x, y, z of the body's travel per loop along the ground; in place: what was removed."),
    real(STLTSA_INFO_TURN, "turn",
         "Degrees by which the body turns per loop; in place: what was removed."),
    real(STLTSA_INFO_COVERAGE, "coverage",
         "Share of the clip's cycles, or of the pieces' frames, that are in the loop."),
    whole(STLTSA_INFO_LOOP_CYCLES, "loop_cycles",
          "Cycles in the loop, if chosen among the clip's."),
    whole(STLTSA_INFO_SOURCE_CYCLES, "source_cycles", "Cycles of the clip, if chosen among them."),
    text(STLTSA_INFO_WARNING, "warning", "What a user should know about the result."),
    whole(STLTSA_INFO_WARNING_CODE, "warning_code", "STLTSA_WARNING_* of each warning."),
    real(STLTSA_INFO_WARNING_BEGIN, "warning_begin",
         "Seconds in the clip at which each warning applies; NaN: it has no time."),
    real(STLTSA_INFO_WARNING_END, "warning_end", "End of that time; the begin for a moment."),
    text(STLTSA_INFO_UNIT, "unit", "Unit of lengths, as the file states it; empty: unknown."),
    whole(STLTSA_INFO_FILE_UP_AXIS, "file_up_axis",
          "Axis that points up, as the file states it: 1, 2, 3 for x, y, z; 0: unknown.",
          "none=0 x=1 y=2 z=3"),
};

} // namespace

std::span<const stltsa_info_key> info_keys() {
    return rows;
}

} // namespace stltsa::capi
