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
    return compute(options, [&] {
        required(model, "model") = nullptr;
        const capi::InputFrames input(frames, "frames");
        const ConstMatrixView x = input.view();
        const auto clip_lengths = capi::clip_lengths(lengths, input.view().rows);
        const capi::OptionsReader reader(options);
        auto fitted = results::fit(
            x, {clip_lengths, clip_lengths}, reader.fit_options(), reader.intrinsic_options(),
            results::matrix_source(x, reader.real_if_set(STLTSA_OPT_FPS).value_or(0)));
        if (reader.integer(STLTSA_OPT_KEEP_FRAMES) != 0)
            fitted.kept.frames = copied(x);
        *model = new stltsa_model(std::move(fitted));
    });
}

stltsa_status stltsa_fit_clips(const stltsa_clip* const* clips, int64_t count,
                               const stltsa_options* options, stltsa_model** model) noexcept {
    return compute(options, [&] {
        required(model, "model") = nullptr;
        const auto from = capi::clips_of(clips, count);
        const capi::OptionsReader reader(options);
        const auto prepare = reader.prepare_options();
        auto prepared = results::prepare_clips(from, prepare);
        auto fitted = results::fit(prepared.samples.view(), prepared.lengths, reader.fit_options(),
                                   reader.intrinsic_options(), std::move(prepared.source));
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
