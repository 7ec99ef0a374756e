// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/dimension.hpp"

#include <algorithm>
#include <memory>

#include "capi/arrays.hpp"
#include "capi/guard.hpp"
#include "capi/source.hpp"
#include "ltsa/frames.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

std::unique_ptr<stltsa_dimension> estimate_samples(ConstMatrixView samples,
                                                   const std::vector<std::int64_t>& lengths,
                                                   const capi::OptionsReader& options,
                                                   capi::Source source) {
    ltsa::check_frames(samples, lengths, "frames", options.threads());
    auto result = std::make_unique<stltsa_dimension>();
    const auto parameters =
        capi::choose_parameters(samples, lengths, options, ltsa::eigengap_tangents, source);
    result->dimension = ltsa::intrinsic_dimension(samples, lengths, parameters,
                                                  options.dimension_options(), options.progress());
    result->source = std::move(source);
    return result;
}

} // namespace

stltsa_status stltsa_estimate_dimension(const stltsa_in* frames, const stltsa_in* lengths,
                                        const stltsa_options* options,
                                        stltsa_dimension** dimension) noexcept {
    return guard([&] {
        required(dimension, "dimension") = nullptr;
        const capi::InputFrames input(frames, "frames");
        const capi::OptionsReader reader(options);
        *dimension = estimate_samples(input.view(), capi::clip_lengths(lengths, input.view().rows),
                                      reader, capi::matrix_source(input.view(), reader))
                         .release();
    });
}

stltsa_status stltsa_estimate_dimension_clip(const stltsa_clip* clip, const stltsa_options* options,
                                             stltsa_dimension** dimension) noexcept {
    return stltsa_estimate_dimension_clips(&clip, 1, options, dimension);
}

stltsa_status stltsa_estimate_dimension_clips(const stltsa_clip* const* clips, int64_t count,
                                              const stltsa_options* options,
                                              stltsa_dimension** dimension) noexcept {
    return guard([&] {
        required(dimension, "dimension") = nullptr;
        const auto from = capi::clips_of(clips, count);
        const capi::OptionsReader reader(options);
        auto prepared = capi::prepare_clips(from, reader);
        *dimension = estimate_samples(prepared.samples.view(), prepared.lengths, reader,
                                      std::move(prepared.source))
                         .release();
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
        const auto& source = required(dimension, "dimension").source;
        *json = capi::caller_string(capi::dimension_json(
            {source.clip_or_null(), source.samples, source.period, &dimension->dimension}));
    });
}
