// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json/parts.hpp"

namespace stltsa::capi {
namespace {

Json component_json(const ltsa::Component& component) {
    return JsonObject("frames", component.frames, "eigenvalues", component.eigenvalues, "residual",
                      component.residual, "error_estimate_rad", component.error_estimate, "gap",
                      component.gap, "rank_deficient_windows", component.rank_deficient_windows,
                      "solves", component.solves);
}

Json components_json(const std::vector<ltsa::Component>& components) {
    std::vector<Json> list;
    for (const ltsa::Component& component : components)
        list.push_back(component_json(component));
    return list;
}

JsonObject estimate(int dimension, const std::string& reason) {
    return JsonObject("dimension", json_count_or_null(dimension), "reason",
                      json_string_or_null(reason));
}

} // namespace

std::string model_json(const Fitted& fitted) {
    const ltsa::Model& model = fitted.model;
    JsonObject object = json_head("model");
    object.set("clip", json_clip(fitted.source));
    JsonObject samples = json_samples(fitted.source.samples);
    samples.set("lengths", fitted.lengths);
    object.set("samples", samples);
    object.set("parameters", json_parameters(model.parameters, fitted.source));
    object.set("period_s", json_positive_or_null(
                               in_seconds(fitted.source.period, fitted.source.samples).period));
    object.set("time_correlation", model.time_correlation);
    object.set("repeated_frames", model.repeated_frames);
    object.set("components", components_json(model.components));
    object.set("warnings", json_warnings(model.warnings));
    return object.text();
}

std::string dimension_json(const EstimatedDimension& estimated) {
    const ltsa::Dimension& dimension = estimated.dimension;
    JsonObject object = json_head("dimension");
    object.set("clip", json_clip(estimated.source));
    object.set("samples", json_samples(estimated.source.samples));
    object.set("parameters", json_parameters(dimension.parameters, estimated.source));
    object.set("period_s",
               json_positive_or_null(
                   in_seconds(estimated.source.period, estimated.source.samples).period));
    JsonObject local_pca = estimate(dimension.local_pca, dimension.local_pca_reason);
    local_pca.set("variance", dimension.local_variance, "shares", dimension.local_variances);
    object.set("local_pca", local_pca);
    JsonObject eigengap = estimate(dimension.eigengap, dimension.eigengap_reason);
    eigengap.set("threshold", dimension.threshold, "eigenvalues", dimension.eigenvalues);
    object.set("eigengap", eigengap);
    return object.text();
}

} // namespace stltsa::capi
