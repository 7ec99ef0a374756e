// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json_parts.hpp"

namespace stltsa::capi {
namespace {

Json parameters_json(const DenoisingFacts& facts) {
    const double fps = facts.samples.fps;
    const double step = facts.options.knot_step;
    return JsonObject("gamma", facts.options.gamma < 0 ? Json(nullptr) : Json(facts.options.gamma),
                      "knot_rows", step, "knot_s", fps > 0 ? Json(step / fps) : Json(nullptr),
                      "robust", facts.options.robust, "period_min_s",
                      json_positive_or_null(facts.period.shortest), "period_max_s",
                      json_positive_or_null(facts.period.longest));
}

Json column_json(const motion::DenoisedColumn& column) {
    return JsonObject("gamma", column.gamma, "shift", column.shift, "noise", column.noise,
                      "degrees_of_freedom", column.degrees_of_freedom, "moved", column.moved);
}

} // namespace

std::string denoising_json(const DenoisingFacts& facts) {
    JsonObject object = json_head("denoising");
    object.set("clip", json_clip(facts.clip, facts.samples));
    JsonObject samples = json_samples(facts.samples);
    samples.set("lengths", std::vector(facts.lengths.begin(), facts.lengths.end()));
    object.set("samples", samples);
    object.set("fit", facts.fit == nullptr ? Json(nullptr)
                                           : json_parameters(*facts.fit, facts.fit_period));
    object.set("period_s", json_positive_or_null(facts.period.period));
    object.set("parameters", parameters_json(facts));
    std::vector<Json> columns;
    for (const motion::DenoisedColumn& column : facts.denoised->columns)
        columns.push_back(column_json(column));
    object.set("columns", columns);
    object.set("warnings", json_warnings(facts.warnings));
    return object.text();
}

} // namespace stltsa::capi
