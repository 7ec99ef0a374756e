// SPDX-License-Identifier: BSD-3-Clause
// Parts that the JSON objects of clips, models and decompositions share.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/json.hpp"
#include "capi/json/results.hpp"

namespace stltsa::capi {

using namespace results;

/// {"format": "stltsa-<kind>/<schema>", "library": "<version>"}: the head of every object.
JsonObject json_head(const char* kind, int schema = 1);

Json json_string_or_null(const std::string& text);
/// null for 0, which means that a rate, a period or a dimension is unknown.
Json json_positive_or_null(double value);
Json json_or_null(std::optional<double> value);
Json json_count_or_null(std::int64_t value);

const char* json_name(clip::Format format);
const char* json_name(clip::Features features);
const char* json_name(ltsa::Mode mode);
Json json_axis(clip::Axis axis);

/// `dropped`: frames of a T-pose left out at the start.
JsonObject json_clip(const ClipFacts& clip, clip::Features features, std::int64_t dropped);
/// null for a matrix and for several clips.
Json json_clip(const Source& source);
JsonObject json_samples(const SampleFacts& samples);
/// Their texts.
Json json_warnings(std::span<const Warning> warnings);
Json json_parameters(const ltsa::Parameters& parameters, const Source& source);

} // namespace stltsa::capi
