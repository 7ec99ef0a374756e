// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json_parts.hpp"

namespace stltsa::capi {
namespace {

Json span_json(const stltsa_interval& interval) {
    return {{"begin", interval.begin},
            {"end", interval.end},
            {"begin_s", interval.begin_s},
            {"end_s", interval.end_s}};
}

Json units_json(std::span<const stltsa_interval> units) {
    Json list = Json::array();
    for (const stltsa_interval& unit : units) {
        Json object = {{"kind", stltsa_unit_name(unit.kind)}};
        object.update(span_json(unit));
        list.push_back(std::move(object));
    }
    return list;
}

Json cycles_json(std::span<const stltsa_interval> cycles) {
    Json list = Json::array();
    for (const stltsa_interval& cycle : cycles)
        list.push_back(span_json(cycle));
    return list;
}

/// The cycle itself and its place among the cycles; null where there is none.
Json chosen_cycle(std::span<const stltsa_interval> cycles, std::int64_t index) {
    if (index < 0 || index >= static_cast<std::int64_t>(cycles.size()))
        return nullptr;
    Json object = {{"index", index}};
    object.update(span_json(cycles[static_cast<std::size_t>(index)]));
    return object;
}

Json embedding_json(const motion::Decomposition& found) {
    return {{"eigenvalues", found.eigenvalues},
            {"tangent_dimension", found.parameters.dimension},
            {"coordinate", json_count_or_null(found.coordinate)},
            {"cyclicity", found.cyclicity}};
}

Json intrinsic_json(const ltsa::Dimension* dimension) {
    if (dimension == nullptr)
        return nullptr;
    return {{"local_pca", json_count_or_null(dimension->local_pca)},
            {"eigengap", json_count_or_null(dimension->eigengap)}};
}

} // namespace

std::string decomposition_json(const DecompositionFacts& facts) {
    const motion::Decomposition& found = *facts.decomposition;
    Json object = json_head("decomposition");
    object["clip"] = json_clip(facts.clip, facts.samples);
    object["samples"] = json_samples(facts.samples);
    object["parameters"] = json_parameters(found.parameters, facts.period);
    object["embedding"] = embedding_json(found);
    object["intrinsic_dimension"] = intrinsic_json(facts.dimension);
    object["period_s"] = json_positive_or_null(facts.period.period);
    object["lag_quality"] = facts.period.lag_quality;
    object["units"] = units_json(facts.units);
    object["cycles"] = cycles_json(facts.cycles);
    object["representative_cycle"] = chosen_cycle(facts.cycles, found.representative);
    object["best_cycle"] = chosen_cycle(facts.cycles, found.best);
    object["reason"] = json_string_or_null(found.reason);
    object["warnings"] = found.warnings;
    return json_text(object);
}

} // namespace stltsa::capi
