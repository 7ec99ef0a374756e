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
    text(STLTSA_INFO_CHANNEL, "channel", "Names of its channels, if the file has names."),
    whole(STLTSA_INFO_FEATURES, "features", "STLTSA_FEATURES_* used.",
          "positions=1 rotations6d=2 euler=3 raw=4 points=5"),
    whole(STLTSA_INFO_FEATURE_COUNT, "feature_count", "Columns of the features."),
    whole(STLTSA_INFO_UP_AXIS, "up_axis", "Up axis: 1, 2, 3 for x, y, z; 0: not needed.",
          "none=0 x=1 y=2 z=3"),
    real(STLTSA_INFO_SMOOTHING, "smoothing", "Sigma of the smoothing, in seconds; 0: none."),
    whole(STLTSA_INFO_ROWS, "rows", "Rows that the method worked on."),
    whole(STLTSA_INFO_LENGTH, "length", "Rows of each clip; of a denoising, of each spline."),
    whole(STLTSA_INFO_FIRST_FRAME, "first_frame", "Row i is frame first_frame + i * frame_step."),
    whole(STLTSA_INFO_FRAME_STEP, "frame_step", "See first_frame; 1 for matrices."),
    real(STLTSA_INFO_FPS, "fps", "Rows a second; 0: unknown."),
    whole(STLTSA_INFO_BODY_ROOT, "body_root", "Joint that turns the body; its ancestors do not."),
    whole(STLTSA_INFO_MODE, "mode", "STLTSA_MODE_*.", "temporal=1 spatial=2 recurrent=3"),
    whole(STLTSA_INFO_NEIGHBORS, "neighbors", "k used, in rows."),
    whole(STLTSA_INFO_WINDOW, "window", "w used, in rows to each side."),
    whole(STLTSA_INFO_DIMENSION, "dimension", "Tangent dimension d."),
    whole(STLTSA_INFO_INCLUDE_SELF, "include_self", "1: a row is among its own neighbors."),
    whole(STLTSA_INFO_LINKS, "links", "Recurrent: neighbors beyond the exclusion zone."),
    whole(STLTSA_INFO_EXCLUSION, "exclusion", "Recurrent: half width of that zone in rows."),
    real(STLTSA_INFO_PERIOD, "period", "Period in seconds; 0: none, or rate unknown."),
    real(STLTSA_INFO_LAG_QUALITY, "lag_quality", "Match of velocities a period apart, 0 to 1."),
    real(STLTSA_INFO_PERIOD_MIN, "period_min", "Shortest period of the search, seconds; 0: none."),
    real(STLTSA_INFO_PERIOD_MAX, "period_max", "Longest period of the search, seconds; 0: none."),
    real(STLTSA_INFO_PERIOD_ROWS, "period_rows", "Period in rows; 0: none."),
    whole(STLTSA_INFO_REPEATED, "repeated", "Rows collapsed because they repeat the one before."),
    real(STLTSA_INFO_TIME_CORRELATION, "time_correlation",
         "|rank correlation| of coordinate 1 and time."),
    real(STLTSA_INFO_REACH, "reach",
         "Distance from the fitted frames up to which a frame is like them; 0: the model cannot "
         "map."),
    whole(STLTSA_INFO_COORDINATE, "coordinate", "Coordinate whose margins count, from 1; 0: none."),
    real(STLTSA_INFO_CYCLICITY, "cyclicity", "How well that coordinate repeats; 1: perfect."),
    whole(STLTSA_INFO_REPRESENTATIVE, "representative",
          "First cycle of the longest cyclic segment, or -1."),
    whole(STLTSA_INFO_BEST, "best", "Cycle there that is most like the mean; -1: none."),
    text(STLTSA_INFO_REASON, "reason", "Why nothing repeats; empty if anything does."),
    real(STLTSA_INFO_EIGENVALUE, "eigenvalue",
         "Eigenvalues of B, ascending; of a model, of B / k."),
    whole(STLTSA_INFO_LOCAL_PCA, "local_pca", "Intrinsic dimension by local PCA; 0: cannot tell."),
    whole(STLTSA_INFO_EIGENGAP, "eigengap", "Intrinsic dimension by the eigengap; 0: cannot tell."),
    whole(STLTSA_INFO_POSTURES, "postures", "Up to 24 distinct frames for pictures, best first."),
    text(STLTSA_INFO_LOCAL_PCA_REASON, "local_pca_reason",
         "Why local PCA cannot tell; empty if it can."),
    text(STLTSA_INFO_EIGENGAP_REASON, "eigengap_reason",
         "Why the eigengap cannot tell; empty if it can."),
    real(STLTSA_INFO_VARIANCE, "variance", "Share of local variance that local PCA must explain."),
    real(STLTSA_INFO_EIGENGAP_THRESHOLD, "eigengap_threshold",
         "tau of section 2.3 as a fraction of k."),
    real(STLTSA_INFO_LOCAL_VARIANCE, "local_variance",
         "Mean share of variance of each local direction."),
    real(STLTSA_INFO_GAMMA_OPTION, "gamma_option", "Option gamma; none: chosen for each column."),
    real(STLTSA_INFO_KNOT_ROWS, "knot_rows", "Rows between the knots of the curve."),
    whole(STLTSA_INFO_ROBUST, "robust", "1: the influence of spikes is reduced."),
    real(STLTSA_INFO_FIT_PERIOD_MIN, "fit_period_min",
         "period_min of the coordinates' model; 0: none."),
    real(STLTSA_INFO_FIT_PERIOD_MAX, "fit_period_max", "period_max of that model; 0: none."),
    whole(STLTSA_INFO_NOTHING_TO_CLEAN, "nothing_to_clean",
          "1: noise is below 0.5 % of each column's range."),
    real(STLTSA_INFO_CROSSFADE, "crossfade", "Option crossfade; none: chosen for each seam."),
    real(STLTSA_INFO_CUT_RANGE, "cut_range", "Option cut_range; none: chosen for each seam."),
    real(STLTSA_INFO_POSTURE_LIMIT, "posture_limit", "Option posture_limit; 0: none."),
    whole(STLTSA_INFO_LOOP, "loop", "1: a loop; only loops have the next six facts."),
    whole(STLTSA_INFO_IN_PLACE, "in_place", "Option in_place; 1: travel and turn are removed."),
    real(STLTSA_INFO_TRAVEL, "travel", "x, y, z of a loop's travel along the ground."),
    real(STLTSA_INFO_TURN, "turn", "Degrees that a loop turns, positive to the left."),
    real(STLTSA_INFO_COVERAGE, "coverage", "Share of cycles, or pieces' frames, in the loop."),
    whole(STLTSA_INFO_LOOP_CYCLES, "loop_cycles",
          "Cycles in the loop, if chosen among the clip's."),
    whole(STLTSA_INFO_SOURCE_CYCLES, "source_cycles", "Cycles of the clip, if chosen among them."),
    text(STLTSA_INFO_LENGTH_UNIT, "length_unit", "Unit of lengths, such as mm; empty: unknown."),
    whole(STLTSA_INFO_FILE_UP_AXIS, "file_up_axis",
          "Up axis that the file states (TRC: y); 0: none.", "none=0 x=1 y=2 z=3"),
    list(STLTSA_INFO_COMPONENT, "component", "stltsa_component: those of the neighborhood graph."),
    whole(STLTSA_INFO_HAS_CYCLE, "has_cycle", "1: keeps a mean cycle (stltsa_model_keep_cycle)."),
    array(STLTSA_INFO_COORDS, "coords",
          "Rows x d: coordinates; of a decomposition, rows x 2: the curve, and itself a quarter "
          "cycle behind."),
    array(STLTSA_INFO_EIGENVALUES, "eigenvalues",
          "Components x (d + 2), ascending from lambda_1 = 0; NaN: the component is too small."),
    array(STLTSA_INFO_COMPONENT_OF, "component_of",
          "Rows x 1: component of each row, in order, from 0."),
    list(STLTSA_INFO_SEGMENT, "segment", "stltsa_segment, in order; they cover the clip."),
    list(STLTSA_INFO_UNIT, "unit", "stltsa_unit, in order; they cover the clip, too."),
    list(STLTSA_INFO_CYCLE, "cycle", "stltsa_part, in order."),
    list(STLTSA_INFO_STEP, "step", "stltsa_part: half cycles, if sides alternate."),
    list(STLTSA_INFO_REPETITION, "repetition", "stltsa_part: the actions of repetitions."),
    list(STLTSA_INFO_SUMMARY, "summary", "stltsa_summary: one for each label that repeats."),
    whole(STLTSA_INFO_SIDE, "side",
          "STLTSA_SIDE_* of sides 0 and 1, in right-handed axes; STLTSA_SIDE_NONE: no names tell."),
    array(STLTSA_INFO_CURVE, "curve",
          "Rows x 1: smoothed coordinate of each cyclic segment, else 0; of a denoising, rows x "
          "columns: the curve f_c."),
    array(STLTSA_INFO_LABEL_LIKENESS, "label_likeness",
          "Labels x labels: mean likeness of segments, 0 to 1; from about 0.65 on they share a "
          "label; NaN: a single segment."),
    list(STLTSA_INFO_COLUMN, "column", "stltsa_denoised_column: one for each column."),
    array(STLTSA_INFO_CLEANED, "cleaned", "Rows x columns: the points after equation (1)."),
    array(STLTSA_INFO_MOVES, "moves", "Rows x columns: how far each point was moved."),
    list(STLTSA_INFO_PIECE, "piece", "stltsa_piece_fact: what was joined."),
    list(STLTSA_INFO_SEAM, "seam", "stltsa_seam, in order."),
    list(STLTSA_INFO_WARNING, "warning", "stltsa_warning: what to know about the result."),
    list(STLTSA_INFO_JOINT, "joint", "stltsa_joint, parents first."),
    list(STLTSA_INFO_FILE_EVENT, "file_event", "stltsa_file_event, in order of time."),
    whole(STLTSA_INFO_CHANNELS, "channels", "Channels, columns or coordinates of each frame."),
    array(STLTSA_INFO_POSITIONS, "positions", "Frames x (3 * joints): positions in the world."),
    array(STLTSA_INFO_ROTATIONS, "rotations", "Frames x (4 * joints): local, w x y z, continuous."),
    array(STLTSA_INFO_PHASE, "phase", "Frames of the file x 1, in [0, 1); NaN: no cycle."),
    array(STLTSA_INFO_PHASE_RESIDUAL, "phase_residual",
          "Frames x 1: distance from the mean cycle, as a share of the motion's rms deviation; "
          "NaN: no cycle."),
    array(STLTSA_INFO_PHASE_CYCLE, "phase_cycle", "Frames x 1: index of the cycle; -1: no cycle."),
    real(STLTSA_INFO_PHASE_ZERO, "phase_zero",
         "Of each label, phase of a place that all clips with these features share; 0: only "
         "repetitions; NaN: neither."),
    text(STLTSA_INFO_OWNER, "owner", "Joint, point or column of each feature."),
    array(STLTSA_INFO_VALUES, "values", "Samples x columns: each cycle."),
    array(STLTSA_INFO_MEAN, "mean",
          "Samples x columns: mean of the cycles; of a comparison, of both motions, at phases of "
          "the first."),
    array(STLTSA_INFO_DEVIATION, "deviation", "The same: standard deviation; of one cycle, NaN."),
    array(STLTSA_INFO_SAMPLE_FRAMES, "sample_frames",
          "Cycles x samples: frame of each, not rounded."),
    array(STLTSA_INFO_WARP, "warp", "Cycles x samples: delay, as a share of the cycle."),
    array(STLTSA_INFO_DISTANCE, "distance",
          "Cycles x 1: rms distance from the mean cycle, as a share of the deviation along it."),
    array(STLTSA_INFO_COLUMN_DISTANCE, "column_distance",
          "Cycles x columns: the same, in the signal's unit."),
    list(STLTSA_INFO_EVENT, "event", "stltsa_event, in order of time."),
    real(STLTSA_INFO_LIKENESS, "likeness",
         "Correlation of both mean cycles, 1 within a clip; below 0.95 events are less sure, below "
         "0.6 there are none."),
    list(STLTSA_INFO_COMPARISON, "comparison", "stltsa_compared: one, about the whole."),
    list(STLTSA_INFO_MOTION, "motion", "stltsa_compared_motion: the first, the second."),
    list(STLTSA_INFO_PART, "part", "stltsa_compared_part: joints, points or columns."),
    list(STLTSA_INFO_PART_CHANNEL, "part_channel",
         "stltsa_compared_part: coordinates, part by part."),
    array(STLTSA_INFO_DIFFERENCE, "difference", "Samples x channels: second minus first."),
    array(STLTSA_INFO_STANDARD_ERROR, "standard_error", "Samples x channels: its standard error."),
    array(STLTSA_INFO_MARGIN, "margin", "Samples x channels: half a pointwise 95 % interval."),
    text(STLTSA_INFO_MARK, "mark", "Marks of the model, in the order they were kept."),
};

} // namespace

std::span<const stltsa_info_key> info_keys() {
    return all_keys;
}

} // namespace stltsa::capi
