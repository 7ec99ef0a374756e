// SPDX-License-Identifier: BSD-3-Clause
#include "capi/compared_rows.hpp"
#include "capi/json/fields.hpp"
#include "capi/json/parts.hpp"

namespace stltsa::capi {
namespace {

using Whole = stltsa_compared;
using Motion = stltsa_compared_motion;
using Part = stltsa_compared_part;
using Estimate = stltsa_estimate;
using Bounded = stltsa_bounded;

constexpr Field<Estimate> estimate_fields[] = {
    {"first", value<&Estimate::first>},
    {"first_sd", value<&Estimate::first_sd>},
    {"second", value<&Estimate::second>},
    {"second_sd", value<&Estimate::second_sd>},
    {"difference", value<&Estimate::difference>},
    {"standard_error", value<&Estimate::standard_error>},
    {"low", value<&Estimate::low>},
    {"high", value<&Estimate::high>},
    {"significant", flag<&Estimate::significant>},
};

constexpr Field<Bounded> bounded_fields[] = {
    {"value", value<&Bounded::value>},
    {"low", value<&Bounded::low>},
    {"high", value<&Bounded::high>},
};

template <auto member>
Json estimate(const Of<member>& row) {
    return row_json(estimate_fields, row.*member);
}

template <auto member>
Json bounded(const Of<member>& row) {
    return row_json(bounded_fields, row.*member);
}

constexpr Field<Motion> motion_fields[] = {
    {"path", known<&Motion::path>},         {"frames", value<&Motion::frames>},
    {"fps", value<&Motion::fps>},           {"label", value<&Motion::letters>},
    {"cycles", value<&Motion::cycles>},     {"cycles_per_min", value<&Motion::cycles_per_min>},
    {"left_out", texts<&Motion::left_out>},
};

constexpr Field<Whole> alignment_fields[] = {
    {"shift", value<&Whole::shift>},       {"standard_error", value<&Whole::shift_error>},
    {"low", value<&Whole::shift_low>},     {"high", value<&Whole::shift_high>},
    {"likeness", value<&Whole::likeness>}, {"runner_up", value<&Whole::runner_up>},
    {"turn_deg", value<&Whole::turn_deg>},
};

constexpr Field<Part> difference_fields[] = {
    {"lag", estimate<&Part::lag>},
    {"lag_s", bounded<&Part::lag_s>},
    {"amplitude", estimate<&Part::amplitude>},
    {"amplitude_ratio", bounded<&Part::amplitude_ratio>},
    {"rms_difference", value<&Part::rms_difference>},
    {"rms_by_chance", value<&Part::rms_by_chance>},
    {"correlation", value<&Part::correlation>},
};

/// A column of samples.
Json curve(const Matrix& samples, std::int64_t column) {
    std::vector<double> values;
    for (std::int64_t s = 0; s < samples.rows(); ++s)
        values.push_back(samples(s, column));
    return values;
}

Json channel_json(const stltsa_comparison& of, std::size_t channel) {
    const Part row = compared_channel_row(of, channel);
    const auto column = static_cast<std::int64_t>(channel);
    const auto curves = [&](const ComparedMotion& motion) {
        return JsonObject("mean", curve(motion.mean, column), "sd",
                          curve(motion.deviation, column));
    };
    return JsonObject("axis", known<&Part::axis>(row), "mean", estimate<&Part::mean>(row), "first",
                      curves(of.motions[0]), "second", curves(of.motions[1]), "difference",
                      JsonObject("mean", curve(of.differences.difference, column), "standard_error",
                                 curve(of.differences.error, column), "margin",
                                 curve(of.differences.margin, column)),
                      "differences", row_json(difference_fields, row));
}

Json parts_json(const stltsa_comparison& of) {
    std::vector<Json> parts;
    std::size_t channel = 0; // they come part by part
    for (std::size_t p = 0; p < of.columns.names.size(); ++p) {
        std::vector<Json> channels;
        for (; channel < of.columns.part.size() &&
               of.columns.part[channel] == static_cast<std::int64_t>(p);
             ++channel)
            channels.push_back(channel_json(of, channel));
        const Part row = compared_part_row(of, p);
        parts.push_back(JsonObject("first", row.first, "second", row.second, "differences",
                                   row_json(difference_fields, row), "channels", channels));
    }
    return parts;
}

} // namespace

std::string comparison_json(const stltsa_comparison& of) {
    const Whole whole = compared_row(of);
    JsonObject object = json_head("comparison");
    object.set("kind", whole.sides != 0 ? "left_right" : "two_motions", "features",
               json_name(of.features), "samples", whole.samples);
    object.set("first", row_json(motion_fields, compared_motion_row(of, 0)), "second",
               row_json(motion_fields, compared_motion_row(of, 1)));
    object.set("alignment", row_json(alignment_fields, whole));
    object.set("size_ratio", whole.size_ratio, "cycle_time_s",
               row_json(estimate_fields, whole.cycle_time_s));
    object.set("judged", whole.judged, "significant", whole.significant, "expected_by_chance",
               whole.expected_by_chance);
    object.set("parts", parts_json(of), "warnings", json_warnings(of.warnings));
    return object.text();
}

} // namespace stltsa::capi
