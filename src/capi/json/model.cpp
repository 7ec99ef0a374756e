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

Json local_pca(const ltsa::Dimension& found) {
    return JsonObject("dimension", json_count_or_null(found.local_pca), "reason",
                      json_string_or_null(found.local_pca_reason), "variance", found.local_variance,
                      "shares", found.local_variances);
}

Json eigengap(const ltsa::Dimension& found) {
    return JsonObject("dimension", json_count_or_null(found.eigengap), "reason",
                      json_string_or_null(found.eigengap_reason), "threshold", found.threshold,
                      "eigenvalues", found.eigenvalues);
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
    if (fitted.dimension)
        object.set("local_pca", local_pca(*fitted.dimension), "eigengap",
                   eigengap(*fitted.dimension));
    object.set("warnings", json_warnings(model.warnings));
    return object.text();
}

} // namespace stltsa::capi
