// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json_parts.hpp"

namespace stltsa::capi {
namespace {

Json component_json(const ltsa::Component& component) {
    return {{"frames", component.frames},
            {"eigenvalues", component.eigenvalues},
            {"residual", component.residual},
            {"error_estimate_rad", component.error_estimate},
            {"gap", component.gap},
            {"rank_deficient_windows", component.rank_deficient_windows},
            {"solves", component.solves}};
}

Json components_json(const std::vector<ltsa::Component>& components) {
    Json list = Json::array();
    for (const ltsa::Component& component : components)
        list.push_back(component_json(component));
    return list;
}

Json estimate(int dimension, const std::string& reason) {
    return {{"dimension", json_count_or_null(dimension)}, {"reason", json_string_or_null(reason)}};
}

} // namespace

std::string model_json(const ModelFacts& facts) {
    const ltsa::Model& model = *facts.model;
    Json object = json_head("model");
    object["clip"] = json_clip(facts.clip, facts.samples);
    object["samples"] = json_samples(facts.samples);
    object["samples"]["lengths"] = model.lengths;
    object["parameters"] = json_parameters(model.parameters, facts.period);
    object["period_s"] = json_positive_or_null(facts.period.period);
    object["clock"] = model.clock;
    object["repeated_frames"] = model.repeated_frames;
    object["components"] = components_json(model.components);
    object["warnings"] = model.warnings;
    return json_text(object);
}

std::string dimension_json(const DimensionFacts& facts) {
    const ltsa::Dimension& dimension = *facts.dimension;
    Json object = json_head("dimension");
    object["clip"] = json_clip(facts.clip, facts.samples);
    object["samples"] = json_samples(facts.samples);
    object["parameters"] = json_parameters(dimension.parameters, facts.period);
    object["period_s"] = json_positive_or_null(facts.period.period);
    object["local_pca"] = estimate(dimension.local_pca, dimension.local_pca_reason);
    object["local_pca"]["variance"] = dimension.local_variance;
    object["local_pca"]["shares"] = dimension.local_variances;
    object["eigengap"] = estimate(dimension.eigengap, dimension.eigengap_reason);
    object["eigengap"]["threshold"] = dimension.threshold;
    object["eigengap"]["eigenvalues"] = dimension.eigenvalues;
    return json_text(object);
}

} // namespace stltsa::capi
