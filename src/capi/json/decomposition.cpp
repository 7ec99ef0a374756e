// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "capi/json/parts.hpp"

namespace stltsa::capi {
namespace {

template <class Interval>
void set_span(JsonObject& object, const Interval& interval) {
    object.set("begin", interval.begin, "end", interval.end, "begin_s", interval.begin_s, "end_s",
               interval.end_s);
}

/// A, B, ... Z, AA, AB, ...; null for a rest.
Json label_json(int label) {
    if (label < 0)
        return nullptr;
    std::string text;
    for (int rest = label; rest >= 0; rest = rest / 26 - 1)
        text.insert(text.begin(), static_cast<char>('A' + rest % 26));
    return text;
}

Json segments_json(const Decomposed& decomposed) {
    std::vector<Json> list;
    for (std::size_t i = 0; i < decomposed.segments.size(); ++i) {
        const stltsa_segment& segment = decomposed.segments[i];
        JsonObject object("kind", stltsa_segment_name(segment.kind), "label",
                          label_json(segment.label), "likeness", segment.likeness);
        set_span(object, segment);
        object.set("period_s", json_positive_or_null(segment.period_s), "candidate_period_s",
                   json_positive_or_null(segment.candidate_period_s), "count", segment.count,
                   "carried_by", decomposed.carriers[i], "open_begin", segment.open_begin == 1,
                   "open_end", segment.open_end == 1, "confidence", segment.confidence,
                   "begin_confidence", segment.begin_confidence, "reason",
                   json_string_or_null(decomposed.reasons[i]), "first_step_share",
                   decomposed.halves[i].first, "first_step_margin", decomposed.halves[i].margin,
                   "steps_reason", json_string_or_null(decomposed.halves[i].reason));
        list.push_back(object);
    }
    return list;
}

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

Json units_json(std::span<const stltsa_interval> units) {
    std::vector<Json> list;
    for (const stltsa_interval& unit : units) {
        JsonObject object("kind", stltsa_unit_name(unit.kind), "segment", unit.segment);
        set_span(object, unit);
        list.push_back(object);
    }
    return list;
}

Json side_json(int32_t side) {
    return side < 0 ? Json(nullptr) : Json(side);
}

/// Null if names do not state it.
Json side_name_json(const Decomposed& decomposed, int32_t side) {
    const Side named = decomposed.named_side(side);
    if (named == Side::neither)
        return nullptr;
    return named == Side::left ? "left" : "right";
}

/// Null if nothing is known.
Json travel_json(const stltsa_travel& travel) {
    if (!std::isfinite(travel.way))
        return nullptr;
    return JsonObject("way", travel.way, "stride", travel.stride, "speed", travel.speed, "turn_deg",
                      travel.turn);
}

Json cycles_json(const Decomposed& decomposed) {
    std::vector<Json> list;
    for (const stltsa_part& cycle : decomposed.cycle_parts) {
        JsonObject object("segment", cycle.segment);
        set_span(object, cycle);
        object.set("side", side_json(cycle.side), "side_name",
                   side_name_json(decomposed, cycle.side), "likeness", cycle.likeness, "confidence",
                   cycle.confidence, "travel", travel_json(decomposed.cycle_travels[list.size()]));
        list.push_back(object);
    }
    return list;
}

Json steps_json(const Decomposed& decomposed) {
    std::vector<Json> list;
    for (const stltsa_part& step : decomposed.steps) {
        JsonObject object("segment", step.segment, "cycle", step.parent);
        set_span(object, step);
        object.set("side", side_json(step.side), "side_name", side_name_json(decomposed, step.side),
                   "travel", travel_json(decomposed.step_travels[list.size()]));
        list.push_back(object);
    }
    return list;
}

Json repetitions_json(const Decomposed& decomposed) {
    std::vector<Json> list;
    for (const stltsa_part& repetition : decomposed.repetitions) {
        const auto segment = static_cast<std::size_t>(repetition.segment);
        JsonObject object("segment", repetition.segment, "label",
                          label_json(decomposed.segments[segment].label));
        set_span(object, repetition);
        object.set("likeness", repetition.likeness, "confidence", repetition.confidence, "travel",
                   travel_json(decomposed.repetition_travels[list.size()]));
        list.push_back(object);
    }
    return list;
}

JsonObject statistics_object(const stltsa_statistics& found) {
    return JsonObject("mean", found.mean, "sd", found.sd, "cv", found.cv, "trend", found.trend);
}

/// Null if there is nothing of it.
Json statistics_json(const stltsa_statistics& found) {
    return found.count == 0 ? Json(nullptr) : Json(statistics_object(found));
}

/// With the means of both sides, to compare them; null without steps.
Json step_time_json(const Decomposed& decomposed, std::int32_t label) {
    const auto of_side = [&](std::int32_t side) {
        return results::statistics_of(decomposed.segments, decomposed.parts(STLTSA_PART_STEP),
                                      label, side, STLTSA_QUANTITY_TIME);
    };
    const stltsa_statistics both = of_side(-1);
    if (both.count == 0)
        return nullptr;
    JsonObject object = statistics_object(both);
    object.set("side_means", std::vector<double>{of_side(0).mean, of_side(1).mean});
    return object;
}

Json summary_json(const Decomposed& decomposed) {
    constexpr double minute = 60;
    std::vector<Json> list;
    for (const stltsa_summary& summary : decomposed.summaries) {
        const auto of = [&](std::int32_t kind, std::int32_t quantity) {
            return results::statistics_of(decomposed.segments, decomposed.parts(kind),
                                          summary.label, -1, quantity);
        };
        const bool cycles = of(STLTSA_PART_CYCLE, STLTSA_QUANTITY_TIME).count > 0;
        const auto travel = [&](std::int32_t quantity) {
            return statistics_json(
                of(cycles ? STLTSA_PART_CYCLE : STLTSA_PART_REPETITION, quantity));
        };
        const stltsa_statistics steps = of(STLTSA_PART_STEP, STLTSA_QUANTITY_TIME);
        list.push_back(JsonObject(
            "label", label_json(summary.label), "count", summary.count, "cycles_per_min",
            summary.per_minute, "cycle_time_s",
            JsonObject("mean", summary.mean_s, "sd", summary.sd_s, "cv", summary.cv, "trend",
                       summary.trend),
            "steps_per_min", steps.count == 0 ? Json(nullptr) : Json(minute / steps.mean),
            "step_time_s", step_time_json(decomposed, summary.label), "way",
            travel(STLTSA_QUANTITY_WAY), "stride", travel(STLTSA_QUANTITY_STRIDE), "speed",
            travel(STLTSA_QUANTITY_SPEED), "turn_deg", travel(STLTSA_QUANTITY_TURN)));
    }
    return list;
}

Json timed_warnings_json(std::span<const Warning> warnings) {
    std::vector<Json> list;
    for (const Warning& warning : warnings)
        list.push_back(JsonObject("code", static_cast<std::int64_t>(warning.code), "text",
                                  warning.text, "begin_s", warning.begin_s, "end_s",
                                  warning.end_s));
    return list;
}

/// The cycle with its index; null if there is none.
Json chosen_cycle(std::span<const stltsa_interval> cycles, std::int64_t index) {
    if (index < 0 || index >= static_cast<std::int64_t>(cycles.size()))
        return nullptr;
    JsonObject object("index", index);
    set_span(object, cycles[static_cast<std::size_t>(index)]);
    return object;
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
    object.set("segments", segments_json(decomposed));
    object.set("label_likeness", likeness_json(decomposed.label_likeness));
    object.set("units", units_json(decomposed.units));
    object.set("cycles", cycles_json(decomposed));
    object.set("steps", steps_json(decomposed));
    object.set("repetitions", repetitions_json(decomposed));
    object.set("summary", summary_json(decomposed));
    object.set("representative_cycle", chosen_cycle(decomposed.cycles, decomposed.representative));
    object.set("best_cycle", chosen_cycle(decomposed.cycles, decomposed.best));
    object.set("reason", json_string_or_null(decomposed.reason));
    object.set("warnings", timed_warnings_json(decomposed.warnings));
    return object.text();
}

} // namespace stltsa::capi
