// SPDX-License-Identifier: BSD-3-Clause
#include "capi/options/table.hpp"

#include <limits>

#include "base/error.hpp"

namespace stltsa::capi {
namespace {

constexpr double most_frames = 2147483647;
/// In place of a default: the library chooses.
constexpr double automatic = std::numeric_limits<double>::quiet_NaN();
constexpr double least_rate = 0.001; // frames a second

constexpr int32_t is_automatic(double standard) {
    return standard == standard ? 0 : 1;
}

constexpr stltsa_option_info whole(int32_t key, const char* name, const char* text, double minimum,
                                   double maximum, double standard, const char* choices = nullptr) {
    return {0,       key,     STLTSA_TYPE_INT, name,     text,
            choices, minimum, maximum,         standard, is_automatic(standard)};
}

constexpr stltsa_option_info real(int32_t key, const char* name, const char* text, double minimum,
                                  double maximum, double standard) {
    return {0,       key,     STLTSA_TYPE_REAL, name,     text,
            nullptr, minimum, maximum,          standard, is_automatic(standard)};
}

constexpr stltsa_option_info text(int32_t key, const char* name, const char* text) {
    return {0, key, STLTSA_TYPE_TEXT, name, text, nullptr, 0, 0, automatic, 1};
}

constexpr stltsa_option_info rows[] = {
    whole(STLTSA_OPT_NEIGHBORS, "neighbors",
          "Neighbors of each frame (k); auto: 1.2 periods if a period is found, otherwise 1.2 "
          "seconds, or 12 if the frame rate is unknown.",
          1, most_frames, automatic),
    whole(STLTSA_OPT_WINDOW, "window",
          "Frames to each side that neighbors come from (w); auto: as neighbors.", 1, most_frames,
          automatic),
    whole(STLTSA_OPT_DIMENSION, "dimension",
          "Tangent dimension, the number of coordinates (d); auto: fit 2, decompose the best of 1 "
          "to 3.",
          1, 1000, automatic),
    whole(STLTSA_OPT_MODE, "mode",
          "Where neighbors are looked for: temporal, within the window of the clip; spatial, among "
          "all frames; recurrent, within the window and, as links, among all frames outside the "
          "exclusion zone.",
          1, 3, STLTSA_MODE_TEMPORAL, "temporal=1 spatial=2 recurrent=3"),
    whole(STLTSA_OPT_INCLUDE_SELF, "include_self", "Count a frame among its own neighbors.", 0, 1,
          1),
    whole(STLTSA_OPT_LINKS, "links", "Recurrent: neighbors from outside the exclusion zone.", 1,
          most_frames, 4),
    whole(STLTSA_OPT_EXCLUSION, "exclusion",
          "Recurrent: frames to each side that are not links; auto: as window.", 1, most_frames,
          automatic),
    whole(STLTSA_OPT_THREADS, "threads", "Threads; auto: every core.", 1, 1024, automatic),
    whole(STLTSA_OPT_FEATURES, "features",
          "What a pose is described by: positions of the joints without root position and yaw, "
          "rotations6d, euler (the file's angles), raw (the file's numbers); auto: positions if "
          "there is a skeleton, otherwise raw.",
          1, 4, automatic, "positions=1 rotations6d=2 euler=3 raw=4"),
    whole(STLTSA_OPT_UP_AXIS, "up_axis", "The axis that points up; auto: found from the skeleton.",
          1, 3, automatic, "x=1 y=2 z=3"),
    whole(STLTSA_OPT_KEEP_START, "keep_start", "Keep a T-pose at the start instead of dropping it.",
          0, 1, 0),
    real(STLTSA_OPT_FPS, "fps",
         "Frames a second, over what the file says; of unmap, points a second; auto: the file's, "
         "or the model's.",
         least_rate, 1e6, automatic),
    real(STLTSA_OPT_SAMPLE_RATE, "sample_rate",
         "Decimate a clip to about this many frames a second: one frame in fps / rate, rounded, is "
         "kept; 0: keep all.",
         0, 1e6, 30),
    real(STLTSA_OPT_SMOOTHING, "smoothing",
         "Sigma in seconds of the Gaussian that smooths the features; 0: none.", 0, 10, 0.05),
    real(STLTSA_OPT_PERIOD_MIN, "period_min", "Shortest period looked for, in seconds.", 0.01, 3600,
         0.3),
    real(STLTSA_OPT_PERIOD_MAX, "period_max", "Longest period looked for, in seconds.", 0.01, 3600,
         6),
    real(STLTSA_OPT_EIGENGAP, "eigengap",
         "Gap between eigenvalues that tells the dimension, as a fraction of the neighbors.", 0, 1,
         0.1),
    real(STLTSA_OPT_VARIANCE, "variance",
         "Share of a neighborhood's variance that local PCA must hold.", 0.01, 1, 0.95),
    text(STLTSA_OPT_SKELETON, "skeleton",
         "The ASF file of an AMC clip; auto: found beside the clip."),
    whole(STLTSA_OPT_KEEP_FRAMES, "keep_frames",
          "Keep in a model the frames it was fitted to, so that it can map.", 0, 1, 1),
    whole(STLTSA_OPT_MAP_NEIGHBORS, "map_neighbors",
          "Rows that a local map rests on; auto: the dimension and 5 more, at least 10.", 1,
          most_frames, automatic),
    whole(STLTSA_OPT_MAP_BLEND, "map_blend", "Stretches of the curve whose local maps are blended.",
          1, 1000, 3),
    whole(STLTSA_OPT_HINT_WINDOW, "hint_window",
          "Rows to each side of a hint in which a frame is looked for; auto: a fifth of the "
          "neighbors.",
          1, most_frames, automatic),
    whole(STLTSA_OPT_COMPONENT, "component",
          "Component of the model that coordinates are of, counted from 0; auto: the only one.", 0,
          most_frames, automatic),
    real(STLTSA_OPT_GAMMA, "gamma",
         "Distance from the curve beyond which a point is noisy, in units of the coordinate; auto: "
         "one robust standard deviation.",
         0, 1e15, automatic),
    real(STLTSA_OPT_KNOT_SPACING, "knot_spacing",
         "Seconds between the knots of the smooth curve, rows if the rate is unknown; auto: a "
         "tenth of the period, otherwise 2 rows.",
         0.001, 1e6, automatic),
    whole(STLTSA_OPT_ROBUST, "robust", "Fit the smooth curve so that spikes do not pull at it.", 0,
          1, 1),
    real(STLTSA_OPT_CROSSFADE, "crossfade",
         "Seconds to each side of a seam that are blended; auto: a tenth of the cycle that is "
         "repeated, 0.15 where clips join.",
         0, 60, automatic),
    real(STLTSA_OPT_CUT_RANGE, "cut_range",
         "Seconds by which a cut may move to find a common posture; auto: a tenth of the cycle "
         "that is repeated, half a cycle and at least 0.5 where clips join.",
         0, 3600, automatic),
    real(STLTSA_OPT_POSTURE_LIMIT, "posture_limit",
         "Largest distance of the postures at a seam, over what is common between repetitions of "
         "one motion; 0: none.",
         0, 1e6, 3),
    whole(STLTSA_OPT_DIMENSION_ESTIMATE, "dimension_estimate",
          "Also estimate the intrinsic dimension of what is embedded.", 0, 1, 0),
};

} // namespace

std::span<const stltsa_option_info> options_table() {
    return rows;
}

const stltsa_option_info& option_row(int32_t key) {
    for (const auto& row : rows)
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
