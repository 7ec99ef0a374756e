// SPDX-License-Identifier: BSD-3-Clause
#include "capi/options/table.hpp"

#include <limits>

#include "base/error.hpp"

namespace stltsa::capi {
namespace {

constexpr double max_frames = 2147483647;
/// In place of a default: the library chooses.
constexpr double automatic = std::numeric_limits<double>::quiet_NaN();
constexpr double min_rate = 0.001; // frames a second

constexpr int32_t is_automatic(double standard) {
    return standard == standard ? 0 : 1;
}

constexpr stltsa_option_info whole(int32_t key, int32_t calls, const char* name, const char* text,
                                   double minimum, double maximum, double standard,
                                   const char* choices = nullptr) {
    return {0,       key,      STLTSA_TYPE_INT,        name, text, choices, minimum,
            maximum, standard, is_automatic(standard), calls};
}

constexpr stltsa_option_info real(int32_t key, int32_t calls, const char* name, const char* text,
                                  double minimum, double maximum, double standard) {
    return {0,       key,      STLTSA_TYPE_REAL,       name, text, nullptr, minimum,
            maximum, standard, is_automatic(standard), calls};
}

constexpr stltsa_option_info text(int32_t key, int32_t calls, const char* name, const char* text) {
    return {0, key, STLTSA_TYPE_TEXT, name, text, nullptr, 0, 0, automatic, 1, calls};
}

constexpr int32_t embeds = STLTSA_CALL_FIT; // from frames or clips
constexpr int32_t analyzes = embeds | STLTSA_CALL_DECOMPOSE;
constexpr int32_t maps = STLTSA_CALL_MAP | STLTSA_CALL_UNMAP;

constexpr stltsa_option_info all_options[] = {
    whole(STLTSA_OPT_NEIGHBORS, embeds, "neighbors",
          "Neighbors of each frame (k); auto: 1.2 periods, without a period 1.2 seconds, or 12 "
          "frames without a rate.",
          1, max_frames, automatic),
    whole(STLTSA_OPT_WINDOW, embeds, "window",
          "Window (w), frames to each side; auto: as neighbors.", 1, max_frames, automatic),
    whole(STLTSA_OPT_DIMENSION, embeds, "dimension",
          "Tangent dimension, the number of coordinates (d); auto: 2.", 1, 1000, automatic),
    whole(STLTSA_OPT_MODE, embeds, "mode",
          "Candidates for neighbors: temporal, frames of the clip within the window; spatial, all "
          "frames; recurrent, frames within the window and, as links, frames outside the exclusion "
          "zone.",
          1, 3, STLTSA_MODE_TEMPORAL, "temporal=1 spatial=2 recurrent=3"),
    whole(STLTSA_OPT_INCLUDE_SELF, embeds, "include_self", "Count a frame among its own neighbors.",
          0, 1, 1),
    whole(STLTSA_OPT_LINKS, embeds, "links", "Recurrent: neighbors beyond the exclusion zone.", 1,
          max_frames, 4),
    whole(STLTSA_OPT_EXCLUSION, embeds, "exclusion",
          "Recurrent: half width of that zone, frames; auto: window.", 1, max_frames, automatic),
    whole(STLTSA_OPT_THREADS, analyzes | maps, "threads", "Threads; auto: one for each core.", 1,
          1024, automatic),
    whole(STLTSA_OPT_FEATURES, analyzes | STLTSA_CALL_FEATURES, "features",
          "Description of a pose: positions (of the joints, without root position and yaw), "
          "rotations6d, euler (the file's angles), raw (the file's numbers) or points (such as "
          "markers, three columns each, without path and heading); auto: positions if there is a "
          "skeleton, points if the columns are named so (heel_x, heel_y, heel_z, ...), otherwise "
          "raw.",
          1, 5, automatic, "positions=1 rotations6d=2 euler=3 raw=4 points=5"),
    whole(STLTSA_OPT_UP_AXIS, analyzes | STLTSA_CALL_FEATURES | STLTSA_CALL_SYNTHESIZE, "up_axis",
          "The axis that points up; auto: found from the skeleton; of points, the file's, or else "
          "guessed.",
          1, 3, automatic, "x=1 y=2 z=3"),
    whole(STLTSA_OPT_KEEP_START, analyzes, "keep_start",
          "Keep a T-pose at the start instead of dropping it.", 0, 1, 0),
    real(STLTSA_OPT_FPS, embeds | STLTSA_CALL_OPEN | STLTSA_CALL_UNMAP | STLTSA_CALL_DENOISE, "fps",
         "Frames per second, for files without a rate, or instead of theirs (not in batch); of "
         "unmapped points; auto: the file's, or the model's.",
         min_rate, 1e6, automatic),
    real(STLTSA_OPT_SAMPLE_RATE, analyzes, "sample_rate",
         "Decimate clips to about this frame rate; 0: keep all.", 0, 1e6, 30),
    real(STLTSA_OPT_SMOOTHING, analyzes, "smoothing",
         "Smoothing of the features: sigma in seconds; 0: none.", 0, 10, 0.05),
    real(STLTSA_OPT_PERIOD_MIN, analyzes | STLTSA_CALL_DENOISE, "period_min",
         "Shortest period of the search, in seconds; in frames if the rate is unknown, 4 by "
         "default.",
         0.01, 3600, 0.3),
    real(STLTSA_OPT_PERIOD_MAX, analyzes | STLTSA_CALL_DENOISE, "period_max",
         "Longest period of the search, in seconds; in frames if the rate is unknown, half of all, "
         "at most 1000, by default.",
         0.01, 3600, 6),
    real(STLTSA_OPT_EIGENGAP, STLTSA_CALL_FIT, "eigengap",
         "Smallest eigengap that counts (tau), as a share of k.", 0, 1, 0.1),
    real(STLTSA_OPT_VARIANCE, STLTSA_CALL_FIT, "variance",
         "Share of local variance that local PCA must explain.", 0.01, 1, 0.95),
    whole(STLTSA_OPT_INTRINSIC, STLTSA_CALL_FIT, "intrinsic",
          "Also estimate the intrinsic dimension, in two ways.", 0, 1, 0),
    text(STLTSA_OPT_SKELETON, STLTSA_CALL_OPEN, "skeleton",
         "The ASF file of an AMC clip; auto: found beside the clip."),
    whole(STLTSA_OPT_KEEP_FRAMES, STLTSA_CALL_FIT, "keep_frames",
          "Keep the fitted frames in the model, so that it can map.", 0, 1, 1),
    whole(STLTSA_OPT_MAP_NEIGHBORS, maps, "map_neighbors",
          "Rows for each local map; auto: d + 5, at least 10.", 1, max_frames, automatic),
    whole(STLTSA_OPT_MAP_BLEND, maps, "map_blend",
          "Local maps to blend, each from its own part of the curve.", 1, 1000, 3),
    whole(STLTSA_OPT_HINT_WINDOW, maps, "hint_window",
          "Rows to search on each side of a hint; auto: k / 5.", 1, max_frames, automatic),
    whole(STLTSA_OPT_COMPONENT, STLTSA_CALL_UNMAP, "component",
          "Component of the coordinates, from 0; auto: the only one.", 0, max_frames, automatic),
    real(STLTSA_OPT_GAMMA, STLTSA_CALL_DENOISE, "gamma",
         "Distance from the curve beyond which a point is noisy; auto: one robust deviation of the "
         "residuals.",
         0, 1e15, automatic),
    real(STLTSA_OPT_KNOT_SPACING, STLTSA_CALL_DENOISE, "knot_spacing",
         "Seconds between knots, or rows if the rate is unknown; auto: a tenth of the period, "
         "otherwise 2 rows.",
         0.001, 1e6, automatic),
    whole(STLTSA_OPT_ROBUST, STLTSA_CALL_DENOISE, "robust",
          "Reduce the influence of spikes on the curve.", 0, 1, 1),
    real(STLTSA_OPT_CROSSFADE, STLTSA_CALL_SYNTHESIZE, "crossfade",
         "Seconds to blend on each side of a seam; auto: a tenth of the repeated cycle, or 0.15 "
         "between clips.",
         0, 60, automatic),
    real(STLTSA_OPT_CUT_RANGE, STLTSA_CALL_SYNTHESIZE, "cut_range",
         "Seconds by which a cut may move; auto: a tenth of the repeated cycle; between clips half "
         "a cycle, at least 0.5.",
         0, 3600, automatic),
    real(STLTSA_OPT_POSTURE_LIMIT, STLTSA_CALL_SYNTHESIZE, "posture_limit",
         "Max distance of the postures at a seam, relative to that of repetitions; 0: no limit.", 0,
         1e6, 3),
    whole(STLTSA_OPT_SEGMENTS, STLTSA_CALL_DECOMPOSE, "segments",
          "Number of segments in motion; auto: as behavior changes.", 1, 10000, automatic),
    whole(STLTSA_OPT_GAPS, analyzes | STLTSA_CALL_FEATURES, "gaps",
          "Missing points or values: fill, up to 0.25 s over time, longer ones from the others in "
          "the same frame; skip, all from the others, so that they add nothing to distances; "
          "refuse, an error.",
          1, 3, STLTSA_GAPS_FILL, "fill=1 refuse=2 skip=3"),
    real(STLTSA_OPT_MIN_CONFIDENCE, STLTSA_CALL_OPEN, "min_confidence",
         "Points seen with less confidence are missing.", 0, 1, 0.6),
    whole(STLTSA_OPT_LOOP, STLTSA_CALL_SYNTHESIZE, "loop",
          "Make a loop: the last frame meets the first.", 0, 1, 0),
    whole(STLTSA_OPT_IN_PLACE, STLTSA_CALL_SYNTHESIZE, "in_place",
          "Remove the travel and the turn of a loop.", 0, 1, 0),
    text(STLTSA_OPT_SUBJECT, STLTSA_CALL_OPEN, "subject",
         "Person or animal in a file: the prefix of its points (Viktor of Viktor:LHEE) or its "
         "name; auto: the only one."),
};

} // namespace

std::span<const stltsa_option_info> options_table() {
    return all_options;
}

const stltsa_option_info& option_row(int32_t key) {
    for (const auto& row : all_options)
        if (row.key == key)
            return row;
    fail(Status::argument, "there is no option {}; see stltsa_option_describe", key);
}

const stltsa_option_info& option_row(int32_t key, int32_t type) {
    const auto& row = option_row(key);
    if (row.type != type)
        fail(Status::argument, "option {} holds {}", row.name,
             row.type == STLTSA_TYPE_INT    ? "an integer"
             : row.type == STLTSA_TYPE_REAL ? "a real number"
                                            : "a text");
    return row;
}

} // namespace stltsa::capi
