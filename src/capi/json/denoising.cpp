// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json/parts.hpp"

namespace stltsa::capi {
namespace {

Json parameters_json(const Denoised& denoised) {
    const double fps = denoised.source.samples.fps;
    const double step = denoised.options.knot_step;
    const PeriodFacts period = in_seconds(denoised.period, denoised.source.samples);
    return JsonObject("gamma", json_or_null(denoised.options.gamma), "knot_rows", step, "knot_s",
                      fps > 0 ? Json(step / fps) : Json(nullptr), "robust", denoised.options.robust,
                      "period_min_s", json_positive_or_null(period.shortest), "period_max_s",
                      json_positive_or_null(period.longest));
}

Json column_json(const motion::DenoisedColumn& column) {
    return JsonObject("gamma", column.gamma, "shift", column.shift, "noise", column.noise,
                      "noise_share", column.noise_share, "degrees_of_freedom",
                      column.degrees_of_freedom, "moved", column.moved);
}

} // namespace

std::string denoising_json(const Denoised& denoised) {
    JsonObject object = json_head("denoising");
    object.set("clip", json_clip(denoised.source));
    JsonObject samples = json_samples(denoised.source.samples);
    samples.set("lengths", denoised.lengths);
    object.set("samples", samples);
    object.set("fit",
               denoised.fit ? json_parameters(*denoised.fit, denoised.source) : Json(nullptr));
    object.set("period_s",
               json_positive_or_null(in_seconds(denoised.period, denoised.source.samples).period));
    object.set("parameters", parameters_json(denoised));
    std::vector<Json> columns;
    for (const motion::DenoisedColumn& column : denoised.result.columns)
        columns.push_back(column_json(column));
    object.set("columns", columns);
    object.set("nothing_to_clean", motion::nothing_to_clean(denoised.result.columns));
    object.set("warnings", json_warnings(denoised.warnings));
    return object.text();
}

} // namespace stltsa::capi
