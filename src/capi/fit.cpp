// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

std::int64_t sum_over_components(const stltsa_model& model, std::int64_t ltsa::Component::*field) {
    std::int64_t sum = 0;
    for (const auto& component : model.model.components)
        sum += component.*field;
    return sum;
}

double largest(const stltsa_model& model, double ltsa::Component::*field) {
    double value = 0;
    for (const auto& component : model.model.components)
        value = std::max(value, component.*field);
    return value;
}

double smallest_gap(const stltsa_model& model) {
    double gap = std::numeric_limits<double>::infinity();
    for (const auto& component : model.model.components)
        gap = std::min(gap, component.gap);
    return gap;
}

std::int64_t integer_of(const stltsa_model& model, int32_t key) {
    const auto& parameters = model.model.parameters;
    switch (key) {
    case STLTSA_MODEL_FRAMES:
        return model.model.coords.rows();
    case STLTSA_MODEL_FEATURES:
        return model.model.features;
    case STLTSA_MODEL_DIMENSION:
        return parameters.dimension;
    case STLTSA_MODEL_NEIGHBORS:
        return parameters.neighbors;
    case STLTSA_MODEL_WINDOW:
        return parameters.window;
    case STLTSA_MODEL_MODE:
        return static_cast<std::int64_t>(parameters.mode);
    case STLTSA_MODEL_INCLUDE_SELF:
        return parameters.include_self ? 1 : 0;
    case STLTSA_MODEL_LINKS:
        return parameters.links;
    case STLTSA_MODEL_EXCLUSION:
        return parameters.exclusion;
    case STLTSA_MODEL_COMPONENTS:
        return static_cast<std::int64_t>(model.model.components.size());
    case STLTSA_MODEL_REPEATED:
        return model.model.repeated_frames;
    case STLTSA_MODEL_RANK_DEFICIENT:
        return sum_over_components(model, &ltsa::Component::rank_deficient_windows);
    case STLTSA_MODEL_SOLVES:
        return sum_over_components(model, &ltsa::Component::solves);
    case STLTSA_MODEL_FIRST_FRAME:
        return model.source.samples.first;
    case STLTSA_MODEL_FRAME_STEP:
        return model.source.samples.step;
    default:
        fail(Status::argument, "{} is no integer key of a model", key);
    }
}

double real_of(const stltsa_model& model, int32_t key) {
    switch (key) {
    case STLTSA_MODEL_RESIDUAL:
        return largest(model, &ltsa::Component::residual);
    case STLTSA_MODEL_ERROR_ESTIMATE:
        return largest(model, &ltsa::Component::error_estimate);
    case STLTSA_MODEL_GAP:
        return smallest_gap(model);
    case STLTSA_MODEL_TIME_CORRELATION:
        return model.model.time_correlation;
    case STLTSA_MODEL_FPS:
        return model.source.samples.fps;
    case STLTSA_MODEL_PERIOD:
        return model.source.period.period;
    case STLTSA_MODEL_REACH:
        if (const ltsa::Mapping* mapping = capi::mapping_of(model))
            return mapping->reach();
        return 0;
    default:
        fail(Status::argument, "{} is no real key of a model", key);
    }
}

} // namespace

stltsa_status stltsa_fit(const stltsa_in* frames, const stltsa_in* lengths,
                         const stltsa_options* options, stltsa_model** model) noexcept {
    return guard([&] {
        required(model, "model") = nullptr;
        const capi::InputFrames input(frames, "frames");
        const ConstMatrixView x = input.view();
        const capi::OptionsReader reader(options);
        auto fitted =
            results::fit(x, capi::clip_lengths(lengths, x.rows), reader.fit_options(),
                         results::matrix_source(x, reader.real(STLTSA_OPT_FPS)), reader.progress());
        if (reader.integer(STLTSA_OPT_KEEP_FRAMES) != 0)
            fitted.kept.frames = copied(x);
        *model = new stltsa_model(std::move(fitted));
    });
}

stltsa_status stltsa_fit_clip(const stltsa_clip* clip, const stltsa_options* options,
                              stltsa_model** model) noexcept {
    return stltsa_fit_clips(&clip, 1, options, model);
}

stltsa_status stltsa_fit_clips(const stltsa_clip* const* clips, int64_t count,
                               const stltsa_options* options, stltsa_model** model) noexcept {
    return guard([&] {
        required(model, "model") = nullptr;
        const auto from = capi::clips_of(clips, count);
        const capi::OptionsReader reader(options);
        const auto prepare = reader.prepare_options();
        auto prepared = results::prepare_clips(from, prepare, reader.progress());
        auto fitted = results::fit(prepared.samples.view(), prepared.lengths, reader.fit_options(),
                                   std::move(prepared.source), reader.progress());
        if (reader.integer(STLTSA_OPT_KEEP_FRAMES) != 0) {
            fitted.kept.drop_tpose = prepare.drop_tpose;
            results::keep_clips(fitted, from, std::move(prepared.samples));
        }
        *model = new stltsa_model(std::move(fitted));
    });
}

void stltsa_model_free(stltsa_model* model) noexcept {
    delete model;
}

stltsa_status stltsa_model_get_int(const stltsa_model* model, int32_t key,
                                   int64_t* value) noexcept {
    return guard([&] { required(value, "value") = integer_of(required(model, "model"), key); });
}

stltsa_status stltsa_model_get_real(const stltsa_model* model, int32_t key,
                                    double* value) noexcept {
    return guard([&] { required(value, "value") = real_of(required(model, "model"), key); });
}

stltsa_status stltsa_model_coords(const stltsa_model* model, const stltsa_out* coords) noexcept {
    return guard([&] {
        capi::write_output(coords, "coords", required(model, "model").model.coords.view());
    });
}

stltsa_status stltsa_model_eigenvalues(const stltsa_model* model,
                                       const stltsa_out* values) noexcept {
    return guard([&] {
        const auto& components = required(model, "model").model.components;
        Matrix all(static_cast<std::int64_t>(components.size()),
                   model->model.parameters.dimension + 2);
        for (std::size_t c = 0; c < components.size(); ++c)
            std::copy_n(components[c].eigenvalues.begin(), all.cols(),
                        all.row(static_cast<std::int64_t>(c)));
        capi::write_output(values, "values", all.view());
    });
}

stltsa_status stltsa_model_components(const stltsa_model* model,
                                      const stltsa_out* labels) noexcept {
    return guard([&] {
        const auto& component_of = required(model, "model").model.component_of;
        capi::write_integers(labels, "labels", {component_of.begin(), component_of.end()});
    });
}

int64_t stltsa_model_warning_count(const stltsa_model* model) noexcept {
    return model == nullptr ? 0 : static_cast<int64_t>(model->model.warnings.size());
}

const char* stltsa_model_warning(const stltsa_model* model, int64_t index) noexcept {
    if (index < 0 || index >= stltsa_model_warning_count(model))
        return "";
    return model->model.warnings[static_cast<std::size_t>(index)].text.c_str();
}

stltsa_status stltsa_model_json(const stltsa_model* model, char** json) noexcept {
    return guard([&] {
        required(json, "json") = nullptr;
        *json = capi::caller_string(capi::model_json(required(model, "model")));
    });
}
