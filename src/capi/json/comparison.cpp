// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "capi/json/parts.hpp"

namespace stltsa::capi {
namespace {

using phase::Estimate;
using phase::PartDifference;

/// A column of samples.
Json curve(const Matrix& samples, std::int64_t column) {
    std::vector<double> values;
    for (std::int64_t s = 0; s < samples.rows(); ++s)
        values.push_back(samples(s, column));
    return values;
}

Json estimate_json(const Estimate& of) {
    return JsonObject("first", of.first, "first_sd", of.first_sd, "second", of.second, "second_sd",
                      of.second_sd, "difference", of.difference, "standard_error", of.error, "low",
                      of.low, "high", of.high, "significant", of.significant);
}

Json interval_json(double value, double low, double high) {
    return JsonObject("value", value, "low", low, "high", high);
}

JsonObject differences_json(const PartDifference& of, double cycle_time) {
    return JsonObject("lag", estimate_json(of.lag), "lag_s",
                      interval_json(of.lag.difference * cycle_time, of.lag.low * cycle_time,
                                    of.lag.high * cycle_time),
                      "amplitude", estimate_json(of.amplitude), "amplitude_ratio",
                      interval_json(of.ratio.difference, of.ratio.low, of.ratio.high),
                      "rms_difference", of.rms, "rms_by_chance", of.chance, "correlation",
                      of.correlation);
}

Json motion_json(const Comparison& of, std::size_t which) {
    const ComparedMotion& motion = of.motions[which];
    const double time = which == 0 ? of.cycle_time.first : of.cycle_time.second;
    return JsonObject("path", json_string_or_null(motion.clip.path), "frames", motion.clip.frames,
                      "fps", motion.clip.fps > 0 ? motion.clip.fps : none, "label",
                      letters_of(motion.label), "cycles", motion.cycles, "cycles_per_min",
                      60 / time, "left_out",
                      which == 0 ? of.columns.left_out : of.columns.other_left_out);
}

Json channel_json(const Comparison& of, std::size_t channel) {
    const PartDifference& found = of.differences.columns[channel];
    JsonObject object("axis", json_string_or_null(of.columns.axis[channel]), "mean",
                      estimate_json(found.mean));
    const auto column = static_cast<std::int64_t>(channel);
    const auto curves = [&](const ComparedMotion& motion) {
        return JsonObject("mean", curve(motion.mean, column), "sd",
                          curve(motion.deviation, column));
    };
    object.set("first", curves(of.motions[0]), "second", curves(of.motions[1]), "difference",
               JsonObject("mean", curve(of.differences.difference, column), "standard_error",
                          curve(of.differences.error, column), "margin",
                          curve(of.differences.margin, column)));
    object.set("differences", differences_json(found, mean_cycle_time(of)));
    return object;
}

Json parts_json(const Comparison& of) {
    std::vector<Json> parts;
    for (std::size_t p = 0; p < of.columns.names.size(); ++p) {
        std::vector<Json> channels;
        for (std::size_t c = 0; c < of.columns.part.size(); ++c)
            if (of.columns.part[c] == static_cast<std::int64_t>(p))
                channels.push_back(channel_json(of, c));
        parts.push_back(JsonObject(
            "first", of.columns.names[p], "second", of.columns.other_names[p], "differences",
            differences_json(of.differences.parts[p], mean_cycle_time(of)), "channels", channels));
    }
    return parts;
}

} // namespace

std::string comparison_json(const Comparison& of) {
    JsonObject object = json_head("comparison");
    object.set("kind", of.sides ? "left_right" : "two_motions", "features", json_name(of.features),
               "samples", of.samples);
    object.set("first", motion_json(of, 0), "second", motion_json(of, 1));
    object.set("alignment",
               JsonObject("shift", of.shift.difference, "standard_error", of.shift.error, "low",
                          of.shift.low, "high", of.shift.high, "likeness", of.likeness, "runner_up",
                          of.runner_up, "turn_deg", of.turn));
    object.set("size_ratio", of.size_ratio, "cycle_time_s", estimate_json(of.cycle_time));
    object.set("judged", of.judged, "significant", of.significant, "expected_by_chance",
               expected_by_chance(of));
    object.set("parts", parts_json(of), "warnings", json_warnings(of.warnings));
    return object.text();
}

} // namespace stltsa::capi
