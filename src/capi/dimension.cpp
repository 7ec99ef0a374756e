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

stltsa_status stltsa_estimate_dimension(const stltsa_in* frames, const stltsa_in* lengths,
                                        const stltsa_options* options,
                                        stltsa_dimension** dimension) noexcept {
    return compute([&] {
        required(dimension, "dimension") = nullptr;
        const capi::InputFrames input(frames, "frames");
        const auto clip_lengths = capi::clip_lengths(lengths, input.view().rows);
        const capi::OptionsReader reader(options);
        const ConstMatrixView x = input.view();
        *dimension = new stltsa_dimension(results::estimate_dimension(
            x, {clip_lengths, clip_lengths}, reader.fit_options(), reader.dimension_options(),
            results::matrix_source(x, reader.real_if_set(STLTSA_OPT_FPS).value_or(0)),
            reader.progress()));
    });
}

stltsa_status stltsa_estimate_dimension_clip(const stltsa_clip* clip, const stltsa_options* options,
                                             stltsa_dimension** dimension) noexcept {
    return stltsa_estimate_dimension_clips(&clip, 1, options, dimension);
}

stltsa_status stltsa_estimate_dimension_clips(const stltsa_clip* const* clips, int64_t count,
                                              const stltsa_options* options,
                                              stltsa_dimension** dimension) noexcept {
    return compute([&] {
        required(dimension, "dimension") = nullptr;
        const auto from = capi::clips_of(clips, count);
        const capi::OptionsReader reader(options);
        auto prepared = results::prepare_clips(from, reader.prepare_options(), reader.progress());
        *dimension = new stltsa_dimension(results::estimate_dimension(
            prepared.samples.view(), prepared.lengths, reader.fit_options(),
            reader.dimension_options(), std::move(prepared.source), reader.progress()));
    });
}

void stltsa_dimension_free(stltsa_dimension* dimension) noexcept {
    delete dimension;
}

int64_t stltsa_dimension_eigengap(const stltsa_dimension* dimension, const char** reason) noexcept {
    if (reason != nullptr)
        *reason = dimension == nullptr ? "" : dimension->dimension.eigengap_reason.c_str();
    return dimension == nullptr ? 0 : dimension->dimension.eigengap;
}

int64_t stltsa_dimension_local_pca(const stltsa_dimension* dimension,
                                   const char** reason) noexcept {
    if (reason != nullptr)
        *reason = dimension == nullptr ? "" : dimension->dimension.local_pca_reason.c_str();
    return dimension == nullptr ? 0 : dimension->dimension.local_pca;
}

stltsa_status stltsa_dimension_eigenvalues(const stltsa_dimension* dimension,
                                           const stltsa_out* values) noexcept {
    return guard([&] {
        capi::write_column(values, "values",
                           required(dimension, "dimension").dimension.eigenvalues);
    });
}

stltsa_status stltsa_dimension_local_variances(const stltsa_dimension* dimension,
                                               const stltsa_out* shares) noexcept {
    return guard([&] {
        capi::write_column(shares, "shares",
                           required(dimension, "dimension").dimension.local_variances);
    });
}

stltsa_status stltsa_dimension_json(const stltsa_dimension* dimension, char** json) noexcept {
    return guard([&] {
        required(json, "json") = nullptr;
        *json = capi::caller_string(capi::dimension_json(required(dimension, "dimension")));
    });
}
