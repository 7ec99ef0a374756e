// SPDX-License-Identifier: BSD-3-Clause
#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

stltsa_status stltsa_denoise(const stltsa_in* coords, const stltsa_in* lengths,
                             const stltsa_options* options, stltsa_denoising** denoising) noexcept {
    return compute(options, [&] {
        required(denoising, "denoising") = nullptr;
        const capi::InputFrames input(coords, "coords");
        const ConstMatrixView x = input.view();
        const capi::OptionsReader reader(options);
        *denoising = new stltsa_denoising(results::denoise(
            x, capi::clip_lengths(lengths, x.rows), reader.denoise_options(),
            results::matrix_source(x, reader.real_if_set(STLTSA_OPT_FPS).value_or(0))));
    });
}

stltsa_status stltsa_denoise_model(const stltsa_model* model, const stltsa_options* options,
                                   stltsa_denoising** denoising) noexcept {
    return guard(options, [&] {
        required(denoising, "denoising") = nullptr;
        const stltsa_model& from = required(model, "model");
        const capi::OptionsReader reader(options);
        *denoising = new stltsa_denoising(results::denoise(from, reader.denoise_options()));
    });
}

void stltsa_denoising_free(stltsa_denoising* denoising) noexcept {
    delete denoising;
}
