// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/names.hpp"
#include "capi/json/fields.hpp"
#include "capi/json/parts.hpp"

namespace stltsa::capi {
namespace {

using Segment = stltsa_segment;
using Unit = stltsa_unit;
using Part = stltsa_part;
using Statistics = stltsa_statistics;
using Summary = stltsa_summary;

constexpr Field<Segment> segment_fields[] = {
    {"kind", [](const Segment& s) { return Json(name_of(segment_kinds, s.kind)); }},
    {"label", known<&Segment::letters>},
    {"likeness", value<&Segment::likeness>},
    {"begin", value<&Segment::begin>},
    {"end", value<&Segment::end>},
    {"begin_s", value<&Segment::begin_s>},
    {"end_s", value<&Segment::end_s>},
    {"period_s", value<&Segment::period_s>},
    {"candidate_period_s", value<&Segment::candidate_period_s>},
    {"count", value<&Segment::count>},
    {"carried_by", texts<&Segment::carried_by>},
    {"open_begin", flag<&Segment::open_begin>},
    {"open_end", flag<&Segment::open_end>},
    {"confidence", value<&Segment::confidence>},
    {"begin_confidence", value<&Segment::begin_confidence>},
    {"reason", known<&Segment::reason>},
    {"first_step_share", value<&Segment::first_step_share>},
    {"first_step_margin", value<&Segment::first_step_margin>},
    {"steps_reason", known<&Segment::steps_reason>},
};

constexpr Field<Unit> unit_fields[] = {
    {"kind", [](const Unit& u) { return Json(name_of(unit_kinds, u.kind)); }},
    {"segment", value<&Unit::segment>},
    {"begin", value<&Unit::begin>},
    {"end", value<&Unit::end>},
    {"begin_s", value<&Unit::begin_s>},
    {"end_s", value<&Unit::end_s>},
};

constexpr Field<Part> travel_fields[] = {
    {"path_length", value<&Part::path_length>},
    {"stride", value<&Part::stride>},
    {"speed", value<&Part::speed>},
    {"turn_deg", value<&Part::turn_deg>},
};

/// Null if nothing is known.
Json travel(const Part& part) {
    return std::isfinite(part.path_length) ? Json(row_json(travel_fields, part)) : Json(nullptr);
}

constexpr Field<Part> cycle_fields[] = {
    {"segment", value<&Part::segment>},
    {"begin", value<&Part::begin>},
    {"end", value<&Part::end>},
    {"begin_s", value<&Part::begin_s>},
    {"end_s", value<&Part::end_s>},
    {"side", known<&Part::side>},
    {"side_name", known<&Part::side_name>},
    {"likeness", value<&Part::likeness>},
    {"confidence", value<&Part::confidence>},
    {"travel", travel},
};

constexpr Field<Part> step_fields[] = {
    {"segment", value<&Part::segment>},
    {"cycle", value<&Part::cycle>},
    {"begin", value<&Part::begin>},
    {"end", value<&Part::end>},
    {"begin_s", value<&Part::begin_s>},
    {"end_s", value<&Part::end_s>},
    {"side", known<&Part::side>},
    {"side_name", known<&Part::side_name>},
    {"travel", travel},
};

constexpr Field<Part> repetition_fields[] = {
    {"segment", value<&Part::segment>},
    {"label", known<&Part::letters>},
    {"begin", value<&Part::begin>},
    {"end", value<&Part::end>},
    {"begin_s", value<&Part::begin_s>},
    {"end_s", value<&Part::end_s>},
    {"likeness", value<&Part::likeness>},
    {"confidence", value<&Part::confidence>},
    {"travel", travel},
};

constexpr Field<Statistics> statistics_fields[] = {
    {"mean", value<&Statistics::mean>},
    {"sd", value<&Statistics::sd>},
    {"cv", value<&Statistics::cv>},
    {"trend", value<&Statistics::trend>},
};

/// Null if there is nothing of it.
template <Statistics Summary::*of>
Json statistics(const Summary& summary) {
    return (summary.*of).count == 0 ? Json(nullptr)
                                    : Json(row_json(statistics_fields, summary.*of));
}

/// With the means of both sides, to compare them.
Json step_time(const Summary& summary) {
    if (summary.step_time_s.count == 0)
        return nullptr;
    JsonObject object = row_json(statistics_fields, summary.step_time_s);
    object.set("side_means",
               std::vector<double>{summary.step_time_side_0_s, summary.step_time_side_1_s});
    return object;
}

constexpr Field<Summary> summary_fields[] = {
    {"label", known<&Summary::letters>},
    {"count", value<&Summary::count>},
    {"cycles_per_min", value<&Summary::cycles_per_min>},
    {"cycle_time_s", statistics<&Summary::cycle_time_s>},
    {"steps_per_min", value<&Summary::steps_per_min>},
    {"step_time_s", step_time},
    {"path_length", statistics<&Summary::path_length>},
    {"stride", statistics<&Summary::stride>},
    {"speed", statistics<&Summary::speed>},
    {"turn_deg", statistics<&Summary::turn_deg>},
};

constexpr Field<Warning> warning_fields[] = {
    {"code", [](const Warning& w) { return Json(static_cast<std::int64_t>(w.code)); }},
    {"text", value<&Warning::text>},
    {"begin_s", value<&Warning::begin_s>},
    {"end_s", value<&Warning::end_s>},
};

/// In thousandths, because there are so many numbers if there are many labels.
Json likeness_json(const Matrix& likeness) {
    constexpr double digits = 1000;
    std::vector<Json> rows;
    for (std::int64_t label = 0; label < likeness.rows(); ++label) {
        std::vector<double> row;
        for (std::int64_t other = 0; other < likeness.cols(); ++other)
            row.push_back(std::round(digits * likeness(label, other)) / digits);
        rows.push_back(row);
    }
    return rows;
}

/// The cycle with its index; null if there is none.
Json chosen_cycle(const std::vector<Part>& cycles, std::int64_t index) {
    if (index < 0 || index >= std::ssize(cycles))
        return nullptr;
    const Part& cycle = cycles[static_cast<std::size_t>(index)];
    return JsonObject("index", index, "begin", cycle.begin, "end", cycle.end, "begin_s",
                      cycle.begin_s, "end_s", cycle.end_s);
}

Json embedding_json(const motion::Curve& found) {
    return JsonObject("eigenvalues", found.eigenvalues, "tangent_dimension",
                      json_count_or_null(found.parameters.dimension), "coordinate",
                      json_count_or_null(found.coordinate), "cyclicity", found.cyclicity);
}

} // namespace

std::string decomposition_json(const Decomposed& decomposed) {
    JsonObject object = json_head("decomposition", 2);
    object.set("clip", json_clip(decomposed.source));
    object.set("samples", json_samples(decomposed.source.samples));
    object.set("parameters", json_parameters(decomposed.curve.parameters, decomposed.source));
    object.set("embedding", embedding_json(decomposed.curve));
    object.set("period_s", json_positive_or_null(decomposed.source.period.period));
    object.set("lag_quality", decomposed.source.period.lag_quality);
    object.set("segments", rows_json(segment_fields, decomposed.segments));
    object.set("label_likeness", likeness_json(decomposed.label_likeness));
    object.set("units", rows_json(unit_fields, decomposed.units));
    object.set("cycles", rows_json(cycle_fields, decomposed.cycles));
    object.set("steps", rows_json(step_fields, decomposed.steps));
    object.set("repetitions", rows_json(repetition_fields, decomposed.repetitions));
    object.set("summary", rows_json(summary_fields, decomposed.summaries));
    object.set("representative_cycle", chosen_cycle(decomposed.cycles, decomposed.representative));
    object.set("best_cycle", chosen_cycle(decomposed.cycles, decomposed.best));
    object.set("reason", json_string_or_null(decomposed.reason));
    object.set("warnings", rows_json(warning_fields, decomposed.warnings));
    return object.text();
}

} // namespace stltsa::capi
