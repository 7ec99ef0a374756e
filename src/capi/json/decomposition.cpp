// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json/parts.hpp"

namespace stltsa::capi {
namespace {

void set_span(JsonObject& object, const stltsa_interval& interval) {
    object.set("begin", interval.begin, "end", interval.end, "begin_s", interval.begin_s, "end_s",
               interval.end_s);
}

Json units_json(std::span<const stltsa_interval> units) {
    std::vector<Json> list;
    for (const stltsa_interval& unit : units) {
        JsonObject object("kind", stltsa_unit_name(unit.kind));
        set_span(object, unit);
        list.push_back(object);
    }
    return list;
}

Json cycles_json(std::span<const stltsa_interval> cycles) {
    std::vector<Json> list;
    for (const stltsa_interval& cycle : cycles) {
        JsonObject object;
        set_span(object, cycle);
        list.push_back(object);
    }
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

Json embedding_json(const motion::Decomposition& found) {
    return JsonObject("eigenvalues", found.eigenvalues, "tangent_dimension",
                      found.parameters.dimension, "coordinate",
                      json_count_or_null(found.coordinate), "cyclicity", found.cyclicity);
}

Json intrinsic_json(const std::optional<ltsa::Dimension>& dimension) {
    if (!dimension)
        return nullptr;
    return JsonObject("local_pca", json_count_or_null(dimension->local_pca), "eigengap",
                      json_count_or_null(dimension->eigengap));
}

} // namespace

std::string decomposition_json(const Decomposed& decomposed) {
    const motion::Decomposition& found = decomposed.result;
    JsonObject object = json_head("decomposition");
    object.set("clip", json_clip(decomposed.source));
    object.set("samples", json_samples(decomposed.source.samples));
    object.set("parameters", json_parameters(found.parameters, decomposed.source.period));
    object.set("embedding", embedding_json(found));
    object.set("intrinsic_dimension", intrinsic_json(found.intrinsic));
    object.set("period_s", json_positive_or_null(decomposed.source.period.period));
    object.set("lag_quality", decomposed.source.period.lag_quality);
    object.set("units", units_json(decomposed.units));
    object.set("cycles", cycles_json(decomposed.cycles));
    object.set("representative_cycle", chosen_cycle(decomposed.cycles, found.representative));
    object.set("best_cycle", chosen_cycle(decomposed.cycles, found.best));
    object.set("reason", json_string_or_null(found.reason));
    object.set("warnings", json_warnings(found.warnings));
    return object.text();
}

} // namespace stltsa::capi
