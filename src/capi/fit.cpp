// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

stltsa_status stltsa_fit(const stltsa_in* frames, const stltsa_in* lengths,
                         const stltsa_options* options, stltsa_model** model) noexcept {
    return compute([&] {
        required(model, "model") = nullptr;
        const capi::InputFrames input(frames, "frames");
        const ConstMatrixView x = input.view();
        const auto clip_lengths = capi::clip_lengths(lengths, input.view().rows);
        const capi::OptionsReader reader(options);
        auto fitted =
            results::fit(x, {clip_lengths, clip_lengths}, reader.fit_options(),
                         results::matrix_source(x, reader.real_if_set(STLTSA_OPT_FPS).value_or(0)),
                         reader.progress());
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
    return compute([&] {
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
