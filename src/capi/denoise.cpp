// SPDX-License-Identifier: BSD-3-Clause
#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

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
        const ConstMatrixView x = input.view();
        const capi::OptionsReader reader(options);
        *denoising = new stltsa_denoising(results::denoise(
            x, capi::clip_lengths(lengths, x.rows), reader.denoise_options(),
            results::matrix_source(x, reader.real(STLTSA_OPT_FPS)), reader.progress()));
    });
}

stltsa_status stltsa_denoise_model(const stltsa_model* model, const stltsa_options* options,
                                   stltsa_denoising** denoising) noexcept {
    return guard([&] {
        required(denoising, "denoising") = nullptr;
        const stltsa_model& from = required(model, "model");
        const capi::OptionsReader reader(options);
        *denoising = new stltsa_denoising(
            results::denoise(from, reader.denoise_options(), reader.progress()));
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
        *json = capi::caller_string(capi::denoising_json(required(denoising, "denoising")));
    });
}
