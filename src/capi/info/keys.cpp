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

constexpr stltsa_info_key list(int32_t key, const char* name, const char* text) {
    return {0, key, STLTSA_TYPE_ROWS, name, text, nullptr, 0, 0};
}

constexpr stltsa_info_key array(int32_t key, const char* name, const char* text) {
    return {0, key, STLTSA_TYPE_ARRAY, name, text, nullptr, 0, 0};
}

constexpr stltsa_info_key all_keys[] = {
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
    whole(STLTSA_INFO_COORDINATE, "coordinate",
          "1-based coordinate of the fit whose margins count; 0: none."),
    real(STLTSA_INFO_CYCLICITY, "cyclicity",
         "How well that coordinate repeats once a period; 1: perfect."),
    whole(STLTSA_INFO_REPRESENTATIVE, "representative",
          "Index of the first cycle of the cyclic segment that lasts longest; -1: none."),
    whole(STLTSA_INFO_BEST, "best",
          "Index of the cycle most like the mean cycle of that segment; -1: none."),
    text(STLTSA_INFO_REASON, "reason", "Why nothing repeats; empty if anything does."),
    real(STLTSA_INFO_EIGENVALUE, "eigenvalue",
         "Eigenvalues of B, ascending, the zero one first; of a model, those of B / k that the "
         "estimate "
         "of the dimension rests on."),
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
    real(STLTSA_INFO_GAMMA_OPTION, "gamma_option",
         "Option gamma, if it was set; otherwise chosen for each column."),
    real(STLTSA_INFO_KNOT_ROWS, "knot_rows", "Rows between the knots of the curve."),
    whole(STLTSA_INFO_ROBUST, "robust", "1: the influence of spikes is reduced."),
    real(STLTSA_INFO_FIT_PERIOD_MIN, "fit_period_min",
         "period_min of the model whose coordinates these are; 0: none."),
    real(STLTSA_INFO_FIT_PERIOD_MAX, "fit_period_max", "period_max of that model; 0: none."),
    whole(STLTSA_INFO_NOTHING_TO_CLEAN, "nothing_to_clean",
          "1: the noise of every column is below 0.5 % of its range, which cannot be seen in a "
          "figure."),
    real(STLTSA_INFO_CROSSFADE, "crossfade",
         "Option crossfade, if it was set; otherwise chosen for each seam."),
    real(STLTSA_INFO_CUT_RANGE, "cut_range",
         "Option cut_range, if it was set; otherwise chosen for each seam."),
    real(STLTSA_INFO_POSTURE_LIMIT, "posture_limit", "Option posture_limit; 0: none."),
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
    text(STLTSA_INFO_LENGTH_UNIT, "length_unit",
         "Unit of lengths, as the file states it; empty: unknown."),
    whole(STLTSA_INFO_FILE_UP_AXIS, "file_up_axis",
          "Axis that points up, as the file states it: 1, 2, 3 for x, y, z; 0: unknown.",
          "none=0 x=1 y=2 z=3"),
    list(STLTSA_INFO_COMPONENT, "component", "stltsa_component: those of the neighborhood graph."),
    whole(STLTSA_INFO_HAS_CYCLE, "has_cycle",
          "1: the model keeps a mean cycle, see stltsa_model_keep_cycle."),
    array(STLTSA_INFO_COORDS, "coords",
          "Rows x d: the coordinates; of a decomposition, rows x 2: the curve, and itself a "
          "quarter of a cycle behind, the loop of Fig. 1."),
    array(STLTSA_INFO_EIGENVALUES, "eigenvalues",
          "Components x (d + 2): lambda_1 = 0, lambda_2, ..., ascending; NaN if a component is "
          "too small."),
    array(STLTSA_INFO_COMPONENT_OF, "component_of",
          "Rows x 1: component of each row, numbered from 0 in the order of their first rows."),
    list(STLTSA_INFO_SEGMENT, "segment",
         "stltsa_segment, in temporal order; they cover [0, frames of the clip) without gap or "
         "overlap."),
    list(STLTSA_INFO_UNIT, "unit", "stltsa_unit; they cover the clip, too."),
    list(STLTSA_INFO_CYCLE, "cycle", "stltsa_part, in temporal order."),
    list(STLTSA_INFO_STEP, "step",
         "stltsa_part: halves of cycles; none unless both sides alternate."),
    list(STLTSA_INFO_REPETITION, "repetition",
         "stltsa_part: single actions of segments of repetitions."),
    list(STLTSA_INFO_SUMMARY, "summary", "stltsa_summary: one for each label that repeats."),
    whole(STLTSA_INFO_SIDE, "side",
          "STLTSA_SIDE_* that side 0 and side 1 of parts are; STLTSA_SIDE_NONE if no names "
          "tell. Assumes right-handed axes."),
    array(STLTSA_INFO_CURVE, "curve",
          "Rows x 1: the smoothed coordinate whose margins count, 0 outside cyclic segments, "
          "each of which has a coordinate of its own; of a denoising, rows x columns: the "
          "fitted curve f_c."),
    array(STLTSA_INFO_LABEL_LIKENESS, "label_likeness",
          "Labels x labels: how similar their segments are, 0 (different) to 1 (same): the mean "
          "over pairs of segments, at most 24 of each label. It compares the postures, the "
          "speeds, and which parts of the body move together; moderate differences in size and "
          "tempo change it little. From about 0.65 on, segments share a label, except "
          "repetitions, which are grouped by their course. NaN for a label of one segment with "
          "itself."),
    list(STLTSA_INFO_COLUMN, "column", "stltsa_denoised_column: one for each column."),
    array(STLTSA_INFO_CLEANED, "cleaned", "Rows x columns: the points after equation (1)."),
    array(STLTSA_INFO_MOVES, "moves", "Rows x columns: displacement of each point; 0: not moved."),
    list(STLTSA_INFO_PIECE, "piece", "stltsa_piece_fact: what was joined."),
    list(STLTSA_INFO_SEAM, "seam", "stltsa_seam, in temporal order."),
    list(STLTSA_INFO_WARNING, "warning",
         "stltsa_warning: what a user should know about the result."),
    list(STLTSA_INFO_JOINT, "joint", "stltsa_joint, parents first; none without a skeleton."),
    list(STLTSA_INFO_FILE_EVENT, "file_event", "stltsa_file_event, in order of time."),
    whole(STLTSA_INFO_CHANNELS, "channels", "Channels, columns or coordinates of each frame."),
    array(STLTSA_INFO_POSITIONS, "positions",
          "Frames x (3 * joints): world positions by forward kinematics; none without a "
          "skeleton."),
    array(STLTSA_INFO_ROTATIONS, "rotations",
          "Frames x (4 * joints): local rotations w x y z, with signs continuous over time; "
          "none without a skeleton."),
    array(STLTSA_INFO_PHASE, "phase",
          "Frames x 1, of each frame of the file, in [0, 1); NaN outside cycles."),
    array(STLTSA_INFO_PHASE_RESIDUAL, "phase_residual",
          "Frames x 1: distance from the mean cycle in pose and velocity, as a share of the "
          "root mean square deviation of the motion; NaN outside cycles."),
    array(STLTSA_INFO_PHASE_CYCLE, "phase_cycle",
          "Frames x 1: index of the cycle; -1 outside cycles."),
    real(STLTSA_INFO_PHASE_ZERO, "phase_zero",
         "Of each label, the phase, in [0, 1), at which the body is at the same place in every "
         "clip and person with the same features, wherever their cycles begin: where the legs "
         "pass each other, if the two sides of the body are known and swing; 0: a label with "
         "repetitions only; NaN: one with neither."),
    text(STLTSA_INFO_OWNER, "owner",
         "The joint, or the point or column of the file, that each column of the features "
         "belongs to: makes the groups of stltsa_cycles_group_distance."),
    array(STLTSA_INFO_VALUES, "values", "Samples x columns: each cycle."),
    array(STLTSA_INFO_MEAN, "mean",
          "Samples x columns: mean over the cycles; of a comparison, of the first and the "
          "second motion, at phases of the first."),
    array(STLTSA_INFO_DEVIATION, "deviation",
          "The same: standard deviation; of a single cycle, NaN."),
    array(STLTSA_INFO_SAMPLE_FRAMES, "sample_frames",
          "Cycles x samples: the frame of each sample, not rounded."),
    array(STLTSA_INFO_WARP, "warp",
          "Cycles x samples: how much later than in linear time, as a share of the cycle."),
    array(STLTSA_INFO_DISTANCE, "distance",
          "Cycles x 1: distance of each cycle from the mean, root mean square over samples and "
          "columns, as a share of the root of the variance along the mean cycle."),
    array(STLTSA_INFO_COLUMN_DISTANCE, "column_distance",
          "Cycles x columns: root mean square over the samples, in the unit of the signal."),
    list(STLTSA_INFO_EVENT, "event", "stltsa_event, in order of time."),
    real(STLTSA_INFO_LIKENESS, "likeness",
         "Correlation of the mean cycles of the two clips; 1 within a clip. Events of another "
         "person are to be trusted less below 0.95; below 0.6 it is another motion, and there "
         "are none."),
    list(STLTSA_INFO_COMPARISON, "comparison", "stltsa_compared: one, about the whole."),
    list(STLTSA_INFO_MOTION, "motion", "stltsa_compared_motion: the first, the second."),
    list(STLTSA_INFO_PART, "part",
         "stltsa_compared_part: joints, points or columns, in the order of the first clip."),
    list(STLTSA_INFO_PART_CHANNEL, "part_channel",
         "stltsa_compared_part: the coordinates of the parts, part by part."),
    array(STLTSA_INFO_DIFFERENCE, "difference", "Samples x channels: second minus first."),
    array(STLTSA_INFO_STANDARD_ERROR, "standard_error", "Samples x channels: its standard error."),
    array(STLTSA_INFO_MARGIN, "margin",
          "Samples x channels: half the width of its 95 % interval, which holds for one sample: "
          "of 100 samples without a difference, about five exclude 0 by chance."),
    text(STLTSA_INFO_MARK, "mark", "Marks of the model, in the order in which they were kept."),
};

} // namespace

std::span<const stltsa_info_key> info_keys() {
    return all_keys;
}

} // namespace stltsa::capi
