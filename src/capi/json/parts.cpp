// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json/parts.hpp"

#include "clip/formats.hpp"

namespace stltsa::capi {

JsonObject json_head(const char* kind, int schema) {
    return JsonObject("format", format_text("stltsa-{}/{}", kind, schema), "library",
                      stltsa_version());
}

Json json_string_or_null(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json json_positive_or_null(double value) {
    return value > 0 ? Json(value) : Json(nullptr);
}

Json json_or_null(std::optional<double> value) {
    return value ? Json(*value) : Json(nullptr);
}

Json json_count_or_null(std::int64_t value) {
    return value > 0 ? Json(value) : Json(nullptr);
}

const char* json_name(clip::Format format) {
    if (const clip::FormatRow* row = clip::find_format(format))
        return row->name;
    fail(Status::internal, "a clip of the unknown format {}", static_cast<int>(format));
}

const char* json_name(clip::Features features) {
    switch (features) {
    case clip::Features::positions:
        return "positions";
    case clip::Features::rotations6d:
        return "rotations6d";
    case clip::Features::euler:
        return "euler";
    case clip::Features::raw:
        return "raw";
    case clip::Features::points:
        return "points";
    }
    fail(Status::internal, "features of the unknown kind {}", static_cast<int>(features));
}

const char* json_name(ltsa::Mode mode) {
    switch (mode) {
    case ltsa::Mode::temporal:
        return "temporal";
    case ltsa::Mode::spatial:
        return "spatial";
    case ltsa::Mode::recurrent:
        return "recurrent";
    }
    fail(Status::internal, "a fit of the unknown mode {}", static_cast<int>(mode));
}

Json json_axis(clip::Axis axis) {
    switch (axis) {
    case clip::Axis::none:
        return nullptr;
    case clip::Axis::x:
        return "x";
    case clip::Axis::y:
        return "y";
    case clip::Axis::z:
        return "z";
    }
    fail(Status::internal, "the unknown axis {}", static_cast<int>(axis));
}

JsonObject json_clip(const ClipFacts& clip, clip::Features features, std::int64_t dropped) {
    const bool timed = clip.fps > 0;
    return JsonObject("path", json_string_or_null(clip.path), "format", json_name(clip.format),
                      "frames", clip.frames, "fps", json_positive_or_null(clip.fps), "duration_s",
                      timed ? Json(static_cast<double>(clip.frames) / clip.fps) : Json(nullptr),
                      "features", json_name(features), "dropped_start_frames", dropped, "notes",
                      clip.notes);
}

Json json_clip(const Source& source) {
    if (source.clips.size() != 1)
        return nullptr;
    return json_clip(source.clips.front(), source.samples.features, source.samples.first);
}

JsonObject json_samples(const SampleFacts& samples) {
    return JsonObject("count", samples.count, "first_frame", samples.first, "frame_step",
                      samples.step, "fps", json_positive_or_null(samples.fps), "feature_count",
                      samples.feature_count, "up_axis", json_axis(samples.up), "smoothing_s",
                      samples.smoothing);
}

Json json_warnings(std::span<const Warning> warnings) {
    std::vector<Json> texts;
    for (const Warning& warning : warnings)
        texts.push_back(warning.text);
    return texts;
}

Json json_parameters(const ltsa::Parameters& parameters, const Source& source) {
    const bool fitted = parameters.neighbors > 0;
    JsonObject object("mode", fitted ? json_name(parameters.mode) : Json(nullptr), "neighbors",
                      json_count_or_null(parameters.neighbors), "window",
                      json_count_or_null(parameters.window), "dimension",
                      json_count_or_null(parameters.dimension), "include_self",
                      fitted ? Json(parameters.include_self) : Json(nullptr));
    const bool recurrent = parameters.mode == ltsa::Mode::recurrent;
    object.set("links", recurrent ? Json(parameters.links) : Json(nullptr));
    object.set("exclusion", recurrent ? Json(parameters.exclusion) : Json(nullptr));
    const PeriodFacts period = in_seconds(source.period, source.samples);
    object.set("period_min_s", json_positive_or_null(period.shortest));
    object.set("period_max_s", json_positive_or_null(period.longest));
    return object;
}

} // namespace stltsa::capi
