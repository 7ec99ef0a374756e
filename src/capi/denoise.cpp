// SPDX-License-Identifier: BSD-3-Clause
#include "motion/denoise.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "capi/arrays.hpp"
#include "capi/guard.hpp"
#include "capi/source.hpp"
#include "ltsa/frames.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

/// The model's period; where none was looked for, that of the longest clip's coordinates.
capi::PeriodFacts period_of(ConstMatrixView coords, const std::vector<std::int64_t>& lengths,
                            const capi::OptionsReader& options, const capi::Source& source) {
    const double fps = source.samples.fps;
    if (!(fps > 0) || source.period.longest > 0)
        return source.period;
    const auto longest = std::max_element(lengths.begin(), lengths.end());
    const std::int64_t first = std::accumulate(lengths.begin(), longest, std::int64_t{0});
    const auto search = options.decompose_options();
    const motion::Period found = motion::find_period(coords.block(first, *longest), fps,
                                                     search.shortest_period, search.longest_period);
    return {found.samples / fps, found.quality, search.shortest_period, search.longest_period};
}

motion::DenoiseOptions choose_options(const capi::OptionsReader& options,
                                      const capi::PeriodFacts& period, double fps) {
    const double spacing = options.real(STLTSA_OPT_KNOT_SPACING);
    motion::DenoiseOptions chosen;
    chosen.gamma = options.real(STLTSA_OPT_GAMMA);
    chosen.robust = options.integer(STLTSA_OPT_ROBUST) != 0;
    chosen.knot_step = spacing > 0
                           ? spacing * (fps > 0 ? fps : 1)
                           : motion::knot_step_for({period.period * fps, period.lag_quality});
    return chosen;
}

std::unique_ptr<stltsa_denoising> denoise(ConstMatrixView coords, std::vector<std::int64_t> lengths,
                                          const capi::OptionsReader& options, capi::Source source) {
    ltsa::check_frames(coords, lengths, "coords");
    auto denoising = std::make_unique<stltsa_denoising>();
    if (!(options.real(STLTSA_OPT_KNOT_SPACING) > 0))
        denoising->period = period_of(coords, lengths, options, source);
    denoising->options = choose_options(options, denoising->period, source.samples.fps);
    denoising->result = motion::denoise(coords, lengths, denoising->options, options.progress());
    denoising->lengths = std::move(lengths);
    denoising->source = std::move(source);
    return denoising;
}

/// Rows of one clip and one component that follow each other: between others the curve breaks off.
std::vector<std::int64_t> pieces_of(const ltsa::Model& model) {
    std::vector<std::int64_t> pieces;
    std::size_t row = 0;
    for (const std::int64_t length : model.lengths)
        for (std::int64_t i = 0; i < length; ++i, ++row) {
            if (i == 0 || model.component_of[row] != model.component_of[row - 1])
                pieces.push_back(0);
            ++pieces.back();
        }
    return pieces;
}

const motion::DenoisedColumn& column_of(const stltsa_denoising& denoising, std::int64_t column) {
    const auto& columns = denoising.result.columns;
    if (column < 0 || column >= static_cast<std::int64_t>(columns.size()))
        fail(Status::argument, "column {} is not in 0 .. {}", column, columns.size() - 1);
    return columns[static_cast<std::size_t>(column)];
}

std::int64_t integer_of(const stltsa_denoising& denoising, int32_t key, std::int64_t column) {
    const motion::DenoisedColumn& found = column_of(denoising, column);
    switch (key) {
    case STLTSA_DENOISING_ROWS:
        return denoising.result.curve.rows();
    case STLTSA_DENOISING_COLUMNS:
        return denoising.result.curve.cols();
    case STLTSA_DENOISING_MOVED:
        return found.moved;
    default:
        fail(Status::argument, "{} is no integer key of a denoising", key);
    }
}

double real_of(const stltsa_denoising& denoising, int32_t key, std::int64_t column) {
    const motion::DenoisedColumn& found = column_of(denoising, column);
    switch (key) {
    case STLTSA_DENOISING_GAMMA:
        return found.gamma;
    case STLTSA_DENOISING_SHIFT:
        return found.shift;
    case STLTSA_DENOISING_NOISE:
        return found.noise;
    case STLTSA_DENOISING_DEGREES_OF_FREEDOM:
        return found.degrees_of_freedom;
    default:
        fail(Status::argument, "{} is no real key of a denoising", key);
    }
}

stltsa_status write_matrix(const stltsa_denoising* denoising, Matrix motion::Denoised::*which,
                           const stltsa_out* out, const char* name) {
    return guard([&] {
        const Matrix& matrix = required(denoising, "denoising").result.*which;
        capi::write_output(out, name, matrix.view());
    });
}

} // namespace

stltsa_status stltsa_denoise(const stltsa_in* coords, const stltsa_in* lengths,
                             const stltsa_options* options, stltsa_denoising** denoising) noexcept {
    return guard([&] {
        required(denoising, "denoising") = nullptr;
        const capi::InputFrames input(coords, "coords");
        const capi::OptionsReader reader(options);
        *denoising = denoise(input.view(), capi::clip_lengths(lengths, input.view().rows), reader,
                             capi::matrix_source(input.view(), reader))
                         .release();
    });
}

stltsa_status stltsa_denoise_model(const stltsa_model* model, const stltsa_options* options,
                                   stltsa_denoising** denoising) noexcept {
    return guard([&] {
        required(denoising, "denoising") = nullptr;
        const stltsa_model& from = required(model, "model");
        auto made = denoise(from.model.coords.view(), pieces_of(from.model),
                            capi::OptionsReader(options), from.source);
        made->fit = from.model.parameters;
        made->warnings = from.model.warnings;
        *denoising = made.release();
    });
}

void stltsa_denoising_free(stltsa_denoising* denoising) noexcept {
    delete denoising;
}

stltsa_status stltsa_denoising_get_int(const stltsa_denoising* denoising, int32_t key,
                                       int64_t column, int64_t* value) noexcept {
    return guard([&] {
        required(value, "value") = integer_of(required(denoising, "denoising"), key, column);
    });
}

stltsa_status stltsa_denoising_get_real(const stltsa_denoising* denoising, int32_t key,
                                        int64_t column, double* value) noexcept {
    return guard(
        [&] { required(value, "value") = real_of(required(denoising, "denoising"), key, column); });
}

stltsa_status stltsa_denoising_curve(const stltsa_denoising* denoising,
                                     const stltsa_out* curve) noexcept {
    return write_matrix(denoising, &motion::Denoised::curve, curve, "curve");
}

stltsa_status stltsa_denoising_cleaned(const stltsa_denoising* denoising,
                                       const stltsa_out* cleaned) noexcept {
    return write_matrix(denoising, &motion::Denoised::cleaned, cleaned, "cleaned");
}

stltsa_status stltsa_denoising_moves(const stltsa_denoising* denoising,
                                     const stltsa_out* moves) noexcept {
    return write_matrix(denoising, &motion::Denoised::moves, moves, "moves");
}

stltsa_status stltsa_denoising_json(const stltsa_denoising* denoising, char** json) noexcept {
    return guard([&] {
        required(json, "json") = nullptr;
        const stltsa_denoising& d = required(denoising, "denoising");
        *json = capi::caller_string(capi::denoising_json(
            {d.source.clip_or_null(), d.source.samples, d.period, d.fit ? &*d.fit : nullptr,
             d.source.period, d.options, d.lengths, &d.result, d.warnings}));
    });
}
